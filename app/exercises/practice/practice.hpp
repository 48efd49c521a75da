#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/exercises/practice/lesson_exercises.hpp"
#include "app/exercises/practice/progress.hpp"
#include "app/exercises/practice/verdict.hpp"
#include "app/exercises/slide_lessons.hpp"
#include "app/session/background/background.hpp"

/// Practice with the exercises of a lesson, without drawing.
namespace jw {

/// Runs the program of a file and judges what it writes; may take seconds, unless it is told to stop.
using ProgramJudge =
    std::function<Judged(const Task& task, const std::filesystem::path& file, const std::stop_token& stop)>;

struct PracticeSetup {
    std::filesystem::path lessons;   ///< folder of the course
    std::filesystem::path progress;  ///< file; empty: nothing is kept
    ProgramJudge judge_program;      ///< nothing: programs cannot be run here
};

/// The current exercise, its numbers, and the feedback on its answers. Long work is done in threads. Only
/// `look` takes over their results, so nothing changes between two calls of `look`.
class Practice {
public:
    explicit Practice(PracticeSetup setup);
    ~Practice();
    Practice(const Practice&) = delete;
    Practice& operator=(const Practice&) = delete;

    /// Opens another lesson; the exercises of the previous lesson are left.
    void open(const std::filesystem::path& lesson_file);
    /// Begins to read the exercises of the open lesson, once.
    void begin_reading();

    /// Shows the exercises in the language that was chosen since. The current exercise keeps its numbers,
    /// hints and solution, and its answer can be judged again.
    void tell_again();

    /// Offers these exercises, whatever lesson they belong to.
    void offer(std::vector<PracticeExercise> exercises);

    /// Takes over the results of finished work. @return true if something is new
    bool look();
    /// Waits for all work and takes over its results: for pictures and tests.
    void wait();
    /// Description of the current work: "choosing numbers ..."; empty if there is none.
    std::string doing() const;
    bool is_busy() const { return reading_ || drawing_ || judging_; }

    const std::vector<PracticeExercise>& exercises() const { return exercises_; }
    /// What is wrong with files of exercises.
    const std::string& problem() const { return problem_; }
    const Progress& progress() const { return progress_; }
    std::string take_notice() { return progress_.take_notice(); }
    /// The lesson that explains a slide; nullptr if there is none.
    const SlideLesson* lesson_about(const std::string& slide) const {
        return lesson_of_slide(slides_, slide);
    }

    /// Begins an exercise: its numbers are drawn.
    void choose(int index);
    /// Goes back to the list, and gives up the current work.
    void leave();
    /// Index of the current exercise; -1: none.
    int chosen() const { return chosen_; }
    const Exercise* exercise() const;
    ExerciseRecord record() const;
    /// The exercise with its numbers; nullptr until they are drawn.
    const Task* task() const { return task_ ? &*task_ : nullptr; }
    /// Grows with every task: whatever was made from the previous task is out of date.
    int tasks_made() const { return tasks_made_; }
    /// True if there are variants with other numbers, or in another order.
    bool has_variants() const;
    /// Draws the next variant.
    void draw_anew();

    /// Gives one more hint of the task, if there is one.
    void give_hint();
    int hints_given() const { return hints_given_; }
    /// Shows the solution: this variant cannot count as solved any more.
    void show_solution();
    bool shows_solution() const { return solution_; }

    /// Judges an answer.
    void check(const Handed& handed);
    /// Judges a program.
    void check_program(const std::filesystem::path& file);
    /// The last verdict; nullptr until an answer is judged.
    const AnswerVerdict* verdict() const { return verdict_ ? &*verdict_ : nullptr; }
    /// Grows with every verdict.
    int verdicts_given() const { return verdicts_given_; }
    bool is_solved() const { return solved_; }

private:
    struct Found {
        LessonExercises exercises;
        std::vector<SlideLesson> slides;
        bool with_slides = false;
    };
    struct Drawn {
        std::shared_ptr<const TaskMaker> maker;
        Task task;
    };

    class Reading;
    class Making;

    void draw();
    void draw_with(std::uint64_t seed);
    void forget_task();
    void give_up(std::unique_ptr<BackgroundWork> work);
    void judge_in_thread(std::function<AnswerVerdict(const std::stop_token& stop)> judge);
    void take_found();
    void take_drawn();
    void take_verdict();
    void tell(AnswerVerdict verdict);
    void keep_result();

    PracticeSetup setup_;
    std::filesystem::path unread_;  ///< lesson whose exercises have not been asked for yet
    Progress progress_;
    std::vector<PracticeExercise> exercises_;
    std::vector<SlideLesson> slides_;
    std::string problem_;

    int chosen_ = -1;
    std::shared_ptr<const TaskMaker> maker_;  ///< for the chosen exercise, once it is made
    std::shared_ptr<const Exercise> held_;    ///< the exercise that the task points to
    std::uint64_t seed_ = 0;
    std::optional<Task> task_;
    int tasks_made_ = 0;
    int hints_given_ = 0;
    bool solution_ = false;
    bool solved_ = false;
    std::optional<AnswerVerdict> verdict_;
    int verdicts_given_ = 0;

    std::unique_ptr<Background<Found>> reading_;
    std::unique_ptr<Background<Drawn>> drawing_;
    std::unique_ptr<Background<AnswerVerdict>> judging_;
    std::vector<std::unique_ptr<BackgroundWork>> given_up_;  ///< told to stop, not ended yet
};

}  // namespace jw
