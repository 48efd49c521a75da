#include <algorithm>

#include "app/session/encoding/xml_text.hpp"
#include "app/snapshot/reports.hpp"

namespace jw::snapshot {

namespace {

struct Counts {
    std::size_t tests = 0;
    std::size_t failures = 0;
    std::size_t errors = 0;
    std::size_t skipped = 0;

    std::string attributes() const {
        return " tests=\"" + std::to_string(tests) + "\" failures=\"" + std::to_string(failures) +
               "\" errors=\"" + std::to_string(errors) + "\" skipped=\"" + std::to_string(skipped) + "\"";
    }
};

Counts counts_of(const LessonResult& result) {
    if (!result.problem.empty()) { return {1, 0, 1, 0}; }
    const auto& [made, skipped] = result.controls;
    Counts counts{result.snapshots.size() + made.size() + skipped.size(), 0, 0, skipped.size()};
    for (const SnapshotResult& snapshot : result.snapshots) {
        counts.failures += fails(snapshot.verdict) ? 1U : 0U;
    }
    for (const bool one : {result.is_deleted, !result.steps_line().empty()}) {
        counts.tests += one ? 1U : 0U;
        counts.failures += one ? 1U : 0U;
    }
    for (const ControlResult& control : made) { counts.failures += control.noticed ? 0U : 1U; }
    return counts;
}

/// A testcase, with `verdict` in it; empty: it has passed.
std::string case_of(const LessonResult& result, const std::string& name, const std::string& verdict) {
    const std::string head = "    <testcase classname=\"" + xml_attribute(result.lesson.name) + "\" name=\"" +
                             xml_attribute(name) + "\"";
    return verdict.empty() ? head + "/>\n" : head + ">\n      " + verdict + "\n    </testcase>\n";
}

std::string failure_of(const LessonResult& result, const SnapshotResult& snapshot) {
    if (!fails(snapshot.verdict)) { return {}; }
    std::string body;
    for (const std::string& reason : reasons_of(snapshot)) { body += reason + "\n"; }
    for (const FactChange& change : snapshot.difference.facts) {
        body += change.name + ": " + change.before + " → " + change.after + "\n";
    }
    return std::string("<failure type=\"") + word_of(snapshot.verdict) + "\" message=\"" +
           xml_attribute(result.explanation()) + "\">" + xml_text(body) + "</failure>";
}

std::string suite_of(const LessonResult& result) {
    std::string text = "  <testsuite name=\"" + xml_attribute(result.lesson.name) + "\"" +
                       counts_of(result).attributes() + ">\n";
    if (!result.problem.empty()) {
        text += case_of(
            result, "the lesson can be compared",
            "<error type=\"input\" message=\"cannot be compared\">" + xml_text(result.problem) + "</error>");
    }
    if (result.is_deleted) {
        text += case_of(
            result, "the lesson is there",
            "<failure type=\"deleted\" message=\"" + xml_attribute(result.explanation()) + "\"/>");
    }
    if (const std::string steps = result.steps_line(); !steps.empty()) {
        text += case_of(
            result, "number of steps", "<failure type=\"steps\" message=\"" + xml_attribute(steps) + "\"/>");
    }
    for (const SnapshotResult& snapshot : result.snapshots) {
        text += case_of(result, snapshot.name, failure_of(result, snapshot));
    }
    const auto name_of = [](const auto& control) {
        return "negative control: " + control.fault + " (" + control.layer + ")";
    };
    for (const ControlResult& control : result.controls.made) {
        const std::string blind =
            "<failure type=\"blind\" message=\"not noticed by " + control.layer + "\"/>";
        text += case_of(result, name_of(control), control.noticed ? "" : blind);
    }
    for (const SkippedControl& control : result.controls.skipped) {
        text +=
            case_of(result, name_of(control), "<skipped message=\"" + xml_attribute(control.reason) + "\"/>");
    }
    return text + "  </testsuite>\n";
}

}  // namespace

std::string junit_of(const std::vector<LessonResult>& results) {
    Counts all;
    std::string suites;
    for (const LessonResult& result : results) {
        const Counts counts = counts_of(result);
        all.tests += counts.tests;
        all.failures += counts.failures;
        all.errors += counts.errors;
        all.skipped += counts.skipped;
        suites += suite_of(result);
    }
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"jointwise snapshot\"" +
           all.attributes() + ">\n" + suites + "</testsuites>\n";
}

}  // namespace jw::snapshot
