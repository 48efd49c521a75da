#include "app/session/encoding/junit.hpp"
#include "app/snapshot/reports.hpp"

namespace jw::snapshot {

namespace {

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

std::string junit_of(const std::vector<LessonResult>& results) {
    std::vector<JunitSuite> suites;
    for (const LessonResult& result : results) { suites.push_back(suite_of(result)); }
    return junit_report("jointwise snapshot", suites);
}

}  // namespace jw::snapshot
