#include <algorithm>
#include <array>
#include <functional>

#include "app/session/encoding/junit.hpp"
#include "app/session/wording/numbers.hpp"
#include "app/snapshot/reports.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/lesson/enum_words.hpp"
#include "lessons/text/utf8.hpp"

namespace jw::snapshot {

namespace {

constexpr std::array kVerdicts{
    EnumWord{Verdict::same, "same"},         EnumWord{Verdict::drawn_otherwise, "drawn otherwise"},
    EnumWord{Verdict::differs, "different"}, EnumWord{Verdict::is_new, "new"},
    EnumWord{Verdict::gone, "gone"},         EnumWord{Verdict::broken, "broken"}};

// in the text; the page shows all
constexpr std::size_t kMostFacts = 8;
constexpr std::size_t kMostSnapshots = 3;

std::string fact_text(const FactChange& change) {
    if (change.before.empty()) { return change.name + ": " + change.after + " (was not there)"; }
    if (change.after.empty()) { return change.name + ": gone (was " + change.before + ")"; }
    return change.name + ": " + change.before + " → " + change.after;
}

/// A line of the report; a golden file may hold any character.
std::string line_of(const std::string& indent, const std::string& text) {
    return indent + printable(text) + "\n";
}

std::string more_text(std::size_t others) {
    return others == 0 ? "" : " (and " + std::to_string(others) + " more)";
}

std::string describe(const SnapshotResult& snapshot) {
    std::string text = line_of("  ", snapshot.name + ": " + word_of(snapshot.verdict));
    for (const std::string& reason : reasons_of(snapshot)) { text += line_of("    ", reason); }
    const std::vector<FactChange>& facts = snapshot.difference.facts;
    for (std::size_t k = 0; k < std::min(facts.size(), kMostFacts); ++k) {
        text += line_of("      ", fact_text(facts[k]));
    }
    if (facts.size() > kMostFacts) {
        text += "      and " + std::to_string(facts.size() - kMostFacts) + " more\n";
    }
    for (const std::string& thing : snapshot.difference.things) { text += line_of("      ", thing); }
    return text;
}

/// Snapshots in the order of the story, but first those of steps that fail or are gone.
std::vector<std::reference_wrapper<const SnapshotResult>> by_weight(
    const std::vector<SnapshotResult>& snapshots) {
    std::vector<std::reference_wrapper<const SnapshotResult>> sorted(snapshots.begin(), snapshots.end());
    std::ranges::stable_partition(
        sorted, [](const SnapshotResult& s) { return s.failed || s.verdict == Verdict::gone; });
    return sorted;
}

std::string controls_text(const LessonResult& result) {
    std::string text;
    for (const SkippedControl& control : result.controls.skipped) {
        text += "  negative control not made here: " + control.fault + " (" + control.layer +
                "): " + control.reason + "\n";
    }
    if (result.controls.made.empty()) { return text; }
    std::size_t noticed = 0;
    for (const ControlResult& control : result.controls.made) {
        noticed += control.noticed ? 1U : 0U;
        if (!control.noticed) {
            text += "  BLIND: " + control.fault + ", and the layer of " + control.layer +
                    " does not notice; expected stricter rules\n";
        }
    }
    return "  negative controls: " + std::to_string(noticed) + " of " +
           std::to_string(result.controls.made.size()) + " noticed\n" + text;
}

Json json_of(const FactChange& change) {
    return {{"name", change.name}, {"before", change.before}, {"after", change.after}};
}

Json json_of(const SnapshotResult& result) {
    Json facts = Json::array();
    for (const FactChange& change : result.difference.facts) { facts.push_back(json_of(change)); }
    return {
        {"name", result.name},
        {"title", result.title},
        {"verdict", word_of(result.verdict)},
        {"fails", fails(result.verdict)},
        {"reasons", reasons_of(result)},
        {"facts", std::move(facts)},
        {"things", result.difference.things}};
}

void add_snapshot(const LessonResult& result, const SnapshotResult& snapshot, JunitSuite& suite) {
    if (!fails(snapshot.verdict)) {
        suite.passed(snapshot.name);
        return;
    }
    std::string text;
    for (const std::string& reason : reasons_of(snapshot)) { text += reason + "\n"; }
    for (const FactChange& change : snapshot.difference.facts) {
        text += change.name + ": " + change.before + " → " + change.after + "\n";
    }
    suite.failed(snapshot.name, word_of(snapshot.verdict), result.explanation(), text);
}

JunitSuite suite_of(const LessonResult& result) {
    JunitSuite suite(result.lesson.name);
    if (!result.problem.empty()) {
        suite.error("the lesson can be compared", "input", "cannot be compared", result.problem);
        return suite;
    }
    if (result.is_deleted) { suite.failed("the lesson is there", "deleted", result.explanation()); }
    if (const std::string steps = result.steps_line(); !steps.empty()) {
        suite.failed("number of steps", "steps", steps);
    }
    for (const SnapshotResult& snapshot : result.snapshots) { add_snapshot(result, snapshot, suite); }
    const auto name_of = [](const auto& control) {
        return "negative control: " + control.fault + " (" + control.layer + ")";
    };
    for (const ControlResult& control : result.controls.made) {
        if (control.noticed) {
            suite.passed(name_of(control));
        } else {
            suite.failed(name_of(control), "blind", "not noticed by " + control.layer);
        }
    }
    for (const SkippedControl& control : result.controls.skipped) {
        suite.skipped(name_of(control), control.reason);
    }
    return suite;
}

}  // namespace

const char* word_of(Verdict verdict) { return jw::word_of(kVerdicts, verdict); }

std::vector<std::string> reasons_of(const SnapshotResult& result) {
    const Difference& d = result.difference;
    std::vector<std::string> reasons;
    const auto add = [&](const std::string& reason) { reasons.push_back(reason); };
    switch (result.verdict) {
        case Verdict::same: return reasons;
        case Verdict::is_new: add("there is no golden snapshot of it; 'snapshot record' takes it"); break;
        case Verdict::gone: add("the lesson has no such step any more; 'snapshot bless' removes it"); break;
        case Verdict::broken: add(result.problem); break;
        case Verdict::differs:
        case Verdict::drawn_otherwise: break;
    }
    if (!d.facts.empty()) {
        add("text: " +
            count_text(static_cast<int>(d.facts.size()), "fact has changed", "facts have changed"));
    }
    if (!d.loose.empty()) {
        add("BLIND: tolerances of the golden file are more than " + short_number(kMostOfTolerance) +
            " times those of the program: " + d.loose.front() + more_text(d.loose.size() - 1));
    }
    if (!d.ids.broken.empty()) { add("ids: " + d.ids.broken); }
    if (!d.depth.broken.empty()) { add("depth: " + d.depth.broken); }
    if (!d.colour.broken.empty()) {
        add("colours: " + d.colour.broken +
            (d.drawn_otherwise.empty() ? "" : " (do not count: " + d.drawn_otherwise + ")"));
    }
    return reasons;
}

std::string describe(const LessonResult& result) {
    std::string text = result.lesson.name + ": ";
    if (!result.problem.empty()) { return text + "error: " + result.problem + "\n"; }
    const auto same = std::ranges::count(result.snapshots, Verdict::same, &SnapshotResult::verdict);
    text += std::to_string(same) + " of " +
            count_text(static_cast<int>(result.snapshots.size()), "snapshot", "snapshots") + " same\n";
    if (const std::string line = result.explanation(); !line.empty()) {
        text += line_of("  ", "why: " + line);
    }
    if (const std::string steps = result.steps_line(); !steps.empty() && steps != result.explanation()) {
        text += "  " + steps + "\n";
    }
    std::size_t told = 0;
    std::string others;
    for (const SnapshotResult& snapshot : by_weight(result.snapshots)) {
        if (snapshot.verdict == Verdict::same) { continue; }
        if (told++ < kMostSnapshots) {
            text += describe(snapshot);
        } else {
            others += (others.empty() ? "" : ", ") + snapshot.name;
        }
    }
    if (!others.empty()) { text += line_of("  ", "likewise not the same: " + others); }
    return text + controls_text(result);
}

std::string summary(const std::vector<LessonResult>& results) {
    int snapshots = 0;
    std::array<int, kVerdicts.size()> counts{};
    int problems = 0;
    int deleted = 0;
    int other_steps = 0;
    int blind = 0;
    for (const LessonResult& result : results) {
        problems += result.problem.empty() ? 0 : 1;
        deleted += result.is_deleted ? 1 : 0;
        other_steps += result.steps_line().empty() ? 0 : 1;
        for (const ControlResult& control : result.controls.made) { blind += control.noticed ? 0 : 1; }
        for (const SnapshotResult& snapshot : result.snapshots) {
            ++snapshots;
            ++counts[static_cast<std::size_t>(snapshot.verdict)];
        }
    }
    std::string text = count_text(static_cast<int>(results.size()), "lesson", "lessons") + ", " +
                       count_text(snapshots, "snapshot", "snapshots") + ":";
    const char* separator = " ";
    for (std::size_t k = 0; k < counts.size(); ++k) {
        if (counts[k] == 0) { continue; }
        text += separator + std::to_string(counts[k]) + ' ' + kVerdicts[k].word;
        separator = ", ";
    }
    if (deleted > 0) {
        text += separator + count_text(deleted, "lesson is deleted", "lessons are deleted");
        separator = ", ";
    }
    if (other_steps > 0) {
        text += separator + count_text(
                                other_steps, "lesson has another number of steps",
                                "lessons have another number of steps");
        separator = ", ";
    }
    if (problems > 0) {
        text += separator + count_text(problems, "lesson cannot be compared", "lessons cannot be compared");
    }
    if (blind > 0) {
        text +=
            "; " + count_text(blind, "negative control is not noticed", "negative controls are not noticed");
    }
    return text;
}

Json json_of(const std::vector<LessonResult>& results) {
    Json lessons = Json::array();
    bool any = false;
    for (const LessonResult& result : results) {
        any = any || result.fails();
        Json snapshots = Json::array();
        for (const SnapshotResult& snapshot : result.snapshots) { snapshots.push_back(json_of(snapshot)); }
        Json controls = Json::array();
        for (const ControlResult& control : result.controls.made) {
            controls.push_back(
                {{"fault", control.fault}, {"layer", control.layer}, {"noticed", control.noticed}});
        }
        Json skipped = Json::array();
        for (const SkippedControl& control : result.controls.skipped) {
            skipped.push_back(
                {{"fault", control.fault}, {"layer", control.layer}, {"reason", control.reason}});
        }
        lessons.push_back(
            {{"name", result.lesson.name},
             {"file", result.lesson.file.string()},
             {"title", result.title},
             {"fails", result.fails()},
             {"problem", result.problem},
             {"why", result.explanation()},
             {"deleted", result.is_deleted},
             {"steps", result.steps_line()},
             {"lesson_changes", result.lesson_changes},
             {"snapshots", std::move(snapshots)},
             {"controls", std::move(controls)},
             {"controls_skipped", std::move(skipped)}});
    }
    return {
        {"format", "jointwise snapshot report"},
        {"version", kJsonVersion},
        {"fails", any},
        {"summary", summary(results)},
        {"lessons", std::move(lessons)}};
}

std::string junit_of(const std::vector<LessonResult>& results) {
    std::vector<JunitSuite> suites;
    for (const LessonResult& result : results) { suites.push_back(suite_of(result)); }
    return junit_report("jointwise snapshot", suites);
}

}  // namespace jw::snapshot
