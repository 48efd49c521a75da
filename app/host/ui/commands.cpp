#include "app/host/ui/commands.hpp"

#include <algorithm>
#include <array>

#include "app/session/wording/messages.hpp"

namespace jw::host {

namespace {

constexpr auto kCommands = [] {
    using enum Command;
    return std::to_array<CommandInfo>({
        {next, Group::timeline, tr_later("Next step"), tr_later("Right, n"), Key::right, 'n'},
        {back, Group::timeline, tr_later("Step back"), tr_later("Left, b"), Key::left, 'b'},
        {play, Group::timeline, tr_later("Play or pause"), tr_later("Space"), Key::space},
        {play_motion, Group::timeline, tr_later("Play the motion only"), "M", Key::none, 'M'},
        {next_joint, Group::timeline, tr_later("Next joint or driver"), tr_later("Page down"),
         Key::page_down},
        {previous_joint, Group::timeline, tr_later("Previous joint or driver"), tr_later("Page up"),
         Key::page_up},
        {first, Group::timeline, tr_later("First step (restart)"), tr_later("Home"), Key::home},
        {last, Group::timeline, tr_later("Last step"), tr_later("End"), Key::end},
        {answer, Group::timeline, tr_later("Answer the question"), "a", Key::none, 'a'},
        {faster, Group::timeline, tr_later("Faster"), ".", Key::none, '.'},
        {slower, Group::timeline, tr_later("Slower"), ",", Key::none, ','},

        {tab_step, Group::panels, tr_later("This step: equations, Φq, rank"), "1", Key::none, '1'},
        {tab_experiments, Group::panels, tr_later("Try it: change the lesson"), "2", Key::none, '2'},
        {tab_plot, Group::panels, tr_later("Plots"), "3", Key::none, '3'},
        {tab_newton, Group::panels, tr_later("Newton-Raphson, compared"), "4", Key::none, '4'},
        {tab_price, Group::panels, tr_later("Cost: speed against error"), "5", Key::none, '5'},
        {tab_exercises, Group::panels, tr_later("Exercises of this lesson"), "6", Key::none, '6'},
        {tab_rest, Group::panels, tr_later("At rest: equilibrium and small motions"), "7", Key::none, '7'},
        {next_tab, Group::panels, tr_later("Next tab"), tr_later("Tab"), Key::tab},
        {panel_keys, Group::panels, tr_later("Arrows move in the panel"), "w", Key::none, 'w'},
        {panel_down, Group::panels, tr_later("Scroll the panel down"), "]", Key::none, ']'},
        {panel_up, Group::panels, tr_later("Scroll the panel up"), "[", Key::none, '['},
        {text_down, Group::panels, tr_later("Scroll the text down"), "}", Key::none, '}'},
        {text_up, Group::panels, tr_later("Scroll the text up"), "{", Key::none, '{'},
        {next_symbol, Group::panels, tr_later("Next symbol in the text"), "t", Key::none, 't'},
        {symbol_before, Group::panels, tr_later("Previous symbol in the text"), "T", Key::none, 'T'},

        {undo, Group::experiments, tr_later("Undo"), "Ctrl+Z, u", Key::none, 'u', Key::z},
        {redo, Group::experiments, tr_later("Redo"), "Ctrl+Y, U", Key::none, 'U', Key::y},
        {start_over, Group::experiments, tr_later("Reset the lesson"), "0", Key::none, '0'},
        {play_freedom, Group::experiments, tr_later("Move along the next free motion"), "m", Key::none, 'm'},
        {let_go, Group::experiments, tr_later("Back to the step"), tr_later("Escape"), Key::escape},

        {exercise_hint, Group::exercises, tr_later("One more hint"), "H", Key::none, 'H'},
        {exercise_solution, Group::exercises, tr_later("Show the solution"), "S", Key::none, 'S'},
        {exercise_anew, Group::exercises, tr_later("The same with new numbers"), "N", Key::none, 'N'},
        {exercise_list, Group::exercises, tr_later("Back to the list of exercises"), "L", Key::none, 'L'},

        {fit, Group::picture, tr_later("Fit the picture"), "f", Key::none, 'f'},
        {view_front, Group::picture, tr_later("From the front"), "y", Key::none, 'y'},
        {view_back, Group::picture, tr_later("From behind"), "Y", Key::none, 'Y'},
        {view_right, Group::picture, tr_later("From the right"), "x", Key::none, 'x'},
        {view_left, Group::picture, tr_later("From the left"), "X", Key::none, 'X'},
        {view_top, Group::picture, tr_later("From above"), "z", Key::none, 'z'},
        {view_bottom, Group::picture, tr_later("From below"), "Z", Key::none, 'Z'},
        {view_free, Group::picture, tr_later("Three-quarter view"), "v", Key::none, 'v'},
        {turn_left, Group::picture, tr_later("Turn to the left"), "h", Key::none, 'h'},
        {turn_right, Group::picture, tr_later("Turn to the right"), "l", Key::none, 'l'},
        {turn_up, Group::picture, tr_later("Turn up"), tr_later("k, Up"), Key::up, 'k'},
        {turn_down, Group::picture, tr_later("Turn down"), tr_later("j, Down"), Key::down, 'j'},
        {zoom_in, Group::picture, tr_later("Zoom in"), "i", Key::none, 'i'},
        {zoom_out, Group::picture, tr_later("Zoom out"), "o", Key::none, 'o'},
        {dark, Group::picture, tr_later("Light or dark"), "d", Key::none, 'd'},
        {larger_text, Group::picture, tr_later("Larger text"), "+", Key::none, '+'},
        {smaller_text, Group::picture, tr_later("Smaller text"), "-", Key::none, '-'},
        {language, Group::picture, tr_later("Next language"), "G", Key::none, 'G'},

        {lessons, Group::files, tr_later("Lessons"), "Ctrl+O, g", Key::none, 'g', Key::o},
        {reload, Group::files, tr_later("Reload the file"), "F5", Key::f5},
        {save_picture, Group::files, tr_later("Save a picture"), "p", Key::none, 'p'},
        {record, Group::files, tr_later("Record from here as pictures"), "R", Key::none, 'R'},
        {save_lesson, Group::files, tr_later("Save what you see as a lesson"), "Ctrl+S, s", Key::none, 's',
         Key::s},
        {copy_equation, Group::files, tr_later("Copy the equations as LaTeX"), "e", Key::none, 'e'},
        {copy_matrix, Group::files, tr_later("Copy the matrix as LaTeX"), "c", Key::none, 'c'},
        {copy_matrix_csv, Group::files, tr_later("Copy the matrix as CSV"), "C", Key::none, 'C'},
        {save_csv, Group::files, tr_later("Save the plot's numbers as CSV"), "E", Key::none, 'E'},
        {help, Group::files, tr_later("Keys"), "?, F1", Key::f1, '?'},
        {quit, Group::files, tr_later("Close"), "Ctrl+Q", Key::none, 0, Key::q},
    });
}();
static_assert(kCommands.size() == static_cast<std::size_t>(Command::quit) + 1, "a command without an entry");

}  // namespace

std::span<const CommandInfo> command_table() { return kCommands; }

const CommandInfo& info_of(Command command) {
    return *std::ranges::find(kCommands, command, &CommandInfo::command);
}

const CommandInfo* command_for(const InputEvent& event, bool ctrl) {
    const auto fits = [&](const CommandInfo& c) {
        if (event.kind == InputEvent::Kind::text) {
            return !ctrl && c.character != 0 &&
                   event.character == static_cast<unsigned>(static_cast<unsigned char>(c.character));
        }
        if (event.kind != InputEvent::Kind::key || !event.down || event.key == Key::none) { return false; }
        return event.key == (ctrl ? c.ctrl : c.key);
    };
    const auto* const found = std::ranges::find_if(kCommands, fits);
    return found == kCommands.end() ? nullptr : found;
}

}  // namespace jw::host
