#include "app/host/ui/commands.hpp"

#include <algorithm>
#include <array>

#include "app/session/wording/messages.hpp"

namespace jw::host {

namespace {

constexpr std::array kCommands{
    CommandInfo{Command::next, Group::timeline, tr_later("Next step"), tr_later("Right, n"), Key::right, 'n'},
    CommandInfo{Command::back, Group::timeline, tr_later("Step back"), tr_later("Left, b"), Key::left, 'b'},
    CommandInfo{Command::play, Group::timeline, tr_later("Play or pause"), tr_later("Space"), Key::space},
    CommandInfo{Command::play_motion, Group::timeline, tr_later("Play the motion only"), "M", Key::none, 'M'},
    CommandInfo{
        Command::next_joint, Group::timeline, tr_later("Next joint or driver"), tr_later("Page down"),
        Key::page_down},
    CommandInfo{
        Command::previous_joint, Group::timeline, tr_later("Previous joint or driver"), tr_later("Page up"),
        Key::page_up},
    CommandInfo{
        Command::first, Group::timeline, tr_later("First step (restart)"), tr_later("Home"), Key::home},
    CommandInfo{Command::last, Group::timeline, tr_later("Last step"), tr_later("End"), Key::end},
    CommandInfo{Command::answer, Group::timeline, tr_later("Answer the question"), "a", Key::none, 'a'},
    CommandInfo{Command::faster, Group::timeline, tr_later("Faster"), ".", Key::none, '.'},
    CommandInfo{Command::slower, Group::timeline, tr_later("Slower"), ",", Key::none, ','},

    CommandInfo{
        Command::tab_step, Group::panels, tr_later("This step: equations, Φq, rank"), "1", Key::none, '1'},
    CommandInfo{
        Command::tab_experiments, Group::panels, tr_later("Try it: change the lesson"), "2", Key::none, '2'},
    CommandInfo{Command::tab_plot, Group::panels, tr_later("Plots"), "3", Key::none, '3'},
    CommandInfo{
        Command::tab_newton, Group::panels, tr_later("Newton-Raphson, compared"), "4", Key::none, '4'},
    CommandInfo{
        Command::tab_price, Group::panels, tr_later("Cost: speed against error"), "5", Key::none, '5'},
    CommandInfo{
        Command::tab_exercises, Group::panels, tr_later("Exercises of this lesson"), "6", Key::none, '6'},
    CommandInfo{Command::next_tab, Group::panels, tr_later("Next tab"), tr_later("Tab"), Key::tab},
    CommandInfo{
        Command::panel_keys, Group::panels, tr_later("Arrows move in the panel"), "w", Key::none, 'w'},
    CommandInfo{Command::panel_down, Group::panels, tr_later("Scroll the panel down"), "]", Key::none, ']'},
    CommandInfo{Command::panel_up, Group::panels, tr_later("Scroll the panel up"), "[", Key::none, '['},
    CommandInfo{Command::text_down, Group::panels, tr_later("Scroll the text down"), "}", Key::none, '}'},
    CommandInfo{Command::text_up, Group::panels, tr_later("Scroll the text up"), "{", Key::none, '{'},
    CommandInfo{
        Command::next_symbol, Group::panels, tr_later("Next symbol in the text"), "t", Key::none, 't'},
    CommandInfo{
        Command::symbol_before, Group::panels, tr_later("Previous symbol in the text"), "T", Key::none, 'T'},

    CommandInfo{Command::undo, Group::experiments, tr_later("Undo"), "Ctrl+Z, u", Key::none, 'u', Key::z},
    CommandInfo{Command::redo, Group::experiments, tr_later("Redo"), "Ctrl+Y, U", Key::none, 'U', Key::y},
    CommandInfo{Command::start_over, Group::experiments, tr_later("Reset the lesson"), "0", Key::none, '0'},
    CommandInfo{
        Command::play_freedom, Group::experiments, tr_later("Move along the next free motion"), "m",
        Key::none, 'm'},
    CommandInfo{
        Command::let_go, Group::experiments, tr_later("Back to the step"), tr_later("Escape"), Key::escape},

    CommandInfo{Command::exercise_hint, Group::exercises, tr_later("One more hint"), "H", Key::none, 'H'},
    CommandInfo{
        Command::exercise_solution, Group::exercises, tr_later("Show the solution"), "S", Key::none, 'S'},
    CommandInfo{
        Command::exercise_anew, Group::exercises, tr_later("The same with new numbers"), "N", Key::none, 'N'},
    CommandInfo{
        Command::exercise_list, Group::exercises, tr_later("Back to the list of exercises"), "L", Key::none,
        'L'},

    CommandInfo{Command::fit, Group::picture, tr_later("Fit the picture"), "f", Key::none, 'f'},
    CommandInfo{Command::view_front, Group::picture, tr_later("From the front"), "y", Key::none, 'y'},
    CommandInfo{Command::view_back, Group::picture, tr_later("From behind"), "Y", Key::none, 'Y'},
    CommandInfo{Command::view_right, Group::picture, tr_later("From the right"), "x", Key::none, 'x'},
    CommandInfo{Command::view_left, Group::picture, tr_later("From the left"), "X", Key::none, 'X'},
    CommandInfo{Command::view_top, Group::picture, tr_later("From above"), "z", Key::none, 'z'},
    CommandInfo{Command::view_bottom, Group::picture, tr_later("From below"), "Z", Key::none, 'Z'},
    CommandInfo{Command::view_free, Group::picture, tr_later("Three-quarter view"), "v", Key::none, 'v'},
    CommandInfo{Command::turn_left, Group::picture, tr_later("Turn to the left"), "h", Key::none, 'h'},
    CommandInfo{Command::turn_right, Group::picture, tr_later("Turn to the right"), "l", Key::none, 'l'},
    CommandInfo{Command::turn_up, Group::picture, tr_later("Turn up"), tr_later("k, Up"), Key::up, 'k'},
    CommandInfo{
        Command::turn_down, Group::picture, tr_later("Turn down"), tr_later("j, Down"), Key::down, 'j'},
    CommandInfo{Command::zoom_in, Group::picture, tr_later("Zoom in"), "i", Key::none, 'i'},
    CommandInfo{Command::zoom_out, Group::picture, tr_later("Zoom out"), "o", Key::none, 'o'},
    CommandInfo{Command::dark, Group::picture, tr_later("Light or dark"), "d", Key::none, 'd'},
    CommandInfo{Command::larger_text, Group::picture, tr_later("Larger text"), "+", Key::none, '+'},
    CommandInfo{Command::smaller_text, Group::picture, tr_later("Smaller text"), "-", Key::none, '-'},
    CommandInfo{Command::language, Group::picture, tr_later("Next language"), "G", Key::none, 'G'},

    CommandInfo{Command::lessons, Group::files, tr_later("Lessons"), "Ctrl+O, g", Key::none, 'g', Key::o},
    CommandInfo{Command::reload, Group::files, tr_later("Reload the file"), "F5", Key::f5},
    CommandInfo{Command::save_picture, Group::files, tr_later("Save a picture"), "p", Key::none, 'p'},
    CommandInfo{Command::record, Group::files, tr_later("Record from here as pictures"), "R", Key::none, 'R'},
    CommandInfo{
        Command::save_lesson, Group::files, tr_later("Save what you see as a lesson"), "Ctrl+S, s", Key::none,
        's', Key::s},
    CommandInfo{
        Command::copy_equation, Group::files, tr_later("Copy the equations as LaTeX"), "e", Key::none, 'e'},
    CommandInfo{
        Command::copy_matrix, Group::files, tr_later("Copy the matrix as LaTeX"), "c", Key::none, 'c'},
    CommandInfo{
        Command::copy_matrix_csv, Group::files, tr_later("Copy the matrix as CSV"), "C", Key::none, 'C'},
    CommandInfo{
        Command::save_csv, Group::files, tr_later("Save the plot's numbers as CSV"), "E", Key::none, 'E'},
    CommandInfo{Command::help, Group::files, tr_later("Keys"), "?, F1", Key::f1, '?'},
    CommandInfo{Command::quit, Group::files, tr_later("Close"), "Ctrl+Q", Key::none, 0, Key::q},
};
static_assert(kCommands.size() == static_cast<std::size_t>(Command::quit) + 1, "a command without an entry");

}  // namespace

std::span<const CommandInfo> command_table() { return kCommands; }

const CommandInfo& info_of(Command command) {
    return *std::ranges::find(kCommands, command, &CommandInfo::command);
}

const char* name_of(Group group) {
    switch (group) {
        case Group::timeline: return tr("Steps");
        case Group::panels: return tr("Beside the picture");
        case Group::experiments: return tr("Experiments");
        case Group::exercises: return tr("Exercises");
        case Group::files: return tr("Lessons and files");
        case Group::picture: break;
    }
    return tr("Picture");
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
