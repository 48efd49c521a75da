#pragma once

#include "app/host/ui/ui.hpp"

namespace jw::host {

/// Every command with its keys; opened by ImGui::OpenPopup("menu").
void menu(const LessonUi& ui);

/// The list of keys and what the mouse does, over everything.
void help_overlay(const Ui& ui, const panels::Box& window);

}  // namespace jw::host
