#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/host/lesson/playback.hpp"
#include "app/host/lesson/shown_picture.hpp"
#include "app/host/ui/commands.hpp"
#include "app/panels/frame/frame.hpp"
#include "app/panels/parts/canvas.hpp"
#include "app/session/try/session.hpp"
#include "lessons/enum_words.hpp"

/// Values shared by the parts of the interface: what they see and what they request. Nothing changes while a
/// frame is drawn; the host carries out the requests afterwards.
namespace jw::host {

enum class Tab { step, experiments, plot, newton, price, exercises };
inline constexpr std::array kTabs{
    EnumWord<Tab>{Tab::step, "step", tr_later("Step")},
    EnumWord<Tab>{Tab::experiments, "try", tr_later("Try it")},
    EnumWord<Tab>{Tab::plot, "plots", tr_later("Plots")},
    EnumWord<Tab>{Tab::newton, "newton", tr_later("Newton")},
    EnumWord<Tab>{Tab::price, "price", tr_later("Price")},
    EnumWord<Tab>{Tab::exercises, "exercises", tr_later("Exercises")}};

/// How far a part of the window is scrolled.
struct Scroll {
    float offset = 0.0F;  ///< pixels above it
    float most = 0.0F;    ///< largest offset; 0: all of it is in sight
    float wanted = 0.0F;  ///< by a command, in parts of its height; taken at the next frame
    bool held = false;    ///< the pointer drags its bar
};

/// State of the screen beyond the lesson itself.
struct UiState {
    Tab tab = Tab::step;
    bool browser = false;  ///< the lessons instead of a lesson
    bool help = false;     ///< the list of keys over everything
    bool dark = false;
    float text_scale = 1.0F;
    bool has_disk = true;  ///< other programs see the files that are written: their paths are told
    std::vector<Command> not_offered;  ///< neither in the menu nor in the list of keys

    Pointable pointed_at;       ///< what the pointer is over, in panels or in 3D
    int symbol = -1;            ///< of the caption, chosen by the keyboard; -1: none
    std::vector<int> lit_rows;  ///< of the system: lit together, whatever is pointed at
    Lit lit() const { return {pointed_at || symbol < 0 ? pointed_at : Pointable::symbol(symbol), lit_rows}; }
    /// Another lesson follows, or the lesson as it was changed: what was pointed at need not be there.
    void forget_pointed() {
        pointed_at = {};
        symbol = -1;
        lit_rows.clear();
    }

    Scroll column;           ///< of the step's panels
    Scroll caption;          ///< of the words below the picture
    Scroll sheet;            ///< of the list of keys: `wanted` only
    int scrolled_step = -1;  ///< the step that column and caption are scrolled at

    bool panel_keys = false;  ///< the keyboard moves among the widgets of the panel

    Playback playback;

    int experiment_joint = -1;  ///< chosen in "Try it"; -1: the joint of the step
    int experiment_driver = 0;
};

/// Requests of one frame.
struct Requests {
    std::vector<Experiment> experiments;
    std::vector<Command> commands;
    std::optional<std::string> open;     ///< lesson file
    std::optional<int> trial;            ///< of the lesson: to be carried out
    std::optional<std::string> copy;     ///< text for the clipboard
    std::optional<int> show_joint;       ///< its vectors and equations, while everything moves
    std::vector<int> lit_rows;           ///< for the next frame
    std::optional<int> exercise;         ///< of the lesson: to be begun
    std::optional<std::string> answer;   ///< to the exercise: to be judged
    std::optional<std::string> starter;  ///< file of a program to begin with: to be written

    void add(const Experiment& experiment) { experiments.push_back(experiment); }
    void add(Command command) { commands.push_back(command); }
};

/// Everything that a part of the interface works with.
struct Ui {
    UiState& state;
    const panels::Canvas& canvas;
    Requests& requests;

    float px(float at_720) const { return canvas.px(at_720); }
};

/// Everything that a part of the interface works with while a lesson is open.
struct LessonUi : Ui {
    const Session& session;
    const render::Camera& camera;

    LessonUi(const Ui& ui, const Session& open, const render::Camera& seen_by)
        : Ui(ui), session(open), camera(seen_by) {}
};

}  // namespace jw::host
