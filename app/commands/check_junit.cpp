#include <algorithm>

#include "app/commands/check_report.hpp"
#include "app/session/encoding/xml_text.hpp"

namespace jw {

namespace {

/// A claim in words that stay the same whether it holds or not: programs compare runs by them.
std::string name_of(const ClaimResult& claim) {
    return claim.moment + ": " + claim.subject + ' ' + claim.expected;
}

/// A testcase, with `verdict` in it; empty: it has passed.
void write_case(
    const std::string& file, const std::string& name, const std::string& verdict, std::ostream& out) {
    out << "    <testcase classname=\"" << xml_attribute(file) << "\" name=\"" << xml_attribute(name) << '"';
    if (verdict.empty()) {
        out << "/>\n";
        return;
    }
    out << ">\n      " << verdict << "\n    </testcase>\n";
}

std::string failure_of(const ClaimResult& claim, const std::string& file) {
    std::string text = file + ':' + std::to_string(claim.span.line) + ':' + std::to_string(claim.span.column);
    if (!claim.why.empty()) { text += '\n' + claim.why; }
    return "<failure type=\"claim\" message=\"" +
           xml_attribute("expected " + claim.expected + ", found " + claim.found) + "\">" + xml_text(text) +
           "</failure>";
}

/// The code of the first mistake in the file, or what else keeps it from being checked.
std::string type_of_error(const CheckedLesson& lesson) {
    const auto first = std::ranges::find(lesson.diagnostics, Severity::error, &Diagnostic::severity);
    return first != lesson.diagnostics.end() ? std::string(entry_of(first->code).printed) : "input";
}

struct Counts {
    int tests = 0;
    int failures = 0;
    int errors = 0;
    int skipped = 0;
};

Counts counts_of(const CheckedLesson& lesson, const CheckStyle& style) {
    if (!lesson.error.empty()) { return {1, 0, 1, 0}; }
    if (lesson.claims_nothing()) {
        return {1, style.require_claims ? 1 : 0, 0, style.require_claims ? 0 : 1};
    }
    return {static_cast<int>(lesson.claims.size()), lesson.failed(), 0, 0};
}

std::string attributes(const Counts& counts) {
    return " tests=\"" + std::to_string(counts.tests) + "\" failures=\"" + std::to_string(counts.failures) +
           "\" errors=\"" + std::to_string(counts.errors) + '"';
}

void write_suite(const CheckedLesson& lesson, const CheckStyle& style, std::ostream& out) {
    const Counts counts = counts_of(lesson, style);
    out << "  <testsuite name=\"" << xml_attribute(lesson.file) << '"' << attributes(counts) << " skipped=\""
        << counts.skipped << "\">\n";
    if (!lesson.error.empty()) {
        const std::string first_line = lesson.error.substr(0, lesson.error.find('\n'));
        write_case(
            lesson.file, "the lesson can be checked",
            "<error type=\"" + type_of_error(lesson) + "\" message=\"" + xml_attribute(first_line) + "\">" +
                xml_text(lesson.error) + "</error>",
            out);
    } else if (lesson.claims_nothing()) {
        write_case(
            lesson.file, "the lesson has claims",
            style.require_claims ? "<failure type=\"claim\" message=\"no claims\"/>"
                                 : "<skipped message=\"no claims\"/>",
            out);
    }
    for (const ClaimResult& claim : lesson.claims) {
        write_case(lesson.file, name_of(claim), claim.holds ? "" : failure_of(claim, lesson.file), out);
    }
    out << "  </testsuite>\n";
}

}  // namespace

void write_junit(const std::vector<CheckedLesson>& lessons, const CheckStyle& style, std::ostream& out) {
    Counts all;
    for (const CheckedLesson& lesson : lessons) {
        const Counts counts = counts_of(lesson, style);
        all.tests += counts.tests;
        all.failures += counts.failures;
        all.errors += counts.errors;
    }
    out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    out << "<testsuites name=\"jointwise check\"" << attributes(all) << ">\n";
    for (const CheckedLesson& lesson : lessons) { write_suite(lesson, style, out); }
    out << "</testsuites>\n";
}

}  // namespace jw
