#include "app/exercises/practice/practice.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "app/exercises/random.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/shown_lesson.hpp"
#include "lessons/files/course.hpp"

namespace jw {

namespace {

AnswerVerdict could_not_judge(const std::string& why) {
    return {not_understood(tr("This could not be judged: {0}", why)), {}, {}};
}

/// True for kinds whose answers are judged at once; the others need simulations, or runs of programs.
bool is_judged_at_once(ExerciseKind kind) { return !is_judged_by_claims(kind) && kind != ExerciseKind::code; }

}  // namespace

/// Reads the exercises of a lesson, and which lessons explain slides, file by file.
class Practice::Reading {
public:
    /// @param slides_of  folder of the course; empty: its slides are known
    Reading(
        const std::filesystem::path& lesson, const std::filesystem::path& lessons,
        std::filesystem::path slides_of)
        : exercises_(lesson, lessons), slides_of_(std::move(slides_of)) {}

    std::optional<Found> advance() {
        if (exercises_.read()) { return {}; }
        found_.with_slides = !slides_of_.empty() && !exercises_.found().exercises.empty();
        if (found_.with_slides && !lessons_) { lessons_ = course_lessons(slides_of_).lessons; }
        if (lessons_ && next_ < lessons_->size()) {
            auto lesson = slide_lesson_in((*lessons_)[next_++].file);
            if (lesson) { found_.slides.push_back(std::move(*lesson)); }
            return {};
        }
        found_.exercises = exercises_.found();
        return std::move(found_);
    }

private:
    LessonExercisesReader exercises_;
    std::filesystem::path slides_of_;
    std::optional<std::vector<CourseLessons::Entry>> lessons_;
    std::size_t next_ = 0;
    Found found_;
};

/// Makes a task, variant by variant.
class Practice::Making {
public:
    /// @param maker  made before; nullptr: there is none
    Making(
        std::shared_ptr<const Exercise> exercise, std::shared_ptr<const TaskMaker> maker, std::uint64_t seed)
        : exercise_(std::move(exercise)), maker_(std::move(maker)), seed_(seed) {}

