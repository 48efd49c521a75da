#include "app/session/story/story_telling.hpp"

/// Questions within a story.
namespace jw {

std::optional<Addition> subject_of(const Lesson& lesson, const Step& step) {
    if (step.additions == 0 || step.kind == Step::Kind::motion) { return std::nullopt; }
    if (step.kind == Step::Kind::question) { return std::nullopt; }
    const bool of_addition =
        step.kind != Step::Kind::answer || question_of(lesson, step).place == Question::Place::addition;
    if (!of_addition) { return std::nullopt; }
    return lesson.order[static_cast<std::size_t>(step.additions - 1)];
}

/// Adds the questions (or the answers) that belong here, at the pose of the last step.
void StoryTelling::ask(Question::Place place, const Addition* added, Step::Kind kind) {
    // a story of poses alone has no questions
    if (!options_.keep_steps) { return; }
    for (std::size_t k = 0; k < lesson_->questions.size(); ++k) {
        const Question& question = lesson_->questions[k];
        const bool here = question.place == place && (added == nullptr || question.addition == *added);
        if (!here || !applies(question, *lesson_)) { continue; }
        Step step = told_->steps.back();
        step.kind = kind;
        step.question = static_cast<int>(k);
        step.choices.clear();
        step.events.clear();
        step.note.clear();
        step.rows_switched = step.change_point = false;
        step.rank_before = nullptr;
        told_->steps.push_back(std::move(step));
    }
}

}  // namespace jw
