#pragma once

#include <string>

namespace jw::exercises {

struct Language;

/// The program of a student as it was read; later changes of the file have no effect.
struct StudentProgram {
    std::string file;  ///< its name without folder
    std::string source;
    const Language* language = nullptr;
};

/// A program, or one sentence that says why there is none.
struct ProgramSearch {
    enum class Outcome { found, absent, refused };
    Outcome outcome = Outcome::absent;
    StudentProgram program;  ///< if found
    std::string reason;      ///< if not
};

/// The program of an exercise in the folder of a student: NAME with the extension of a language. Two of them
/// are refused, and so is everything that is not a regular file of at most 1 MB. Symbolic links, also of the
/// folder itself, are refused because they could show files that the student may not read.
ProgramSearch find_program(const std::string& folder, const std::string& exercise);

/// The program in one file; its extension tells the language.
ProgramSearch read_program(const std::string& path);

}  // namespace jw::exercises
