#pragma once

#include <string>

namespace jw::exercises {

struct Language;

/// The program of a student as it was when it was read; what happens to the file afterwards does not matter.
struct StudentProgram {
    std::string file;  ///< its name without folder
    std::string source;
    const Language* language = nullptr;
};

/// A program, or one sentence why there is none.
struct ProgramSearch {
    enum class Outcome { found, absent, refused };
    Outcome outcome = Outcome::absent;
    StudentProgram program;  ///< if found
    std::string reason;      ///< if not
};

/// The program of an exercise in the folder of a student: NAME with the extension of a language. Two of them
/// are refused, as is what is no plain file of at most 1 MB: a symbolic link, also of the folder itself,
/// would show what the student may not read.
ProgramSearch find_program(const std::string& folder, const std::string& exercise);

/// One file; its extension tells the language.
ProgramSearch read_program(const std::string& path);

}  // namespace jw::exercises
