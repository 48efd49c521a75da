#pragma once

#include "app/host/lesson/catalogue.hpp"
#include "app/host/ui/ui.hpp"

/// The lessons as cards by chapter, with a search.
namespace jw::host {

/// @param present  the lesson that is open, if any: there is a way back to it
void browser(
    const Ui& ui, const panels::Box& window, const std::vector<CatalogueEntry>& entries, bool has_lesson);

/// Moves the choice by `by` among what the search shows.
void move_choice(UiState& state, const std::vector<CatalogueEntry>& entries, int by);

}  // namespace jw::host
