#include "app/commands/check/check_report.hpp"

#include <algorithm>

#include "app/session/output/json.hpp"
#include "app/session/wording/text_width.hpp"

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
        {"code", std::string(entry_of(diagnostic.code).printed)},
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

}  // namespace jw
