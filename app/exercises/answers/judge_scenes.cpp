#include <algorithm>
#include <cmath>

#include "app/exercises/kinds.hpp"
#include "app/session/claims/checks.hpp"
#include "app/session/try/carry_out.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "lessons/exercise/scene_difference.hpp"
#include "lessons/exercise/scene_edits.hpp"
#include "lessons/read/reader.hpp"
#include "lessons/text/text.hpp"
#include "lessons/write/writer.hpp"

namespace jw {

namespace {

constexpr std::size_t kLargestHandedFile = 200000;
constexpr std::size_t kMostActions = 20;

// claims and texts can give the answer away
const std::vector<std::string> kNotHandedOut{"expect", "question", "try", "exercise", "step"};

std::string expected_of(const Exercise& exercise) {
    return exercise.expect.empty() ? claims_in(exercise.scene) : exercise.expect;
}

/// Feedback on a claim that does not hold.
std::string not_reached(const ClaimResult& result) {
    const std::string told = result.failure.empty()
                                 ? tr("Not met: {0} ({1}) is {2}; expected {3}.", result.subject,
                                      result.moment, result.found, result.expected)
                                 : tr("Not met ({0}): {1}", result.moment, result.failure);
    return followed(told, result.why);
}

/// Fraction of the points for a file that meets some of the claims. Claims that already hold in the file as
/// it is handed out earn nothing. Where there are also other claims, claims about counts alone earn nothing
/// either: any joints with as many equations satisfy them.
/// @param before   the file as it is handed out
/// @param results  of the claims of `lesson`
double share_of(
    const Lesson& lesson, const std::vector<ClaimResult>& results, const std::string& before,
    const Exercise& exercise) {
    const ReadResult read = read_lesson_with_claims(before, exercise.name + ".toml", expected_of(exercise));
    std::vector<ClaimResult> at_first = read.lesson ? check_claims(*read.lesson) : std::vector<ClaimResult>();
    at_first.resize(results.size());
    int gained = 0;
    int to_gain = 0;
    bool others_gained = false;
    bool others_to_gain = false;
    for (std::size_t k = 0; k < results.size(); ++k) {
        const bool is_count =
            k < lesson.claims.size() && std::holds_alternative<CountClaim>(lesson.claims[k].fact);
        const bool held = at_first[k].holds;
        gained += static_cast<int>(results[k].holds) - static_cast<int>(held);
        to_gain += held ? 0 : 1;
        others_gained = others_gained || (!is_count && !held && results[k].holds);
        others_to_gain = others_to_gain || (!is_count && !held);
    }
    const bool earns = gained > 0 && (others_gained || !others_to_gain);
    return earns ? static_cast<double>(gained) / to_gain : 0.0;
}

/// Judges the claims of a lesson file that somebody else wrote.
/// @param before  the file as it is handed out
void judge_claims(
    const std::string& file, const std::string& before, const Exercise& exercise, Judged& judged) {
    if (file.size() > kLargestHandedFile) {
        judged = not_understood(tr("The file is larger than 200 kB."));
        return;
    }
    const std::string name = exercise.name + ".toml";
    const ReadResult read = read_lesson_with_claims(file, name, expected_of(exercise));
    if (!read.lesson) {
        // a mistake in the file has a position; a missing part that the claims name has none
        const ReadResult alone = read_lesson_with_claims(file, name, "");
        judged = not_understood(
            alone.lesson
                ? tr("The file does not contain what the exercise asks for: {0}.",
                     read.diagnostics.front().message)
                : tr("The file is not a lesson: {0}", to_string(alone.diagnostics.front(), alone.source)));
        return;
    }
    const std::vector<ClaimResult> results = check_claims(*read.lesson);
    judged.right = !results.empty() && std::ranges::all_of(results, &ClaimResult::holds);
    judged.share = judged.right ? 1.0 : share_of(*read.lesson, results, before, exercise);
    for (const ClaimResult& result : results) {
        if (result.holds) { continue; }
        // if a pose is not reached, every claim gives the same message
        std::string said = not_reached(result);
        if (std::ranges::find(judged.feedback, said) == judged.feedback.end()) {
            judged.feedback.push_back(std::move(said));
        }
    }
}

std::string list_text_of(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) { text += (text.empty() ? "" : ", ") + name; }
    return text;
}

void name_mistake(Judged& judged, const char* name, std::string title, std::string says) {
    judged.right = false;
    judged.mistake = name;
    judged.title = std::move(title);
    judged.feedback.insert(judged.feedback.begin(), std::move(says));
}

void name_missing_joint(Judged& judged, std::size_t joints, std::size_t needed) {
    name_mistake(
        judged, "joint-missing", tr("a joint is missing"),
        tr_count(
            static_cast<int>(joints), "{0} joint was added; {1} are needed.",
            "{0} joints were added; {1} are needed.", needed));
}

/// Takes away a share of the points if more was used than needed.
/// @param says  message; {0} is what was used, {1} what is needed
void charge(Judged& judged, std::size_t used, std::size_t needed, const char* says) {
    if (used <= needed || judged.share == 0.0) { return; }
    judged.share *= static_cast<double>(std::max<std::size_t>(1, needed)) / static_cast<double>(used);
    if (judged.right) {
        name_mistake(
            judged, "more-than-needed", tr("more than needed"),
            tr(Message{says, {std::to_string(used), std::to_string(needed)}}));
    }
}

std::string without_key(const std::string& scene, const std::string& key) {
    const std::vector<SceneEdit> edits{{key, ""}};
    return with_edits(scene, edits).text;
}

/// "joint.B" of "joint.B.axis"
std::string table_of_key(const std::string& key) {
    const std::size_t first = key.find('.');
    return first == std::string::npos ? key : key.substr(0, key.find('.', first + 1));
}

bool is_addition(const std::string& path) {
    return path.starts_with("joint.") || path.starts_with("driver.");
}

std::string healthy(const Task& task) {
    return without_texts(without_tables(task.variant.scene, kNotHandedOut));
}

/// The difference from the file that was handed out. A program that saves a lesson writes the whole file
/// again: such a file is compared with the handed-out file, also written again.
SceneDifference difference_from_handed_out(const std::string& before, const std::string& after) {
    SceneDifference difference = difference_of(before, after);
    if (difference.count() == 0) { return difference; }
    const ReadResult read = read_lesson(before, "handed out");
    if (!read.lesson) { return difference; }
    SceneDifference other = difference_of(lesson_text(*read.lesson), after);
    return other.count() < difference.count() ? other : difference;
}

/// The lesson that experiments lead to. If one cannot be carried out: empty, and `judged` is not understood.
std::string state_after(const Task& task, const std::vector<std::string>& actions, Judged& judged) {
    Session session(task.variant.lesson, false);
    for (const std::string& action : actions) {
        const ExperimentResult result = carry_out(session, action);
        if (result.done) { continue; }
        judged = not_understood(tr("'{0}' cannot be carried out: {1}", action, result.said));
        return {};
    }
    return lesson_text(session.lesson());
}

std::string built(const Task& task) { return healthy(task) + "\n" + task.exercise().solution; }

}  // namespace

