#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/host/lesson/catalogue.hpp"
#include "app/host/lesson/unsaved.hpp"
#include "app/host/parts/notice.hpp"
#include "app/host/parts/scene_hand.hpp"
#include "app/host/tabs/tabs.hpp"
#include "app/host/ui/scaled_fonts.hpp"
#include "app/host/ui/ui.hpp"
#include "app/host/ui/window_layout.hpp"

struct ImGuiContext;

/// The interface without a surface: lesson browser, lesson, timeline, experiments. Events go in, ImGui's draw
/// data, a scene and a camera come out; a window or an offscreen picture shows them.
namespace jw::host {

struct HostSetup {
    std::filesystem::path catalogue;       ///< folder of the lessons offered
    std::filesystem::path recent_file;     ///< where the lessons opened last are kept; empty: nowhere
    std::filesystem::path unsaved;         ///< folder for what was tried and not saved; empty: nowhere
    std::filesystem::path pictures = ".";  ///< folder that pictures and lessons are saved into
    bool dark = false;
    float text_scale = 1.0F;
    int width = 1280;
    int height = 720;
};

class Host {
public:
    explicit Host(HostSetup setup);
    ~Host();
    Host(const Host&) = delete;
    Host& operator=(const Host&) = delete;

    /// What stands beside the picture to begin with.
    void choose(Tab tab) { state_.tab = tab; }

    /// Opens a lesson file at a step; without it the lessons are shown.
    /// @param experiments  to begin with, see app/session/try/carry_out.hpp
    /// @return false if it has mistakes: they are shown, and what was open stays
    bool open(
        const std::filesystem::path& path, const std::string& at = {},
        const std::vector<std::string>& experiments = {});

    /// Size of the picture in pixels of the framebuffer.
    void resize(int width, int height);

    void push(const InputEvent& event) { events_.push(event); }
    /// Number of what is drawn at a pixel; whoever draws knows. Without it 3D cannot be pointed at.
    void set_picker(Picker picker) { hand_.set_picker(std::move(picker)); }

    /// One frame: events, interface, what was asked for, and what moves by itself.
    /// @param seconds since the last frame
    void frame(double seconds);

    /// How long until the next frame is worth drawing without an event [s]; 0: at once.
    double seconds_to_wait() const;
    /// Whether a frame now, so long after the last one, would show anything new.
    bool is_due(double seconds_since) const;
    /// Looks whether the open file was saved anew; @return true if so
    bool look_at_file();

    /// Writes what was tried and not saved into a file, if it is another than at the last call. To be called
    /// often: what ends the program may leave no time for it.
    void keep_unsaved();
    /// Path of the file of unsaved experiments; empty where nothing is unsaved.
    const std::filesystem::path& unsaved_copy() const { return unsaved_.path(); }

    bool wants_to_close() const { return close_; }
    /// The picture changes from frame to frame: turned, pulled, played.
    bool is_moving() const;
    /// A lesson and not the browser is shown.
    bool shows_lesson() const { return session_ && !state_.browser; }
    const Session* session() const { return session_.get(); }
    const UiState& state() const { return state_; }
    const render::Camera& camera() const { return hand_.camera(); }
    const WindowLayout& layout() const { return layout_; }
    /// The picture with what is pointed at lit up; empty without a lesson.
    const Picture& picture();
    /// The versions of picture(), as it was made last.
    const ShownPicture& shown() const { return shown_; }

    std::vector<CatalogueEntry>& catalogue() { return entries_; }
    /// Grows when the font atlas was built anew: its texture must be too.
    int fonts_version() const { return fonts_.version(); }

    /// The next frame is due at once.
    void rouse() { settle_ = 2; }

    /// Set by a command, carried out by whoever draws, and told with done().
    enum class Task { none, save_picture, record };
    Task task() const { return task_; }
    /// Name for the next file of a task: "four-bar-step-12.png", a folder for `record`.
    std::filesystem::path task_path() const;
    void done(const std::string& message);

    /// Something to be read at the foot of the picture for a while.
    void say(const std::string& message);
    const std::string& message() const { return notice_.text(); }
    const std::string& file_errors() const { return file_errors_; }

private:
    void load_fonts(float scale);
    void show_browser();
    void fit_camera(bool at_once);
    void take_events();
    void act_on(const InputEvent& event);
    bool act_in_browser(const InputEvent& event);
    void leave_search_or_browser();
    void open_chosen_lesson();
    bool act_in_panel(const InputEvent& event);
    void use_panel_keys(bool on);
    void draw_interface();
    void draw_lesson(const LessonUi& ui);
    void draw_messages(const Ui& ui);
    void carry_out(Requests requests);
    void carry_out(Command command);
    void play_or_pause();
    void let_go();
    void change_tone();
    void change_text(float by);
    void show_or_leave_browser();
    void forget_what_is_pointed_at();
    void go_to(int step);
    void apply(const Experiment& experiment);
    void advance(double seconds);
    void next_freedom();
    void save_lesson();
    void save_csv();
    void copy_view(Command command);
    void copy(const std::string& text, const std::string& what);
    std::vector<CatalogueEntry> refreshed_catalogue() const;
    std::vector<std::filesystem::path> copies_of_others() const;
    /// "four-bar-2.png": a name in the folder for pictures that is not taken.
    std::filesystem::path free_name(const std::string& suffix) const;
    double seconds_to_change() const;

    HostSetup setup_;
    ImGuiContext* context_;
    ScaledFonts fonts_;
    WindowLayout layout_;

    RecentLessons recent_;
    UnsavedCopy unsaved_;
    std::vector<CatalogueEntry> entries_;
    std::filesystem::path path_;
    std::filesystem::file_time_type saved_{};
    std::unique_ptr<Session> session_;

    UiState state_;
    SceneHand hand_;
    Tabs tabs_;
    InputQueue events_;
    std::vector<panels::HotSpot> spots_;
    bool new_text_scale_ = false;  ///< fonts are loaded before the next frame begins

    ShownPicture shown_;

    bool was_moving_ = false;
    int settle_ = 2;  ///< frames that ImGui needs to come to rest
    Notice notice_;
    std::string file_errors_;
    Task task_ = Task::none;
    bool close_ = false;
};

}  // namespace jw::host
