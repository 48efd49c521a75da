#include "app/host/parts/exercise_desk.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "app/exercises/figure_scene.hpp"
#include "app/exercises/starters.hpp"
#include "app/host/lesson/saving.hpp"
#include "app/session/wording/messages.hpp"
#include "lessons/files/file_text.hpp"
#include "lessons/write/writer.hpp"

namespace jw::host {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLargestWork = 200000;

bool works_on_lesson(ExerciseKind kind) {
    return kind == ExerciseKind::repair || kind == ExerciseKind::build || kind == ExerciseKind::experiment;
}

bool shows_motion(const Exercise& exercise) { return exercise.kind != ExerciseKind::experiment; }

}  // namespace

ExerciseDesk::ExerciseDesk(PracticeSetup setup, fs::path programs)
    : progress_(setup.progress), programs_(std::move(programs)), practice_(std::move(setup)) {
    if (programs_.empty()) { programs_ = folder(); }
}

fs::path ExerciseDesk::folder() const {
    return progress_.empty() ? fs::path() : progress_.parent_path() / "exercises";
}

void ExerciseDesk::open(const fs::path& lesson_file) {
    aside_.reset();
    wanted_.clear();
    practice_.open(lesson_file);
}

bool ExerciseDesk::choose(const std::string& name) {
    const std::vector<PracticeExercise>& all = practice_.exercises();
    const auto found =
        std::ranges::find(all, name, [](const PracticeExercise& e) { return e.exercise->name; });
    if (found == all.end()) { return false; }
    practice_.choose(static_cast<int>(found - all.begin()));
    return true;
}

void ExerciseDesk::wait() {
    practice_.wait();
    if (drawing_) { drawing_->wait(); }
    if (telling_) { telling_->wait(); }
}

ExerciseDesk::News ExerciseDesk::look(const OpenLesson& open, ExerciseTab& tab) {
    News news;
    std::erase_if(given_up_, [](const auto& work) { return work->is_done(); });
    news.any = practice_.look();
    tab.follow(practice_);
    if (practice_.task() == nullptr || practice_.tasks_made() != begun_) {
        const auto give_up = [this](auto& work) {
            if (!work) { return; }
            work->stop();
            given_up_.push_back(std::move(work));
        };
        give_up(drawing_);
        give_up(telling_);
        news.other_picture = std::exchange(figure_, nullptr) != nullptr;
        work_ = {};
    }
    if (practice_.task() != nullptr && practice_.tasks_made() != begun_) { begin(tab); }
    if (drawing_ && drawing_->is_done()) {
        const auto done = std::move(drawing_);
        // the exercise is set even if its scene cannot be drawn
        try {
            figure_ = done->take();
        } catch (const std::exception&) { figure_.reset(); }
        news.any = news.other_picture = true;
    }
    if (telling_ && telling_->is_done()) {
        const auto done = std::move(telling_);
        std::unique_ptr<Session> told =
            std::make_unique<Session>(done->take(), shows_motion(practice_.task()->exercise()), open.tell);
        if (!aside_) { aside_ = SetAside{std::move(open.file), std::move(open.session)}; }
        open.session = std::move(told);
        open.file = work_.file.empty() ? LessonFile() : LessonFile(work_.file);
        if (!work_.file.empty()) { open.file.read(); }
        followed_ = open.session->told();
        news.any = news.other_picture = true;
    }
    if (practice_.chosen() < 0 && aside_) {
        open.file = std::move(aside_->file);
        open.session = std::move(aside_->session);
        aside_.reset();
        news.any = news.other_picture = true;
    }
    return news;
}

void ExerciseDesk::begin(ExerciseTab& tab) {
    begun_ = practice_.tasks_made();
    const Task& task = *practice_.task();
    if (!task.problem.empty()) { return; }
    if (works_on_lesson(task.exercise().kind)) { return begin_work(task, tab); }
    if (task.exercise().kind == ExerciseKind::code && tab.answer().empty() && !programs_.empty()) {
        tab.set_answer((programs_ / (task.exercise().name + ".py")).string());
    }
    if (auto scene = figure_scene(task)) {
        drawing_ = std::make_unique<Background<std::shared_ptr<const Still>>>(
            [scene = std::move(*scene)](const std::stop_token&) {
                return std::make_shared<const Still>(scene.lesson, scene.as_given);
            });
    }
}

/// Writes the working copy, or continues with an existing one.
void ExerciseDesk::begin_work(const Task& task, ExerciseTab& tab) {
    const Exercise& exercise = task.exercise();
    std::string text = handed_out(task);
    const std::string name = exercise.name + "-" + std::to_string(practice_.record().variant + 1) + ".toml";
    std::error_code ignored;
    if (!folder().empty() && exercise.kind != ExerciseKind::experiment) {
        fs::create_directories(folder(), ignored);
        const fs::path path = folder() / name;
        const FileText before = read_file_text(path, kLargestWork);
        std::string error;
        if (before.problem.empty()) { text = before.text; }
        if (before.problem.empty() || write_lesson_file(path, text, error)) { work_.file = path; }
    }
    if (exercise.kind != ExerciseKind::experiment && tab.answer().empty()) { tab.set_answer(text); }
    // the student may have left a file that is not a lesson
    ReadResult read = read_lesson(text, name);
    if (!read.lesson) { read = read_lesson(handed_out(task), name); }
    if (!read.lesson) { return; }
    StoryOptions how;
    how.with_motion = shows_motion(exercise);
    const auto lesson = std::make_shared<const Lesson>(std::move(*read.lesson));
    telling_ = told_in_background(lesson, std::make_unique<StoryTelling>(*lesson, how));
}

std::string ExerciseDesk::check(const OpenLesson& open, const std::string& answer) {
    const Task* const task = practice_.task();
    if (task == nullptr || practice_.is_busy()) { return {}; }
    switch (task->exercise().kind) {
        case ExerciseKind::code: practice_.check_program(answer); return {};
        case ExerciseKind::experiment:
            if (!aside_) { return {}; }
            practice_.check({text_to_save(*open.session), open.session->tried()});
            return {};
        case ExerciseKind::repair:
        case ExerciseKind::build: break;
        default: practice_.check({answer, {}}); return {};
    }
    const ReadResult read = read_lesson(answer, task->exercise().name + ".toml");
    if (aside_ && read.lesson && lesson_text(*read.lesson) != lesson_text(open.session->lesson())) {
        open.session->replace(*read.lesson);
        followed_ = open.session->told();
    }
    practice_.check({answer, {}});
    std::string error;
    if (!work_.file.empty() && write_lesson_file(work_.file, answer, error)) { open.file.read(); }
    return error.empty() ? "" : tr("The working copy could not be written: {0}", error);
}

void ExerciseDesk::follow_lesson(const Session& session, ExerciseTab& tab) {
    const Task* const task = practice_.task();
    if (!aside_ || task == nullptr || followed_ == session.told()) { return; }
    followed_ = session.told();
    if (task->exercise().kind == ExerciseKind::experiment) {
        work_.experiments = session.tried();
    } else {
        tab.set_answer(text_to_save(session));
    }
}

void ExerciseDesk::follow_file(const LessonFile& file, ExerciseTab& tab) {
    if (!aside_ || work_.file.empty()) { return; }
    const FileText text = read_file_text(file.path(), kLargestWork);
    if (text.problem.empty()) { tab.set_answer(text.text); }
}

std::string ExerciseDesk::write_starter(const std::string& file) const {
    const Task* const task = practice_.task();
    if (task == nullptr || task->exercise().kind != ExerciseKind::code) { return {}; }
    return jw::write_starter(*task, file);
}

}  // namespace jw::host
