#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "app/session/claims/checks.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/diagnostics/read_text.hpp"

/// Results of `jointwise check` and their forms: text, JSON, JUnit.
namespace jw {

/// The judged claims of one lesson, or why there is nothing to judge.
struct CheckedLesson {
    std::string file;
    std::string title;
    std::vector<std::string> tried;   ///< experiments that were carried out first, in words
    int not_judged = 0;               ///< claims about parts that an experiment has taken out
    std::vector<ClaimResult> claims;  ///< in the order of the file
    std::string error;                ///< why the lesson was not checked, as on standard error; else empty
    std::vector<Diagnostic> diagnostics;  ///< what is wrong with its file

    int held() const;
    int failed() const { return static_cast<int>(claims.size()) - held(); }
    bool claims_nothing() const { return error.empty() && claims.empty(); }
};

/// Style of a report.
struct CheckStyle {
    bool quiet = false;           ///< the text has only claims that fail; no effect on JSON and JUnit
    bool require_claims = false;  ///< a lesson without claims fails
};

/// Writes the text for one lesson; nothing if it has an error.
void write_text(const CheckedLesson& lesson, const CheckStyle& style, std::ostream& out);
/// The keys are described in docs/command-line.md.
void write_json(
    const std::vector<CheckedLesson>& lessons, const CheckStyle& style, int exit_status, std::ostream& out);
/// One testsuite per lesson, one testcase per claim.
void write_junit(const std::vector<CheckedLesson>& lessons, const CheckStyle& style, std::ostream& out);

/// Warnings about the texts of a file: texts missing in a language, and characters that no font has.
std::vector<Diagnostic> warnings_about_texts(const std::string& file, const std::vector<ReadText>& texts);

}  // namespace jw
