#include "app/exercises/practice/starter.hpp"

#include <system_error>

#include "app/exercises/kinds.hpp"
#include "app/exercises/starters.hpp"
#include "app/session/wording/messages.hpp"
#include "lessons/write/writer.hpp"

namespace jw {

namespace fs = std::filesystem;

namespace {

/// Writes a file unless it exists. @return why it cannot be written
std::string write_new(const fs::path& file, const std::string& text) {
    std::error_code error;
    if (fs::exists(fs::symlink_status(file, error))) { return {}; }
    if (file.has_parent_path()) { fs::create_directories(file.parent_path(), error); }
    std::string problem;
    write_lesson_file(file, text, problem);
    return problem;
}

}  // namespace

std::string write_starter(const Task& task, const fs::path& file) {
    const std::string text = starter_text(task, file.extension().string());
    if (text.empty()) {
        return tr("Type the name of a file that ends in .py, .cpp, .m or .js into the field.");
    }
    fs::path input = file;
    input.replace_filename(file.stem().string() + "-input.json");
    std::string problem = write_new(file, text);
    if (problem.empty()) { problem = write_new(input, program_input(task)); }
    if (!problem.empty()) { return tr("The starter could not be written: {0}", problem); }
    return tr("The program is '{0}', its input '{1}'.", file.string(), input.filename().string());
}

}  // namespace jw
