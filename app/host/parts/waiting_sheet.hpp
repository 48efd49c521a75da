#pragma once

#include "app/host/ui/ui.hpp"

namespace jw::host {

/// Words for what goes on meanwhile.
const char* words_of_waiting();

/// A sheet in the middle of `room`: how much of a long story is told, and a button to give it up.
/// @return true if that was pressed
bool waiting_sheet(const Ui& ui, const panels::Box& room, double part);

}  // namespace jw::host
