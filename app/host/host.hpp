#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/host/lesson/address.hpp"
#include "app/host/lesson/background_story.hpp"
#include "app/host/lesson/catalogue.hpp"
#include "app/host/lesson/saving.hpp"
#include "app/host/parts/exercise_desk.hpp"
#include "app/host/parts/notice.hpp"
#include "app/host/parts/predictions.hpp"
#include "app/host/parts/scene_input.hpp"
#include "app/host/tabs/tabs.hpp"
#include "app/host/ui/scaled_fonts.hpp"
#include "app/host/ui/ui.hpp"

struct ImGuiContext;

/// The user interface without a window: lesson browser, lesson, timeline, experiments. It takes events, and
/// makes ImGui's draw data, a scene and a camera, which a window or an offscreen picture shows. Each part
/// (`lesson/`, `ui/`, `tabs/`, `parts/`) keeps its own state; the host carries out the requests.
namespace jw::host {

struct HostSetup {
    std::filesystem::path catalogue;       ///< folder of the lessons offered
    std::filesystem::path recent_file;     ///< list of the lessons opened last; empty: not kept
    std::filesystem::path unsaved;         ///< folder for unsaved experiments; empty: not kept
    std::filesystem::path pictures = ".";  ///< folder that pictures and lessons are saved into
    std::filesystem::path progress;        ///< file that lists solved exercises; empty: not kept
    ProgramJudge judge_program;            ///< of exercises that ask for programs; empty: none is run
    std::filesystem::path programs;        ///< folder for starter programs; empty: beside `progress`
    bool has_disk = true;                  ///< other programs can see the files that are written
    std::vector<Command> not_offered;      ///< commands of no use here, or whose key never arrives
    Tab tab = Tab::step;                   ///< shown first beside the picture
    bool dark = false;
    float text_scale = 1.0F;
    int width = 1280;
    int height = 720;
    float density = 0.0F;                        ///< of the screen, see panels::Looking
    FontLoader load_fonts = render::load_fonts;  ///< into the ImGui context of the host
};

/// The tab that an address names. @throws std::runtime_error if no tab has that name
Tab tab_of(const Address& address);

class Host {
public:
    explicit Host(const HostSetup& setup);
    ~Host();
    Host(const Host&) = delete;
    Host& operator=(const Host&) = delete;

    /// Opens a lesson file at the step `at`. Until a lesson is opened, the list of lessons is shown.
    /// @param experiments  are carried out first, see app/session/try/carry_out.hpp
    /// @return false if the file has mistakes: they are shown, and the open lesson stays. True also if it
    ///         opens later, when its story has been computed (`is_telling`)
    bool open(
        const std::filesystem::path& path, const std::string& at = {},
        const std::vector<std::string>& experiments = {});

    /// Address with which `go_to` shows this state; for an exercise only the names of lesson and exercise.
    Address address() const;
    /// Shows the state that an address describes. If another lesson is open, opens the lesson of the address
    /// with a new history; else starts from the open lesson as it was written, and counts as one change.
    /// @return false if a part of the address is impossible: the reason is shown, and nothing changes. True
    ///         also if this is not known yet, because the story is still being computed (`is_telling`)
    bool go_to(const Address& address);

    /// True while a long story is computed (host_waiting.cpp). Meanwhile the previous state is shown, and the
    /// only possible action is to cancel, by Escape or a button.
    bool is_telling() const { return telling_.is_busy(); }
    /// Fraction of the story that has been computed, from 0 to 1.
    double told_part() const { return telling_.progress(); }
    /// Number of stories that were computed in the background, for tests.
    int stories_begun_in_background() const { return telling_.begun_in_background(); }
    /// Waits for the story, and carries out the actions that need it.
    void wait_for_story();

    /// Begins an exercise of the open lesson, and waits until its question is ready.
    /// @return false if the lesson has no exercise of that name
    bool begin_exercise(const std::string& name);
    /// Waits for the background computations of exercises, and takes over their results.
    void wait_for_exercises();
    const ExerciseDesk& exercises() const { return desk_; }
    /// True if the figure of an exercise is shown in place of the lesson.
    bool shows_figure() const;
    /// The tab of exercises as text.
    std::string exercise_text() const { return tabs_.exercises.text(desk_.practice(), desk_.work()); }

    /// Size of the picture in pixels of the framebuffer.
    /// @param density  of the screen, see panels::Looking
    void resize(int width, int height, float density = 0.0F);

    void push(const InputEvent& event) { events_.push(event); }
    /// Sets the function that finds the object drawn at a pixel; the code that draws provides it. Without it,
    /// objects in 3D cannot be pointed at.
    void set_picker(Picker picker) { hand_.set_picker(std::move(picker)); }

    /// One frame: events, interface, requests and animations.
    /// @param seconds since the last frame
    void frame(double seconds);
    /// Makes the next frame due at once.
    void rouse() { settle_ = 2; }
    /// Time until a new frame would differ from the last one although no event arrives [s]; 0: at once,
    /// infinity: never.
    double seconds_to_change() const;