std::string handed_out(const Task& task) {
    const std::string scene = healthy(task);
    return with_edits(scene, task.exercise().spoil).text;
}

bool is_solved_already(const Task& task) {
    Judged judged;
    const std::string file = handed_out(task);
    judge_claims(file, file, task.exercise(), judged);
    return judged.right;
}

std::string spoiled_text(const Exercise& exercise) {
    std::vector<std::string> keys;
    for (const SceneEdit& edit : exercise.spoil) { keys.push_back(edit.key); }
    return tr("What was changed: {0}.", list_text_of(keys));
}

Handed right_repair(const Task& task) { return {healthy(task), {}}; }

std::vector<HandedMistake> mistaken_repairs(const Task& task) {
    const std::string sick = handed_out(task);
    std::vector<HandedMistake> all{{"unchanged", {sick, {}}}};
    for (const SceneEdit& edit : task.exercise().spoil) {
        const std::string table = table_of_key(edit.key);
        if (!is_addition(table) || value_in(sick, table).empty()) { continue; }
        const bool joint = table.starts_with("joint.");
        all.push_back({joint ? "joint-removed" : "driver-removed", {without_key(sick, table), {}}});
    }
    return all;
}

Judged judge_repair(const Task& task, const Handed& handed) {
    Judged judged;
    const std::string sick = handed_out(task);
    judge_claims(handed.text, sick, task.exercise(), judged);
    const SceneDifference difference = difference_from_handed_out(sick, handed.text);
    const bool is_toml = judged.understood || difference.count() > 0 || handed.text == sick;
    const auto removed = std::ranges::find_if(difference.removed, is_addition);
    if (is_toml && difference.count() == 0) {
        judged.share = 0.0;
        name_mistake(
            judged, "unchanged", tr("nothing was changed"),
            tr("No change affects the fault: the file is as wrong as before."));
    } else if (!judged.understood && removed == difference.removed.end()) {
        return judged;
    } else if (removed != difference.removed.end() && !judged.right) {
        const bool joint = removed->starts_with("joint.");
        judged.share = 0.0;
        name_mistake(
            judged, joint ? "joint-removed" : "driver-removed",
            joint ? tr("the joint was taken out") : tr("the driver was taken out"),
            tr("'{0}' was taken out. It must stay; repair it instead.", *removed));
    } else {
        charge(
            judged, difference.count(), static_cast<std::size_t>(task.exercise().most),
            tr_later("{0} values were changed; {1} would do."));
    }
    return judged;
}

