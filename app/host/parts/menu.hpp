#pragma once

#include "app/host/ui/ui.hpp"

namespace jw::host {

/// Menu of all commands with their keys, opened by ImGui::OpenPopup("menu").
void menu(const LessonUi& ui);

/// The list of keys and mouse actions, over everything.
void help_overlay(const Ui& ui, const panels::Box& window);

}  // namespace jw::host
