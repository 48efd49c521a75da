#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "app/session/claims/checks.hpp"
#include "lessons/diagnostics.hpp"

/// Results of `jointwise check` and their forms: text, JSON, JUnit.
namespace jw {

/// Claims of one lesson, judged, or why there is nothing to judge.
struct CheckedLesson {
    std::string file;
    std::string title;
    std::vector<std::string> tried;   ///< experiments that were carried out first, in words
    int not_judged = 0;               ///< claims about what an experiment has taken out
    std::vector<ClaimResult> claims;  ///< in the order of the file
    std::string error;                ///< why the lesson was not checked, as on standard error; else empty
    std::vector<Diagnostic> diagnostics;  ///< what is wrong with its file

    int held() const;
    int failed() const { return static_cast<int>(claims.size()) - held(); }
    bool claims_nothing() const { return error.empty() && claims.empty(); }
};

/// How a report is written.
struct CheckStyle {
    bool quiet = false;           ///< of claims only those that fail; text only
    bool require_claims = false;  ///< a lesson without claims fails
};

/// Text of one lesson; nothing for one with an error.
void write_text(const CheckedLesson& lesson, const CheckStyle& style, std::ostream& out);
/// docs/command-line.md describes the keys.
void write_json(
    const std::vector<CheckedLesson>& lessons, const CheckStyle& style, int exit_status, std::ostream& out);
/// A testsuite per lesson, a testcase per claim.
void write_junit(const std::vector<CheckedLesson>& lessons, const CheckStyle& style, std::ostream& out);

}  // namespace jw
