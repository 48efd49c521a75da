#pragma once

#include "app/exercises/practice/lesson_exercises.hpp"
#include "app/exercises/practice/progress.hpp"
#include "app/host/lesson/catalogue.hpp"
#include "app/host/ui/ui.hpp"

/// The lessons as cards by chapter, with a search.
namespace jw::host {

/// @param progress  of the exercises that the cards count
/// @param has_lesson  a lesson is open, so there is a way back to it
void browser(
    const Ui& ui, const WindowLayout& window, LessonList& shelf, const Progress& progress, bool has_lesson);

/// Handles keys and letters while the lessons are shown.
/// @return whether the event was for the browser
bool act_in_browser(const InputEvent& event, LessonList& shelf, Requests& requests);

}  // namespace jw::host
