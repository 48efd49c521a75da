#pragma once

#include <initializer_list>
#include <string>
#include <variant>
#include <vector>

#include "tests/app/host/person.hpp"

/// Finds what can be clicked, as ImGui sees it: moves the pointer about and asks what is under it.
namespace jw::test {

/// A widget, and a place where the pointer is over it.
struct Widget {
    unsigned id = 0;
    float x = 0.0F;
    float y = 0.0F;
};

/// Widgets that can be clicked in a part of the window now, each once, from top to bottom.
std::vector<Widget> widgets_in(Person& person, const panels::Box& box);
/// Widgets of a column that scrolls, all the way down; it is left scrolled to `notches` of the wheel.
std::vector<Widget> widgets_at(Person& person, const panels::Box& column, int notches);

/// Distance that the column can be scrolled, in notches of the wheel.
int notches_of(Person& person, const char* window);
void scroll_to(Person& person, const panels::Box& column, int notches);

/// ID of a widget from its window and from what is pushed before its label, as in the code that draws it.
unsigned id_of(const char* window, std::initializer_list<std::variant<std::string, int>> path);

/// Finds a widget of the column and scrolls it into sight.
/// @throws std::runtime_error if it is not there
Widget find(Person& person, const char* window, std::initializer_list<std::variant<std::string, int>> path);

/// The list that is open (of a combo or a menu), if any: the last one opened.
const panels::Box* open_popup(panels::Box& box);

}  // namespace jw::test
