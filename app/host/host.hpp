#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/host/lesson/address.hpp"
#include "app/host/lesson/lesson_file.hpp"
#include "app/host/lesson/lesson_shelf.hpp"
#include "app/host/lesson/long_telling.hpp"
#include "app/host/lesson/saving.hpp"
#include "app/host/lesson/unsaved.hpp"
#include "app/host/parts/exercise_desk.hpp"
#include "app/host/parts/notice.hpp"
#include "app/host/parts/predictions.hpp"
#include "app/host/parts/scene_hand.hpp"
#include "app/host/tabs/tabs.hpp"
#include "app/host/ui/scaled_fonts.hpp"
#include "app/host/ui/ui.hpp"
#include "app/host/ui/window_layout.hpp"

struct ImGuiContext;

/// The interface without a surface: lesson browser, lesson, timeline, experiments. Events go in, ImGui's draw
/// data, a scene and a camera come out; a window or an offscreen picture shows them. Its parts keep what they
/// are about (`lesson/`, `ui/`, `tabs/`, `parts/`); the host carries out what is asked for.
namespace jw::host {

struct HostSetup {
    std::filesystem::path catalogue;       ///< folder of the lessons offered
    std::filesystem::path recent_file;     ///< where the lessons opened last are kept; empty: nowhere
    std::filesystem::path unsaved;         ///< folder for what was tried and not saved; empty: nowhere
    std::filesystem::path pictures = ".";  ///< folder that pictures and lessons are saved into
    std::filesystem::path progress;        ///< file of what is solved; empty: nowhere
    ProgramJudge judge_program;            ///< of exercises that ask for programs; nothing: none is run
    std::filesystem::path programs;        ///< folder for programs to begin with; empty: beside `progress`
    bool has_disk = true;                  ///< other programs see the files that are written
    std::vector<Command> not_offered;      ///< what is of no use here, or has a key that never comes
    Tab tab = Tab::step;                   ///< what stands beside the picture to begin with
    bool dark = false;
    float text_scale = 1.0F;
    int width = 1280;
    int height = 720;
    float density = 0.0F;                        ///< of the screen, see panels::Looking
    FontLoader load_fonts = render::load_fonts;  ///< into the ImGui context of the host
};

/// The tab that an address names. @throws std::runtime_error where there is none of that name
Tab tab_of(const Address& address);

class Host {
public:
    explicit Host(const HostSetup& setup);
    ~Host();
    Host(const Host&) = delete;
    Host& operator=(const Host&) = delete;

    /// Opens a lesson file at a step; without it the lessons are shown.
    /// @param experiments  to begin with, see app/session/try/carry_out.hpp
    /// @return false if it has mistakes: they are shown, and what was open stays. True also where it opens
    ///         later, when its story is told (`is_telling`)
    bool open(
        const std::filesystem::path& path, const std::string& at = {},
        const std::vector<std::string>& experiments = {});

    /// Address that `go_to` shows this window's state by; of an exercise its name alone.
    Address address() const;
    /// Shows what an address says, in one go: opens its lesson if another one is open, which begins a history
    /// of its own, else makes it of the lesson as it was written, which is one change.
    /// @return false if something of it cannot be done: that is shown, and everything stays as it was. True
    ///         also where this is not known yet, before its story is told (`is_telling`)
    bool go_to(const Address& address);

    /// A long story is being told (host_waiting.cpp). Meanwhile nothing is carried out but giving it up, by
    /// Escape or a button, and what was open is shown.
    bool is_telling() const { return telling_.is_busy(); }
    /// Part of it that is told, from 0 to 1.
    double told_part() const { return is_telling() ? telling_.progress() : 1.0; }
    /// Number of stories that were told beside the pictures, for tests.
    int stories_told_beside() const { return telling_.told_beside(); }
    /// Waits for the story, and does what needed it.
    void wait_for_story();

    /// Begins an exercise of the open lesson, and waits until it is asked.
    /// @return false if the lesson has none of that name
    bool begin_exercise(const std::string& name);
    /// Waits for what is computed in threads about exercises, and takes it over.
    void wait_for_exercises();
    const ExerciseDesk& exercises() const { return desk_; }
    /// The figure of an exercise is shown in place of the lesson.
    bool shows_figure() const;
    /// The tab of exercises as text.
    std::string exercise_text() const { return tabs_.exercises.text(desk_.practice(), desk_.work()); }

    /// Size of the picture in pixels of the framebuffer.
    /// @param density  of the screen, see panels::Looking
    void resize(int width, int height, float density = 0.0F);

