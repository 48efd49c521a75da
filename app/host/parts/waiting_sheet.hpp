#pragma once

#include "app/host/ui/ui.hpp"

namespace jw::host {

/// Words that describe the computation.
const char* words_of_waiting();

/// A sheet in the middle of `room`, with the progress of a long computation and a button to cancel it.
/// @return true if the button was pressed
bool waiting_sheet(const Ui& ui, const panels::Box& room, double part);

}  // namespace jw::host