    std::optional<Drawn> advance() {
        if (!maker_) {
            if (!learning_) { learning_ = std::make_shared<TaskMaker>(TaskMaker::unlearned(*exercise_)); }
            if (learning_->learn()) { return {}; }
            maker_ = std::move(learning_);
        }
        if (!draft_) { draft_.emplace(*maker_, seed_); }
        if (draft_->draw()) { return {}; }
        return Drawn{maker_, draft_->task()};
    }

private:
    std::shared_ptr<const Exercise> exercise_;  ///< kept alive here, since the maker refers to it
    std::shared_ptr<TaskMaker> learning_;
    std::shared_ptr<const TaskMaker> maker_;
    std::optional<TaskDraft> draft_;
    std::uint64_t seed_;
};

Practice::Practice(PracticeSetup setup) : setup_(std::move(setup)), progress_(setup_.progress) {}

Practice::~Practice() {
    // all are told to stop before the first is waited for
    give_up(std::move(reading_));
    give_up(std::move(drawing_));
    give_up(std::move(judging_));
}

void Practice::open(const std::filesystem::path& lesson_file) {
    leave();
    exercises_.clear();
    problem_.clear();
    give_up(std::move(reading_));
    unread_ = lesson_file;
}

void Practice::begin_reading() {
    if (unread_.empty()) { return; }
    const std::filesystem::path slides_of = slides_.empty() ? setup_.lessons : std::filesystem::path();
    reading_ = std::make_unique<Background<Found>>(
        [reading = std::make_shared<Reading>(std::exchange(unread_, {}), setup_.lessons, slides_of)](
            const std::stop_token&) { return reading->advance(); });
}

void Practice::offer(std::vector<PracticeExercise> exercises) {
    leave();
    give_up(std::move(reading_));
    unread_.clear();
    problem_.clear();
    exercises_ = std::move(exercises);
}

void Practice::tell_again() {
    for (PracticeExercise& offered : exercises_) {
        offered.exercise = std::make_shared<const Exercise>(shown_exercise(*offered.exercise));
    }
    if (chosen_ < 0) { return; }
    const auto [hints, solution, solved] = std::tuple(hints_given_, solution_, solved_);
    held_ = exercises_[static_cast<std::size_t>(chosen_)].exercise;
    maker_.reset();
    draw_with(seed_);
    std::tie(hints_given_, solution_, solved_) = std::tie(hints, solution, solved);
}

bool Practice::look() {
    std::erase_if(given_up_, [](const auto& work) { return work->is_done(); });
    bool is_new = false;
    if (reading_ && reading_->is_done()) {
        take_found();
        is_new = true;
    }
    if (drawing_ && drawing_->is_done()) {
        take_drawn();
        is_new = true;
    }
    if (judging_ && judging_->is_done()) {
        take_verdict();
        is_new = true;
    }
    return is_new;
}

void Practice::wait() {
    while (is_busy()) {
        if (reading_) { reading_->wait(); }
        if (drawing_) { drawing_->wait(); }
        if (judging_) { judging_->wait(); }
        look();
    }
}

std::string Practice::doing() const {
    if (reading_) { return tr("reading the exercises …"); }
    if (drawing_) { return tr("choosing numbers …"); }
    if (judging_) { return tr("checking …"); }
    return {};
}

void Practice::take_found() {
    const std::unique_ptr<Background<Found>> done = std::move(reading_);
    try {
        Found found = done->take();
        exercises_ = std::move(found.exercises.exercises);
        problem_ = std::move(found.exercises.problem);
        if (found.with_slides) { slides_ = std::move(found.slides); }
    } catch (const std::exception& error) {
        problem_ = tr("The exercises could not be read: {0}", error.what());
    }
}

void Practice::take_drawn() {
    const std::unique_ptr<Background<Drawn>> done = std::move(drawing_);
    try {
        Drawn drawn = done->take();
        maker_ = std::move(drawn.maker);
        task_ = std::move(drawn.task);
    } catch (const std::exception& error) {
        task_.emplace();
        task_->problem = tr("The numbers could not be chosen: {0}", error.what());
    }
    ++tasks_made_;
}

void Practice::choose(int index) {
    leave();
    if (index < 0 || static_cast<std::size_t>(index) >= exercises_.size()) { return; }
    chosen_ = index;
    held_ = exercises_[static_cast<std::size_t>(index)].exercise;
    draw();
}

void Practice::leave() {
    forget_task();
    chosen_ = -1;
    maker_.reset();
}

void Practice::forget_task() {
    give_up(std::move(drawing_));
    give_up(std::move(judging_));
    task_.reset();
    verdict_.reset();
    hints_given_ = 0;
    solution_ = solved_ = false;
}

void Practice::give_up(std::unique_ptr<BackgroundWork> work) {
    if (!work) { return; }
    work->stop();
    given_up_.push_back(std::move(work));
}

const Exercise* Practice::exercise() const {
    return chosen_ < 0 ? nullptr : exercises_[static_cast<std::size_t>(chosen_)].exercise.get();
}

ExerciseRecord Practice::record() const {
    return chosen_ < 0 ? ExerciseRecord() : progress_.of(exercises_[static_cast<std::size_t>(chosen_)].key);
}

bool Practice::has_variants() const {
    const Exercise* const e = exercise();
    return e != nullptr && (!e->vary.empty() || !e->alternatives.empty() || e->kind == ExerciseKind::choose ||
                            e->kind == ExerciseKind::order);
}

void Practice::draw() { draw_with(seed_of("practice", std::to_string(record().variant), exercise()->name)); }

void Practice::draw_with(std::uint64_t seed) {
    forget_task();
    seed_ = seed;
    drawing_ = std::make_unique<Background<Drawn>>([making = std::make_shared<Making>(held_, maker_, seed)](
                                                       const std::stop_token&) { return making->advance(); });
}

void Practice::draw_anew() {
    if (chosen_ < 0 || !has_variants()) { return; }
    ExerciseRecord next = record();
    // a solved variant has already been followed by the next one
    if (!solved_) { ++next.variant; }
    if (!solved_ && !solution_ && verdict_) { next.streak = 0; }
    progress_.keep(exercises_[static_cast<std::size_t>(chosen_)].key, next);
    draw();
}

void Practice::give_hint() {
    // alternatives of an exercise have their own hints
    if (task_ && hints_given_ < static_cast<int>(task_->exercise().hints.size())) { ++hints_given_; }
}

void Practice::show_solution() {
    if (!task_) { return; }
    if (!solution_ && !solved_) {
        ExerciseRecord changed = record();
        changed.streak = 0;
        progress_.keep(exercises_[static_cast<std::size_t>(chosen_)].key, changed);
    }
    solution_ = true;
}

void Practice::check(const Handed& handed) {
    if (!task_ || !task_->problem.empty() || judging_) { return; }
    if (!is_judged_at_once(task_->exercise().kind)) {
        return judge_in_thread([task = *task_, held = held_, handed](const std::stop_token&) {
            return verdict_on(task, handed);
        });
    }
    tell(verdict_on(*task_, handed));
    keep_result();
}

void Practice::check_program(const std::filesystem::path& file) {
    if (!task_ || !task_->problem.empty() || judging_) { return; }
    if (!setup_.judge_program) {
        return tell(
            could_not_judge(tr("programs of students run in a sandbox only, and there is none here.")));
    }
    judge_in_thread(
        [task = *task_, held = held_, file, judge = setup_.judge_program](const std::stop_token& stop) {
            return verdict_of(task, {}, judge(task, file, stop));
        });
}

void Practice::judge_in_thread(std::function<AnswerVerdict(const std::stop_token& stop)> judge) {
    judging_ = std::make_unique<Background<AnswerVerdict>>(std::move(judge));
}

void Practice::take_verdict() {
    const std::unique_ptr<Background<AnswerVerdict>> done = std::move(judging_);
    try {
        tell(done->take());
    } catch (const std::exception& error) { tell(could_not_judge(error.what())); }
    keep_result();
}

void Practice::tell(AnswerVerdict verdict) {
    verdict_ = std::move(verdict);
    ++verdicts_given_;
}

void Practice::keep_result() {
    const Judged& judged = verdict_->judged;
    // an answer that was not understood is not a try; once the task is solved or its solution shown, tries do
    // not count
    if (!judged.understood || solved_ || solution_) { return; }
    ExerciseRecord result = record();
    ++result.tried;
    solved_ = judged.right;
    result.streak = judged.right ? result.streak + 1 : 0;
    if (judged.right) {
        ++result.solved;
        // the student gets other numbers the next time
        ++result.variant;
    }
    progress_.keep(exercises_[static_cast<std::size_t>(chosen_)].key, result);
}

}  // namespace jw