Handed right_build(const Task& task) { return {built(task), {}}; }

std::vector<HandedMistake> mistaken_builds(const Task& task) {
    const std::string scene = healthy(task);
    std::vector<HandedMistake> all{{"unchanged", {scene, {}}}};
    const std::vector<std::string> added = difference_of(scene, built(task)).added;
    if (added.size() > 1) {
        for (const std::string& path : added) {
            if (is_addition(path)) { all.push_back({"joint-missing", {without_key(built(task), path), {}}}); }
        }
    }
    return all;
}

Judged judge_build(const Task& task, const Handed& handed) {
    Judged judged;
    const std::string scene = healthy(task);
    const SceneDifference difference = difference_from_handed_out(scene, handed.text);
    if (difference.count() == 0) {
        name_mistake(judged, "unchanged", tr("nothing was added"), tr("Nothing was added to the file."));
        return judged;
    }
    judge_claims(handed.text, scene, task.exercise(), judged);
    const auto joints = static_cast<std::size_t>(std::ranges::count_if(difference.added, is_addition));
    const auto needed = static_cast<std::size_t>(task.exercise().most);
    if (!judged.understood) {
        if (joints > 0 && joints < needed) { name_missing_joint(judged, joints, needed); }
        return judged;
    }
    if (!difference.changed.empty() || !difference.removed.empty()) {
        judged.share *= 0.5;
        std::vector<std::string> touched = difference.changed;
        touched.insert(touched.end(), difference.removed.begin(), difference.removed.end());
        name_mistake(
            judged, "scene-changed", tr("given parts were changed"),
            tr("Given parts were changed: {0}. Only add to the file.", list_text_of(touched)));
        return judged;
    }
    if (!judged.right && joints < needed) { name_missing_joint(judged, joints, needed); }
    charge(judged, joints, needed, tr_later("{0} joints were added; {1} would do."));
    return judged;
}

Handed right_experiment(const Task& task) { return {{}, task.exercise().does}; }

std::vector<HandedMistake> mistaken_experiments(const Task& task) {
    std::vector<HandedMistake> all{{"nothing-done", {}}};
    std::vector<std::string> fewer = task.exercise().does;
    if (fewer.size() > 1) {
        fewer.pop_back();
        all.push_back({"unfinished", {{}, fewer}});
    }
    return all;
}

Judged judge_experiment(const Task& task, const Handed& handed) {
    Judged judged;
    if (handed.list.empty()) {
        name_mistake(
            judged, "nothing-done", tr("nothing was done"), tr("There is no experiment in the list."));
        return judged;
    }
    if (handed.list.size() > kMostActions) {
        return not_understood(tr("There are more than {0} experiments.", kMostActions));
    }
    const std::string state = handed.text.empty() ? state_after(task, handed.list, judged) : handed.text;
    if (!judged.understood) { return judged; }
    judge_claims(state, handed_out(task), task.exercise(), judged);
    const auto needed = static_cast<std::size_t>(task.exercise().most);
    if (!judged.right && judged.understood && handed.list.size() < needed) {
        name_mistake(
            judged, "unfinished", tr("not there yet"),
            tr("The state that is asked for is not reached yet; it takes {0} experiments.", needed));
    }
    charge(judged, handed.list.size(), needed, tr_later("{0} experiments were made; {1} would do."));
    return judged;
}

}  // namespace jw
