#include "app/host/ui/commands.hpp"

#include <algorithm>
#include <array>

namespace jw::host {

namespace {

constexpr std::array kCommands{
    CommandInfo{Command::next, Group::timeline, "Next step", "Right, n", Key::right, 'n'},
    CommandInfo{Command::back, Group::timeline, "Step back", "Left, b", Key::left, 'b'},
    CommandInfo{Command::play, Group::timeline, "Play or pause", "Space", Key::space},
    CommandInfo{Command::play_motion, Group::timeline, "Play the motion only", "M", Key::none, 'M'},
    CommandInfo{Command::next_joint, Group::timeline, "Next joint or driver", "Page down", Key::page_down},
    CommandInfo{Command::previous_joint, Group::timeline, "Joint or driver before", "Page up", Key::page_up},
    CommandInfo{Command::first, Group::timeline, "First step (restart)", "Home", Key::home},
    CommandInfo{Command::last, Group::timeline, "Last step", "End", Key::end},
    CommandInfo{Command::answer, Group::timeline, "Answer the question", "a", Key::none, 'a'},
    CommandInfo{Command::faster, Group::timeline, "Faster", ".", Key::none, '.'},
    CommandInfo{Command::slower, Group::timeline, "Slower", ",", Key::none, ','},

    CommandInfo{Command::tab_step, Group::panels, "This step: equations, Φq, rank", "1", Key::none, '1'},
    CommandInfo{Command::tab_experiments, Group::panels, "Try it: change the lesson", "2", Key::none, '2'},
    CommandInfo{Command::tab_plot, Group::panels, "Plots", "3", Key::none, '3'},
    CommandInfo{Command::tab_newton, Group::panels, "Newton-Raphson, compared", "4", Key::none, '4'},
    CommandInfo{Command::tab_price, Group::panels, "Price: what a digit costs", "5", Key::none, '5'},
    CommandInfo{Command::tab_exercises, Group::panels, "Exercises of this lesson", "6", Key::none, '6'},
    CommandInfo{Command::next_tab, Group::panels, "Next of these", "Tab", Key::tab},
    CommandInfo{Command::panel_keys, Group::panels, "Arrows move in the panel", "w", Key::none, 'w'},
    CommandInfo{Command::panel_down, Group::panels, "Scroll the panel down", "]", Key::none, ']'},
    CommandInfo{Command::panel_up, Group::panels, "Scroll the panel up", "[", Key::none, '['},
    CommandInfo{Command::text_down, Group::panels, "Scroll the text down", "}", Key::none, '}'},
    CommandInfo{Command::text_up, Group::panels, "Scroll the text up", "{", Key::none, '{'},

    CommandInfo{Command::undo, Group::experiments, "Undo", "Ctrl+Z, u", Key::none, 'u', Key::z},
    CommandInfo{Command::redo, Group::experiments, "Do again", "Ctrl+Y, U", Key::none, 'U', Key::y},
    CommandInfo{Command::start_over, Group::experiments, "The lesson as it was written", "0", Key::none, '0'},
    CommandInfo{
        Command::play_freedom, Group::experiments, "Move along the next free motion", "m", Key::none, 'm'},
    CommandInfo{Command::let_go, Group::experiments, "Back to the step", "Escape", Key::escape},

    CommandInfo{Command::exercise_hint, Group::exercises, "One more hint", "H", Key::none, 'H'},
    CommandInfo{Command::exercise_solution, Group::exercises, "Show the solution", "S", Key::none, 'S'},
    CommandInfo{Command::exercise_anew, Group::exercises, "The same with new numbers", "N", Key::none, 'N'},
    CommandInfo{
        Command::exercise_list, Group::exercises, "Back to the list of exercises", "L", Key::none, 'L'},

    CommandInfo{Command::fit, Group::picture, "Fit the picture", "f", Key::none, 'f'},
    CommandInfo{Command::view_front, Group::picture, "From the front", "y", Key::none, 'y'},
    CommandInfo{Command::view_back, Group::picture, "From behind", "Y", Key::none, 'Y'},
    CommandInfo{Command::view_right, Group::picture, "From the right", "x", Key::none, 'x'},
    CommandInfo{Command::view_left, Group::picture, "From the left", "X", Key::none, 'X'},
    CommandInfo{Command::view_top, Group::picture, "From above", "z", Key::none, 'z'},
    CommandInfo{Command::view_bottom, Group::picture, "From below", "Z", Key::none, 'Z'},
    CommandInfo{Command::view_free, Group::picture, "Three-quarter view", "v", Key::none, 'v'},
    CommandInfo{Command::turn_left, Group::picture, "Turn to the left", "h", Key::none, 'h'},
    CommandInfo{Command::turn_right, Group::picture, "Turn to the right", "l", Key::none, 'l'},
    CommandInfo{Command::turn_up, Group::picture, "Turn up", "k, Up", Key::up, 'k'},
    CommandInfo{Command::turn_down, Group::picture, "Turn down", "j, Down", Key::down, 'j'},
    CommandInfo{Command::zoom_in, Group::picture, "Nearer", "i", Key::none, 'i'},
    CommandInfo{Command::zoom_out, Group::picture, "Farther", "o", Key::none, 'o'},
    CommandInfo{Command::dark, Group::picture, "Light or dark", "d", Key::none, 'd'},
    CommandInfo{Command::larger_text, Group::picture, "Larger text", "+", Key::none, '+'},
    CommandInfo{Command::smaller_text, Group::picture, "Smaller text", "-", Key::none, '-'},

    CommandInfo{Command::lessons, Group::files, "Lessons", "Ctrl+O, g", Key::none, 'g', Key::o},
    CommandInfo{Command::reload, Group::files, "Read the file again", "F5", Key::f5},
    CommandInfo{Command::save_picture, Group::files, "Save a picture", "p", Key::none, 'p'},
    CommandInfo{Command::record, Group::files, "Record from here as pictures", "R", Key::none, 'R'},
    CommandInfo{
        Command::save_lesson, Group::files, "Save what you see as a lesson", "Ctrl+S, s", Key::none, 's',
        Key::s},
    CommandInfo{Command::copy_equation, Group::files, "Copy the equations as LaTeX", "e", Key::none, 'e'},
    CommandInfo{Command::copy_matrix, Group::files, "Copy the matrix as LaTeX", "c", Key::none, 'c'},
    CommandInfo{Command::copy_matrix_csv, Group::files, "Copy the matrix as CSV", "C", Key::none, 'C'},
    CommandInfo{Command::save_csv, Group::files, "Save the plot's numbers as CSV", "E", Key::none, 'E'},
    CommandInfo{Command::help, Group::files, "Keys", "?, F1", Key::f1, '?'},
    CommandInfo{Command::quit, Group::files, "Close", "Ctrl+Q", Key::none, 0, Key::q},
};
static_assert(kCommands.size() == static_cast<std::size_t>(Command::quit) + 1, "a command without an entry");

}  // namespace

std::span<const CommandInfo> command_table() { return kCommands; }

const CommandInfo& info_of(Command command) {
    return *std::ranges::find(kCommands, command, &CommandInfo::command);
}

const char* name_of(Group group) {
    switch (group) {
        case Group::timeline: return "Steps";
        case Group::panels: return "Beside the picture";
        case Group::experiments: return "Experiments";
        case Group::exercises: return "Exercises";
        case Group::picture: return "Picture";
        case Group::files: break;
    }
    return "Lessons and files";
}

const CommandInfo* command_for(const InputEvent& event, const Modifiers& modifiers) {
    const auto fits = [&](const CommandInfo& c) {
        if (event.kind == InputEvent::Kind::text) {
            return !modifiers.ctrl && c.character != 0 &&
                   event.character == static_cast<unsigned>(static_cast<unsigned char>(c.character));
        }
        if (event.kind != InputEvent::Kind::key || !event.down || event.key == Key::none) { return false; }
        return event.key == (modifiers.ctrl ? c.ctrl : c.key);
    };
    const auto* const found = std::ranges::find_if(kCommands, fits);
    return found == kCommands.end() ? nullptr : found;
}

}  // namespace jw::host
