#include "app/exercises/starters.hpp"

#include <algorithm>
#include <system_error>

#include "app/exercises/kinds.hpp"
#include "app/exercises/starters/starter_texts.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/text_width.hpp"
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

std::string starter_text(const Task& task, std::string_view ending) {
    const auto* const found =
        std::ranges::find(kStarterTexts, ending, [](const auto& entry) { return entry.first; });
    if (found == kStarterTexts.end()) { return {}; }
    std::string text(found->second);
    const std::size_t begin = text.rfind('\n', text.find("NAME")) + 1;
    const std::string line = text.substr(begin, text.find('\n', begin) + 1 - begin);
    std::string inputs;
    for (const std::string& name : input_names(task.exercise())) { inputs += replaced(line, "NAME", name); }
    return text.replace(begin, line.size(), inputs);
}

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
