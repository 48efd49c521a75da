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
#include "lessons/lesson/enum_words.hpp"

/// Values shared by the parts of the interface: the state that they see and their requests. Nothing changes
/// while a frame is drawn; the host carries out the requests afterwards.
namespace jw::host {

enum class Tab { step, experiments, plot, newton, price, exercises, rest };
inline constexpr std::array kTabs{
    EnumWord<Tab>{Tab::step, "step", tr_later("Step")},
    EnumWord<Tab>{Tab::experiments, "try", tr_later("Try it")},
    EnumWord<Tab>{Tab::plot, "plots", tr_later("Plots")},
    EnumWord<Tab>{Tab::newton, "newton", tr_later("Newton")},
    EnumWord<Tab>{Tab::price, "price", tr_later("Cost")},
    EnumWord<Tab>{Tab::exercises, "exercises", tr_later("Exercises")},
    EnumWord<Tab>{Tab::rest, "rest", tr_later("At rest")}};

/// The command that shows a tab: the two enumerations have the same order.
constexpr Command command_of(Tab tab) {
    return static_cast<Command>(static_cast<int>(Command::tab_step) + static_cast<int>(tab));
}
static_assert(command_of(kTabs.back().value) == Command::tab_rest);

/// True if a lesson has a tab: without [dynamics], nothing comes to rest. That tab is the last one, so that
/// the others have the same places in all lessons.
inline bool has_tab(const Lesson& lesson, Tab tab) { return tab != Tab::rest || lesson.dynamics.has_value(); }

/// The parts of the window: a frame of panels with tabs above its column, and the timeline below.
struct WindowLayout : panels::FrameLayout {
    int width = 0;  ///< pixels of the framebuffer
    int height = 0;
    float density = 0.0F;  ///< of the screen, see panels::Looking
    panels::Box whole;
};

/// How far a part of the window is scrolled.
struct Scroll {
    float offset = 0.0F;  ///< pixels hidden above
    float most = 0.0F;    ///< largest offset; 0: everything is visible
    float wanted = 0.0F;  ///< by a command, in parts of the visible height; applied in the next frame
    bool held = false;    ///< the pointer drags its bar
};

/// State of the interface, apart from the lesson.
struct UiState {
    Tab tab = Tab::step;
    bool browser = false;  ///< the list of lessons is shown instead of a lesson
    bool help = false;     ///< the list of keys is shown over everything
    bool dark = false;
    float text_scale = 1.0F;
    bool has_disk = true;              ///< other programs can see the files that are written: paths are shown
    std::vector<Command> not_offered;  ///< hidden in the menu and in the list of keys

    Pointable pointed_at;       ///< object under the pointer, in panels or in 3D
    int symbol = -1;            ///< of the caption, chosen by the keyboard; -1: none
    std::vector<int> lit_rows;  ///< of the system: highlighted, whatever is pointed at
    render::Tone tone() const { return dark ? render::Tone::dark : render::Tone::light; }
    Lit lit() const { return {pointed_at || symbol < 0 ? pointed_at : Pointable::symbol(symbol), lit_rows}; }
    /// Call when the lesson is replaced or changed: the object pointed at may be gone.
    void forget_pointed() {
        pointed_at = {};
        symbol = -1;
        lit_rows.clear();
    }

    Scroll column;           ///< of the step's panels
    Scroll caption;          ///< of the text below the picture
    Scroll sheet;            ///< of the list of keys: only `wanted` is used
    int scrolled_step = -1;  ///< step at which column and caption were scrolled

    bool panel_keys = false;  ///< the keyboard operates the widgets of the panel

    Playback playback;

    int experiment_joint = -1;  ///< chosen in "Try it"; -1: the joint of the step

    /// Call when another lesson is shown.
    void forget_lesson() {
        forget_pointed();
        playback.stop();
        experiment_joint = -1;
    }
};

/// Requests of one frame.
struct Requests {
    std::vector<Experiment> experiments;
    std::vector<Command> commands;
    std::optional<std::string> open;     ///< lesson file to open
    std::optional<int> trial;            ///< of the lesson, to carry out
    std::optional<std::string> copy;     ///< text for the clipboard
    std::optional<int> show_joint;       ///< joint whose vectors and equations the motion shows
    std::vector<int> lit_rows;           ///< highlighted in the next frame
    std::optional<int> exercise;         ///< of the lesson, to begin
    std::optional<std::string> answer;   ///< to the exercise, to judge
    std::optional<std::string> starter;  ///< file of a starter program, to write

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