    /// Reads the open file if it was saved again. @return true if so
    bool look_at_file();
    /// Writes unsaved experiments into a file if they have changed since the last call. Call it often: the
    /// program may be ended without a last call.
    void keep_unsaved();
    /// Path of the file of unsaved experiments; empty if there are none.
    const std::filesystem::path& unsaved_copy() const { return unsaved_.path(); }

    bool wants_to_close() const { return close_; }
    /// True while the picture changes from frame to frame: it is turned, pulled or played.
    bool is_moving() const {
        return shows_lesson() && (hand_.is_busy() || state_.playback.is_moving() || swings());
    }
    /// True if a lesson is shown, and not the browser.
    bool shows_lesson() const { return session_ && !state_.browser; }
    const Session* session() const { return session_.get(); }
    /// File of the open lesson; empty without one.
    const std::filesystem::path& lesson_path() const { return file_.path(); }
    const UiState& state() const { return state_; }
    const render::Camera& camera() const { return hand_.camera(); }
    const WindowLayout& layout() const { return layout_; }
    /// The picture, with the object under the pointer highlighted; empty without a lesson.
    const Picture& picture();
    /// Picture of a tab in place of the step's.
    Replacement replacement() const;
    /// The last picture(), with its versions.
    const ShownPicture& shown() const { return shown_; }
    LessonList& shelf() { return shelf_; }
    const ScaledFonts& fonts() const { return fonts_; }

    /// Task set by a command. The code that draws carries it out, and reports it with done().
    DrawingTask task() const { return task_; }
    /// Path of the next file of the task: "four-bar-step-12.png"; of a folder for `record`.
    std::filesystem::path task_path() const;
    void done(const std::string& message);

    /// Shows a message at the foot of the picture for some seconds.
    void say(const std::string& message);
    const Notice& notice() const { return notice_; }
    const Predictions& predictions() const { return predictions_; }
    const RestTab& rest() const { return tabs_.rest; }
    /// Waits for an equilibrium that is searched for; the next frame shows it.
    void wait_for_rest() { tabs_.rest.wait(); }

private:
    void take(LessonFile file, std::unique_ptr<Session> session);
    void arrive_at(const Address& address);
    void arrive_in_lesson(const Address& address);
    void act_on(const InputEvent& event);
    void draw_interface();
    void draw_lesson(const LessonUi& ui, const std::vector<panels::HotSpot>& spots);
    void draw_tip(const std::vector<std::string>& lines, const panels::Box& beside) const;
    void draw_step(const LessonUi& ui, const View& view);
    void advance(double seconds);
    bool swings() const { return state_.tab == Tab::rest && tabs_.rest.is_moving(); }
    void need_characters_of_lesson();
    void refresh_shelf();
    void need_characters_of_exercises();

    void carry_out(Requests requests);
    void carry_out(Command command);
    void apply(const Experiment& experiment);
    void show_joint(int joint);
    void go_to(int step);
    void play_or_pause();
    void answer();
    void try_out(const Experiment& experiment);
    void carry_out_trial(int index);
    void play_motion();
    void next_freedom();
    void show_symbol(int by);
    void let_go();
    void fit_camera(bool at_once);
    void change_tone();
    void change_text(float by);
    void use_next_language();
    void show_or_leave_browser();
    void save_lesson();
    void save_csv();

    // long computations (host_waiting.cpp)
    void attempt(std::function<void()> act);
    void go_on_waiting();
    void give_up_waiting();
    void stop_telling();
    Storyteller storyteller();

    // exercises (host_exercises.cpp)
    OpenLesson open_lesson() { return {file_, session_, storyteller()}; }
    void look_at_exercises();
    bool act_in_exercises(const InputEvent& event);
    void carry_out_exercises(const Requests& requests);
    void carry_out_exercise(Command command);
    void draw_figure(const Ui& ui);

    ImGuiContext* context_;
    ScaledFonts fonts_;
    WindowLayout layout_;
    InputQueue events_;

    LessonList shelf_;
    LessonFile file_;
    std::unique_ptr<Session> session_;
    std::string name_;  ///< of the open lesson, as in addresses
    UnsavedCopy unsaved_;
    std::filesystem::path pictures_;  ///< folder for saved files

    UiState state_;
    Tabs tabs_;
    SceneInput hand_;
    ShownPicture shown_;
    Notice notice_;
    Predictions predictions_;
    ExerciseDesk desk_;
    BackgroundStories telling_;
    std::deque<std::function<void()>> waiting_;  ///< the first waits for its story, the others for their turn
    std::optional<Experiment> pulled_;           ///< last value of a slider moved while a story was computed
    bool shown_figure_ = false;                  ///< in the previous frame

    DrawingTask task_ = DrawingTask::none;
    bool new_text_scale_ = false;                     ///< load the fonts before the next frame begins
    bool told_of_font_ = false;                       ///< advice on missing characters was given
    std::shared_ptr<const Exercise> known_exercise_;  ///< first exercise whose characters are loaded
    bool was_moving_ = false;
    int settle_ = 2;  ///< frames until ImGui is at rest
    bool close_ = false;
};

/// State of the interface as JSON: title, step, tab, experiments, camera, and a description for people who
/// cannot see the picture.
std::string state_text(const Host& host);

}  // namespace jw::host
