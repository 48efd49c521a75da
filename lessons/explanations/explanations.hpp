#pragma once

#include <string>
#include <vector>

#include "lessons/diagnostics/codes.hpp"
#include "lessons/diagnostics/diagnostics.hpp"

/// Pages about the codes of diagnostics: cause, remedy, and an example, wrong and corrected.
namespace jw {

/// Page about a code.
struct Explanation {
    /// What an example consists of.
    enum class Setting {
        whole,   ///< a whole lesson
        head,    ///< the beginning of the lesson about a crank and a slider
        behind,  ///< tables that follow that lesson
        masses,  ///< tables that follow that lesson, in which the bodies have masses
        course,  ///< a course.toml
        path,    ///< a path from the folder of the project, as a command takes it
    };

    Code code = Code::file_unreadable;
    std::string cause;
    std::string cure;
    Setting setting = Setting::behind;
    std::string wrong;  ///< gives a diagnostic with this code
    std::string right;  ///< the same, corrected: gives none
};

/// All pages, in the order of the codes.
const std::vector<Explanation>& explanations();
/// What a code means, in a few words; the same everywhere.
const std::string& title_of(Code code);
/// nullptr if there is no page about the code.
const Explanation* explanation_of(Code code);

/// The complete file of an example, `wrong` or `right`.
std::string text_of_example(Explanation::Setting setting, const std::string& example);
/// Diagnostics that reading the example gives. @param folder  of the project, for paths
std::vector<Diagnostic> read_example(
    Explanation::Setting setting, const std::string& example, const std::string& folder = {});

}  // namespace jw
