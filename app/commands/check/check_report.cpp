#include "app/commands/check/check_report.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

#include "app/panels/parts/characters.hpp"
#include "app/session/encoding/junit.hpp"
#include "app/session/output/json.hpp"
#include "app/session/wording/text_width.hpp"
#include "lessons/diagnostics/read_text.hpp"
#include "render/fonts/fonts.hpp"

namespace jw {

namespace {

/// "holds", "fails", "no claims" or "error".
const char* state_of(const CheckedLesson& lesson, const CheckStyle& style) {
    if (!lesson.error.empty()) { return "error"; }
    if (lesson.claims_nothing()) { return style.require_claims ? "fails" : "no claims"; }
    return lesson.failed() > 0 ? "fails" : "holds";
}

void write_claim(const ClaimResult& result, const CheckedLesson& lesson, std::ostream& out) {
    out << "  " << (result.holds ? "holds " : "FAILS ") << padded(result.moment, 18) << ' '
        << padded(result.subject, 22) << ' ';
    if (result.holds) {
        out << result.expected << '\n';
        return;
    }
    out << "expected " << result.expected << ", found " << result.found << '\n';
    out << "        " << lesson.file << ':' << result.span.line << ':' << result.span.column << '\n';
    if (!result.why.empty()) { out << "        " << result.why << '\n'; }
}

Json json_of(const ClaimResult& claim) {
    return {{"holds", claim.holds},       {"moment", claim.moment},     {"subject", claim.subject},
            {"expected", claim.expected}, {"found", claim.found},       {"why", claim.why},
            {"line", claim.span.line},    {"column", claim.span.column}};
}

Json json_of(const Diagnostic& diagnostic) {
    return {
        {"code", to_string(diagnostic.code)},
        {"severity", diagnostic.severity == Severity::error ? "error" : "warning"},
        {"line", diagnostic.span.line},
        {"column", diagnostic.span.column},
        {"message", diagnostic.message},
        {"hint", diagnostic.hint}};
}

Json json_of(const CheckedLesson& lesson, const CheckStyle& style) {
    Json claims = Json::array();
    for (const ClaimResult& claim : lesson.claims) { claims.push_back(json_of(claim)); }
    Json json{
        {"file", lesson.file},
        {"title", lesson.title},
        {"state", state_of(lesson, style)},
        {"held", lesson.held()},
        {"failed", lesson.failed()},
        {"not_judged", lesson.not_judged},
        {"claims", claims},
        {"error", lesson.error.empty() ? Json() : Json(lesson.error)}};
    for (const Diagnostic& diagnostic : lesson.diagnostics) {
        json["diagnostics"].push_back(json_of(diagnostic));
    }
    if (!lesson.tried.empty()) { json["tried"] = lesson.tried; }
    return json;
}

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
    return first != lesson.diagnostics.end() ? to_string(first->code) : "input";
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

std::string with_number(char32_t c, const std::string& text) {
    // the character as it is written in the text
    for (std::size_t k = 0; k < text.size(); ++k) {
        if ((static_cast<unsigned char>(text[k]) & 0xC0U) == 0x80U) { continue; }
        std::size_t end = k + 1;
        while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) { ++end; }
        const std::string one = text.substr(k, end - k);
        if (from_utf8(one).front() == c) {
            std::array<char, 12> number{};
            std::snprintf(number.data(), number.size(), "U+%04X", static_cast<unsigned>(c));
            return in_quotes(one) + " (" + number.data() + ')';
        }
    }
    return {};
}

}  // namespace

int CheckedLesson::held() const {
    return static_cast<int>(std::ranges::count_if(claims, &ClaimResult::holds));
}

void write_text(const CheckedLesson& lesson, const CheckStyle& style, std::ostream& out) {
    if (!lesson.error.empty()) { return; }
    for (const std::string& one : lesson.tried) { out << "tried: " << one << '\n'; }
    if (lesson.not_judged > 0) {
        out << "not judged: " << lesson.not_judged << (lesson.not_judged == 1 ? " claim" : " claims")
            << " about what was taken out\n";
    }
    if (lesson.claims_nothing()) {
        out << lesson.file << ": no claims\n";
        return;
    }
    out << lesson.file << ": " << lesson.held() << " of " << lesson.claims.size()
        << (lesson.claims.size() == 1 ? " claim holds" : " claims hold") << '\n';
    for (const ClaimResult& claim : lesson.claims) {
        if (!style.quiet || !claim.holds) { write_claim(claim, lesson, out); }
    }
}

void write_json(
    const std::vector<CheckedLesson>& lessons, const CheckStyle& style, int exit_status, std::ostream& out) {
    Json list = Json::array();
    for (const CheckedLesson& lesson : lessons) { list.push_back(json_of(lesson, style)); }
    const Json json{
        {"format", "jointwise check"},
        {"version", kJsonVersion},
        {"exit_status", exit_status},
        {"lessons", list}};
    out << json_document(json);
}

void write_junit(const std::vector<CheckedLesson>& lessons, const CheckStyle& style, std::ostream& out) {
    std::vector<JunitSuite> suites;
    for (const CheckedLesson& lesson : lessons) { suites.push_back(suite_of(lesson, style)); }
    out << junit_report("jointwise check", suites);
}

std::vector<Diagnostic> warnings_about_texts(const std::string& file, const std::vector<ReadText>& texts) {
    std::vector<Diagnostic> warnings = missing_translations(file, texts);
    std::string all;
    for (const ReadText& read : texts) {
        all += read.text.own();
        for (const auto& [tag, text] : read.text.translations()) { all += text; }
    }
    const std::u32string missing = render::characters_without_glyph(panels::characters_in(all));
    if (missing.empty()) { return warnings; }
    const std::string package = render::package_of_missing_chinese();
    std::string hint = "a box is shown in place of each; take other characters";
    if (!package.empty()) { hint = "install the Debian package " + package; }
    std::string list;
    constexpr std::size_t most = 8;
    for (std::size_t k = 0; k < missing.size() && k < most; ++k) {
        list += (k == 0 ? "" : ", ") + with_number(missing[k], all);
    }
    if (missing.size() > most) { list += " and " + std::to_string(missing.size() - most) + " more"; }
    warnings.push_back(
        {file, {}, Code::character, "no font has the characters " + list, hint, Severity::warning});
    return warnings;
}

}  // namespace jw