    void push(const InputEvent& event) { events_.push(event); }
    /// Number of what is drawn at a pixel; whoever draws knows. Without it 3D cannot be pointed at.
    void set_picker(Picker picker) { hand_.set_picker(std::move(picker)); }

    /// One frame: events, interface, what was asked for, and what moves by itself.
    /// @param seconds since the last frame
    void frame(double seconds);
    /// The next frame is due at once.
    void rouse() { settle_ = 2; }
    /// Time after the last frame until another one would show something new without an event [s]; 0: at once,
    /// infinity: never.
    double seconds_to_change() const;

    /// Looks whether the open file was saved anew; @return true if so
    bool look_at_file();
    /// Writes what was tried and not saved into a file, if it is another than at the last call. To be called
    /// often: what ends the program may leave no time for it.
    void keep_unsaved();
    /// Path of the file of unsaved experiments; empty where nothing is unsaved.
    const std::filesystem::path& unsaved_copy() const { return unsaved_.path(); }

    bool wants_to_close() const { return close_; }
    /// The picture changes from frame to frame: turned, pulled, played.
    bool is_moving() const { return shows_lesson() && (hand_.is_busy() || state_.playback.is_moving()); }
    /// A lesson and not the browser is shown.
    bool shows_lesson() const { return session_ && !state_.browser; }
    const Session* session() const { return session_.get(); }
    /// File of the open lesson; empty without one.
    const std::filesystem::path& lesson_path() const { return file_.path(); }
    const UiState& state() const { return state_; }
    const render::Camera& camera() const { return hand_.camera(); }
    const WindowLayout& layout() const { return layout_; }
    /// The picture with what is pointed at lit up; empty without a lesson.
    const Picture& picture();
    /// The versions of picture(), as it was made last.
    const ShownPicture& shown() const { return shown_; }
    LessonShelf& shelf() { return shelf_; }
    const ScaledFonts& fonts() const { return fonts_; }

    /// Set by a command, carried out by whoever draws, and told with done().
    DrawingTask task() const { return task_; }
    /// Name for the next file of a task: "four-bar-step-12.png", a folder for `record`.
    std::filesystem::path task_path() const;
    void done(const std::string& message);

    /// Something to be read at the foot of the picture for a while.
    void say(const std::string& message);
    const Notice& notice() const { return notice_; }
    const Predictions& predictions() const { return predictions_; }

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
    void need_characters_of_lesson();
    void need_characters_of_shelf();
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

    // what takes long (host_waiting.cpp)
    void attempt(std::function<void()> act);
    void go_on_waiting();
    void give_up_waiting();
    void stop_telling();
    bool act_while_telling(const InputEvent& event);
    void pull_while_telling(const Experiment& experiment);
    Storyteller storyteller();

    // exercises (host_exercises.cpp)
    OpenLesson open_lesson() { return {file_, session_, storyteller()}; }
    void look_at_exercises();
    bool choose_exercise(const std::string& name);
    void begin_wanted_exercise();
    bool act_in_exercises(const InputEvent& event);
    void carry_out_exercises(const Requests& requests);
    void carry_out_exercise(Command command);
    void draw_figure(const Ui& ui);

    ImGuiContext* context_;
    ScaledFonts fonts_;
    WindowLayout layout_;
    InputQueue events_;

    LessonShelf shelf_;
    LessonFile file_;
    std::unique_ptr<Session> session_;
    std::string name_;  ///< of the lesson opened, as addresses have it
    UnsavedCopy unsaved_;
    std::filesystem::path pictures_;  ///< folder for what is saved

    UiState state_;
    Tabs tabs_;
    SceneHand hand_;
    ShownPicture shown_;
    Notice notice_;
    Predictions predictions_;
    ExerciseDesk desk_;
    LongTelling telling_;
    std::deque<std::function<void()>> waiting_;  ///< the first one for a story, the others for their turn
    std::optional<Experiment> pulled_;  ///< last value of a slider that was pulled while a story was told
    std::string wanted_exercise_;       ///< that an address has named, until it begins; mostly empty
    bool shown_figure_ = false;         ///< in the frame before

    DrawingTask task_ = DrawingTask::none;
    bool new_text_scale_ = false;                     ///< fonts are loaded before the next frame begins
    bool told_of_font_ = false;                       ///< that one is missing
    int shelf_version_ = 0;                           ///< whose characters the fonts have
    std::shared_ptr<const Exercise> known_exercise_;  ///< the first of those whose characters are there
    bool was_moving_ = false;
    int settle_ = 2;  ///< frames that ImGui needs to come to rest
    bool close_ = false;
};

}  // namespace jw::host
