#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/exercises/practice/practice.hpp"
#include "app/host/lesson/lesson_file.hpp"
#include "app/host/lesson/long_telling.hpp"
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
    /// Working copies of lessons are kept in the folder of the progress file.
    /// @param programs  folder for programs to begin with; empty: that of the working copies
    explicit ExerciseDesk(PracticeSetup setup, std::filesystem::path programs = {});

    Practice& practice() { return practice_; }
    const Practice& practice() const { return practice_; }
    const ExerciseWork& work() const { return work_; }
    /// The scene of the exercise begun; nullptr if it has none, or it is not drawn yet.
    const Still* figure() const { return figure_.get(); }
    /// A lesson of the exercise is open in place of the one put aside.
    bool has_aside() const { return aside_.has_value(); }
    bool is_busy() const { return practice_.is_busy() || drawing_ || telling_; }

    /// Another lesson is open. @param open  the lesson of the exercise, if there is one, is dropped
    void open(const std::filesystem::path& lesson_file);
    /// What `look` did.
    struct News {
        bool any = false;
        bool other_picture = false;  ///< another lesson, or figure
    };
    /// Takes over what was computed: begins a task whose numbers are drawn, gives back the lesson put aside
    /// where the exercise was left.
    News look(const OpenLesson& open, ExerciseTab& tab);
    /// Waits for everything under way.
    void wait();

    /// Judges what stands in the field, or what was made of the lesson. @throws NotToldYet
    /// @return what there is to say beside the verdict, mostly nothing
    std::string check(const OpenLesson& open, const std::string& answer);
    /// Writes a program to begin with, and its input. @return what was done
    std::string write_starter(const std::string& file) const;
    /// The file of the working copy was saved anew by another program, or the lesson was changed in the
    /// window: the field, or the list of experiments, follows.
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
    int begun_ = 0;               ///< tasks made when the last one was begun
    std::uint64_t followed_ = 0;  ///< telling of the lesson that the field shows
    std::optional<SetAside> aside_;
    std::shared_ptr<const Still> figure_;
    std::unique_ptr<Background<std::shared_ptr<const Still>>> drawing_;
    std::unique_ptr<ToldBeside> telling_;
    std::vector<std::unique_ptr<BackgroundWork>> given_up_;
};

}  // namespace jw::host
