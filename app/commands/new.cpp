#include <algorithm>
#include <filesystem>
#include <string_view>

#include "app/commands/new_lesson.hpp"
#include "app/commands/program/add_command.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/files/course.hpp"
#include "lessons/read/reader.hpp"
#include "lessons/typed/exact_text.hpp"
#include "lessons/write/writer.hpp"

namespace jw {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kTitleOfTemplate = "\"A new lesson\"";

/// "slider-crank_2" -> "Slider crank 2"
std::string title_of(const fs::path& file) {
    std::string title = file.stem().string();
    std::ranges::replace_if(
        title, [](char c) { return c == '-' || c == '_'; }, ' ');
    if (!title.empty() && title.front() >= 'a' && title.front() <= 'z') {
        title.front() = static_cast<char>(title.front() - 'a' + 'A');
    }
    return title;
}

fs::path file_of(const std::string& name) {
    const fs::path file = name.ends_with(".toml") ? name : name + ".toml";
    const bool nameless = name.empty() || name.ends_with('/') || file.stem() == ".toml";
    if (nameless || file.filename() == kCourseFile) {
        throw bad_input(
            in_quotes(name) + " cannot be the name of a lesson; expected one such as 'my-lesson'");
    }
    std::error_code error;
    if (fs::exists(fs::symlink_status(file, error))) {
        throw bad_input(
            in_quotes(file.string()) + " already exists and is not changed; expected another name");
    }
    return file;
}

struct NewOptions {
    std::string name;
    bool exercise = false;
};

Exit write_new(const NewOptions& options, const Streams& streams) {
    const fs::path file = file_of(options.name);
    std::string text = kNewLesson;
    if (options.exercise) { text += kNewExercise; }
    text.replace(text.find(kTitleOfTemplate), kTitleOfTemplate.size(), writing::string_text(title_of(file)));
    // the only possible mistake is a name that a text file cannot hold
    if (const ReadResult read = read_lesson(text, file.string()); !read.lesson) {
        throw bad_input(
            in_quotes(options.name) + " cannot be a title: " + read.diagnostics.front().message +
            "; expected a name of letters in UTF-8");
    }
    std::string error;
    if (!write_lesson_file(file, text, error)) { throw bad_input(error); }
    streams.err << file.string() << " is written; 'jointwise open " << file.string()
                << "' shows it, 'jointwise check " << file.string() << "' proves its claims\n";
    return Exit::done;
}

}  // namespace

void add_new(const CommandLine& line) {
    auto [command, options] = add_command<NewOptions>(
        line, "new", "write a small lesson to begin with", write_new, "Example: jointwise new my-lesson");
    add_value(command, "NAME", options.name, "", "name of the lesson; the file is NAME.toml")->required();
    command.add_flag(
        "--exercise", options.exercise, "add an exercise whose numbers differ from student to student");
}

}  // namespace jw
