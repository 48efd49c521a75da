#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/exercises/practice/practice.hpp"
#include "app/host/lesson/background_story.hpp"
#include "app/host/lesson/saving.hpp"
#include "app/host/tabs/exercise_tab.hpp"
#include "app/session/picture/still.hpp"
#include "app/session/try/session.hpp"

namespace jw::host {

/// The open lesson, which an exercise may put aside and replace by its own.
struct OpenLesson {
    LessonFile& file;
    std::unique_ptr<Session>& session;
    Storyteller tell;
};

/// An exercise in the window: its figure, or the lesson that it hands out, in place of the open lesson.
class ExerciseDesk {
public:
    /// Working copies of lessons are kept in the folder `exercises` beside the progress file.
    /// @param programs  folder for starter programs; empty: that of the working copies
    explicit ExerciseDesk(PracticeSetup setup, std::filesystem::path programs = {});

    Practice& practice() { return practice_; }
    const Practice& practice() const { return practice_; }
    const ExerciseWork& work() const { return work_; }
    /// The scene of the current exercise; nullptr if it has none, or if it is not drawn yet.
    const Still* figure() const { return figure_.get(); }
    /// True if a lesson of the exercise is open, and the other one was put aside.
    bool has_aside() const { return aside_.has_value(); }
    bool is_busy() const { return practice_.is_busy() || drawing_ || telling_; }

    /// Begins an exercise of the lesson. @return false if the lesson has no exercise of that name
    bool choose(const std::string& name);
    /// Remembers the exercise that an address names, until the exercises of its lesson have been read.
    void want(const std::string& name) { wanted_ = name; }
    std::string take_wanted() { return std::exchange(wanted_, {}); }

    /// Call when another lesson has been opened; a lesson that was put aside is discarded.
    void open(const std::filesystem::path& lesson_file);
    /// Result of `look`.
    struct News {
        bool any = false;
        bool other_picture = false;  ///< another lesson, or figure
    };
    /// Takes over computed results: begins a task when its numbers are ready. Brings back the lesson that was
    /// put aside, if the exercise has been left.
    News look(const OpenLesson& open, ExerciseTab& tab);
    /// Waits for all running computations.
    void wait();

    /// Judges the text in the field, or the lesson as it was changed. @throws NotToldYet
    /// @return message besides the verdict, usually empty
    std::string check(const OpenLesson& open, const std::string& answer);
    /// Writes a starter program, and its input. @return message that says what was done
    std::string write_starter(const std::string& file) const;
    /// Call when the lesson was changed in the window, or when another program has saved the working copy:
    /// the field, or the list of experiments, is updated.
    void follow_lesson(const Session& session, ExerciseTab& tab);
    void follow_file(const LessonFile& file, ExerciseTab& tab);

private:
    struct SetAside {
        LessonFile file;
        std::unique_ptr<Session> session;
    };

    void begin(ExerciseTab& tab);
    void begin_work(const Task& task, ExerciseTab& tab);
    std::filesystem::path folder() const;

    std::filesystem::path progress_;
    std::filesystem::path programs_;
    Practice practice_;
    ExerciseWork work_;
    std::string wanted_;          ///< usually empty
    int begun_ = 0;               ///< number of tasks made when the last one was begun
    std::uint64_t followed_ = 0;  ///< telling of the lesson that the field shows
    std::optional<SetAside> aside_;
    std::shared_ptr<const Still> figure_;
    std::unique_ptr<Background<std::shared_ptr<const Still>>> drawing_;
    std::unique_ptr<Background<ToldLesson>> telling_;
    std::vector<std::unique_ptr<BackgroundWork>> given_up_;
};

}  // namespace jw::host
