#include "app/session/try/trials.hpp"

#include "app/session/story/sentences.hpp"
#include "app/session/try/carry_out.hpp"
#include "app/session/wording/explanations.hpp"
#include "app/session/wording/messages.hpp"
#include "lessons/math/text_parts.hpp"

namespace jw {

namespace {

ClaimResult result_of(const Trial& trial, const Lesson& lesson) {
    ClaimResult result;
    result.span = trial.span;
    result.why = math::plain_words(trial.text);
    result.moment = "try";
    result.expected = trial.breaks ? tr("can be carried out") : tr("can be carried out and goes to its end");
    Session session(lesson);
    for (const std::string& action : trial.actions) {
        result.subject += (result.subject.empty() ? "" : ", ") + action;
        const ExperimentResult done = carry_out(session, action);
        if (!done.done) {
            result.found = "'" + action + "': " + done.said;
            return result;
        }
    }
    const Step* const failed = session.story().failure();
    result.holds = trial.breaks || failed == nullptr;
    if (!result.holds) { result.found = failed->failure ? failure_text(*failed) : failed->ended; }
    return result;
}

}  // namespace

std::vector<ClaimResult> check_trials(const Lesson& lesson) {
    std::vector<ClaimResult> results;
    for (const Trial& trial : lesson.trials) { results.push_back(result_of(trial, lesson)); }
    return results;
}

}  // namespace jw
