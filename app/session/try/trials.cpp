#include "app/session/try/trials.hpp"

#include "app/session/story/sentences.hpp"
#include "app/session/try/carry_out.hpp"
#include "app/session/wording/explanations.hpp"
#include "app/session/wording/messages.hpp"
#include "lessons/math/text_parts.hpp"

namespace jw {

namespace {

/// Freedoms of what is assembled at the end of a story.
int freedoms_of(const Story& story) { return rank_of(story.steps()[at(story.last_assembled())]).dof; }

/// Judges whether the story after the experiments is as the author says.
void judge(const Trial& trial, int freedoms_before, const Story& story, ClaimResult& result) {
    const Step* const failed = story.failure();
    if (trial.breaks) {
        const int freedoms = failed == nullptr ? freedoms_of(story) : 0;
        result.holds = failed != nullptr || freedoms > freedoms_before;
        if (!result.holds) {
            result.found = tr_count(
                freedoms, "it goes to its end, with {0} freedom", "it goes to its end, with {0} freedoms");
        }
        return;
    }
    result.holds = failed == nullptr;
    if (failed != nullptr) { result.found = failed->failure ? failure_text(*failed) : failed->ended; }
}

ClaimResult result_of(const Trial& trial, const Lesson& lesson) {
    ClaimResult result;
    result.span = trial.span;
    result.why = math::plain_words(trial.text);
    result.moment = "try";
    result.expected = trial.breaks ? tr("breaks the scene: it fails, or has more freedoms")
                                   : tr("can be carried out, and the lesson still runs to its end");
    Session session(lesson);
    const int freedoms_before = trial.breaks ? freedoms_of(session.story()) : 0;
    for (const std::string& action : trial.actions) {
        result.subject += (result.subject.empty() ? "" : ", ") + action;
        const ExperimentResult done = carry_out(session, action);
        if (!done.done) {
            result.found = "'" + action + "': " + done.said;
            return result;
        }
    }
    judge(trial, freedoms_before, session.story(), result);
    return result;
}

}  // namespace

std::vector<ClaimResult> check_trials(const Lesson& lesson) {
    std::vector<ClaimResult> results;
    for (const Trial& trial : lesson.trials) { results.push_back(result_of(trial, lesson)); }
    return results;
}

}  // namespace jw
