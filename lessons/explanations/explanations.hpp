#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lessons/codes.hpp"
#include "lessons/diagnostics.hpp"

/// Pages about the codes of diagnostics: cause, cure, and an example, wrong and mended.
namespace jw {

/// Page about a code.
struct Explanation {
    /// What an example is.
    enum class Setting {
        whole,   ///< a whole lesson
        head,    ///< the beginning of the lesson about a crank and a slider
        behind,  ///< tables behind that lesson
        masses,  ///< tables behind that lesson, whose bodies have masses
        course,  ///< a course.toml
        path,    ///< a path from the folder of the project, as a command takes it
    };

    Code code{};
    std::string cause;
    std::string cure;
    Setting setting = Setting::behind;
    std::string wrong;  ///< gives a diagnostic with this code
    std::string right;  ///< the same, mended: gives none
};

/// All pages, in the order of the codes.
const std::vector<Explanation>& explanations();
/// nullptr if there is no page about the code.
const Explanation* explanation_of(Code code);

/// The file that an example, `wrong` or `right`, stands for.
std::string text_of_example(Explanation::Setting setting, const std::string& example);
/// What the reader says of it. @param folder  of the project, for paths
std::vector<Diagnostic> read_example(
    Explanation::Setting setting, const std::string& example, const std::string& folder = {});

/// What the codes with the same hundreds are about: "The file", "Keys and types".
std::string_view group_of(Code code);

}  // namespace jw
