#include <algorithm>

#include "app/commands/check/check_report.hpp"
#include "app/session/encoding/junit.hpp"

namespace jw {

namespace {

/// A claim in words that do not depend on whether it holds: programs compare runs by these names.
std::string name_of(const ClaimResult& claim) {
    return claim.moment + ": " + claim.subject + ' ' + claim.expected;
}

void add_claim(const ClaimResult& claim, const std::string& file, JunitSuite& suite) {
    if (claim.holds) {
        suite.passed(name_of(claim));
        return;
    }
    std::string text = file + ':' + std::to_string(claim.span.line) + ':' + std::to_string(claim.span.column);
    if (!claim.why.empty()) { text += '\n' + claim.why; }
    suite.failed(name_of(claim), "claim", "expected " + claim.expected + ", found " + claim.found, text);
}

/// The code of the first mistake in the file, or of another reason why it cannot be checked.
std::string type_of_error(const CheckedLesson& lesson) {
    const auto first = std::ranges::find(lesson.diagnostics, Severity::error, &Diagnostic::severity);
    return first != lesson.diagnostics.end() ? std::string(entry_of(first->code).printed) : "input";
}

JunitSuite suite_of(const CheckedLesson& lesson, const CheckStyle& style) {
    JunitSuite suite(lesson.file);
    if (!lesson.error.empty()) {
        suite.error(
            "the lesson can be checked", type_of_error(lesson),
            lesson.error.substr(0, lesson.error.find('\n')), lesson.error);
    } else if (lesson.claims_nothing() && style.require_claims) {
        suite.failed("the lesson has claims", "claim", "no claims");
    } else if (lesson.claims_nothing()) {
        suite.skipped("the lesson has claims", "no claims");
    }
    for (const ClaimResult& claim : lesson.claims) { add_claim(claim, lesson.file, suite); }
    return suite;
}

}  // namespace

void write_junit(const std::vector<CheckedLesson>& lessons, const CheckStyle& style, std::ostream& out) {
    std::vector<JunitSuite> suites;
    for (const CheckedLesson& lesson : lessons) { suites.push_back(suite_of(lesson, style)); }
    out << junit_report("jointwise check", suites);
}

}  // namespace jw
