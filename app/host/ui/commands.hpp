#pragma once

#include <array>
#include <span>

#include "app/host/ui/input.hpp"
#include "lessons/text/text.hpp"

/// Commands of keys, buttons and menus. They are in one table, so that the menu, the list of keys and the
/// effect of a key agree.
namespace jw::host {

enum class Command {
    // timeline
    next,
    back,
    play,
    play_motion,
    next_joint,
    previous_joint,
    first,
    last,
    answer,
    faster,
    slower,
    // beside the picture; first the tabs, in the order of Tab
    tab_step,
    tab_experiments,
    tab_plot,
    tab_newton,
    tab_price,
    tab_exercises,
    tab_rest,
    next_tab,
    panel_keys,
    panel_down,
    panel_up,
    text_down,
    text_up,
    next_symbol,
    symbol_before,
    // experiments
    undo,
    redo,
    start_over,
    play_freedom,
    let_go,
    // exercises
    exercise_hint,
    exercise_solution,
    exercise_anew,
    exercise_list,
    // picture
    fit,
    view_front,
    view_back,
    view_left,
    view_right,
    view_top,
    view_bottom,
    view_free,
    turn_left,
    turn_right,
    turn_up,
    turn_down,
    zoom_in,
    zoom_out,
    dark,
    larger_text,
    smaller_text,
    language,
    // lessons and files
    lessons,
    reload,
    save_picture,
    record,
    save_lesson,
    copy_equation,
    copy_matrix,
    copy_matrix_csv,
    save_csv,
    help,
    quit,  // must stay last: the check of the table uses it
};

enum class Group { timeline, panels, experiments, exercises, files, picture };

struct GroupName {
    Group group;
    const char* name;  ///< translated when shown
};
/// In the order of the menu and of the list of keys, whose columns then have about the same height.
inline constexpr std::array kGroups{
    GroupName{Group::timeline, tr_later("Steps")},
    GroupName{Group::panels, tr_later("Beside the picture")},
    GroupName{Group::experiments, tr_later("Experiments")},
    GroupName{Group::exercises, tr_later("Exercises")},
    GroupName{Group::files, tr_later("Lessons and files")},
    GroupName{Group::picture, tr_later("Picture")}};

struct CommandInfo {
    Command command;
    Group group;
    const char* text;      ///< in menus and the list of keys; translated when shown, as are the keys
    const char* keys;      ///< in words: "Right, n"
    Key key = Key::none;   ///< without Ctrl
    char character = 0;    ///< typed, in any keyboard layout
    Key ctrl = Key::none;  ///< with Ctrl
};

std::span<const CommandInfo> command_table();
const CommandInfo& info_of(Command command);

/// Command of a key or a typed character; nullptr if it has none.
/// @param ctrl  true if Ctrl is held down
const CommandInfo* command_for(const InputEvent& event, bool ctrl);

}  // namespace jw::host
