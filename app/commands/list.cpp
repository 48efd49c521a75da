#include <algorithm>

#include "app/commands/options/shared_options.hpp"
#include "app/commands/program/add_command.hpp"
#include "app/session/output/json.hpp"
#include "app/session/wording/shown_lesson.hpp"
#include "app/session/wording/text_table.hpp"
#include "lessons/exercise/exercise_index.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/files/course.hpp"
#include "lessons/files/search.hpp"
#include "lessons/read/reader.hpp"

namespace jw {

namespace {

namespace fs = std::filesystem;

struct ListOptions {
    std::vector<std::string> arguments;  ///< a folder, words
    std::string format;
};

/// Request for the lessons of a folder that have all words.
struct ListRequest {
    std::string folder;
    std::string words;
};

struct ListedLesson {
    CourseLessons::Entry place;
    Lesson lesson;
    std::string path;                ///< relative to the current folder
    std::size_t exercises_here = 0;  ///< number of exercises that belong to it

    const std::string& chapter() const { return lesson.chapter.empty() ? place.folder : lesson.chapter; }
};

bool looks_like_path(const std::string& text) {
    std::error_code error;
    return text.find('/') != std::string::npos || text == "." || text == ".." || fs::exists(text, error);
}

ListRequest request_of(const std::vector<std::string>& arguments) {
    ListRequest request{catalogue_folder().string(), {}};
    auto word = arguments.begin();
    if (word != arguments.end() && looks_like_path(*word)) { request.folder = *word++; }
    for (; word != arguments.end(); ++word) { request.words += (request.words.empty() ? "" : " ") + *word; }
    return request;
}

void write_text(const std::vector<ListedLesson>& lessons, std::ostream& out) {
    std::size_t widest = 0;
    for (const ListedLesson& l : lessons) { widest = std::max(widest, l.path.size()); }
    const ListedLesson* before = nullptr;
    for (const ListedLesson& l : lessons) {
        if (before == nullptr || before->chapter() != l.chapter()) {
            out << (l.chapter().empty() ? "other" : l.chapter());
            if (!l.place.chapter_title.empty()) { out << ": " << shown_text(l.place.chapter_title); }
            out << '\n';
        }
        before = &l;
        out << "  " << l.path << std::string(widest - l.path.size() + 2, ' ') << l.lesson.title;
        if (!l.lesson.source.empty()) { out << " (" << l.lesson.source << ')'; }
        if (l.exercises_here == 1) { out << ", 1 exercise"; }
        if (l.exercises_here > 1) { out << ", " << l.exercises_here << " exercises"; }
        out << '\n';
    }
}

/// Writes the table of docs/lessons.md; a lesson is named by its path below `folder`.
void write_markdown(const std::vector<ListedLesson>& lessons, const fs::path& folder, std::ostream& out) {
    out << "| lesson | | source |\n| --- | --- | --- |\n";
    for (const ListedLesson& l : lessons) {
        const auto path = fs::relative(l.place.file, folder).replace_extension();
        out << "| `" << path.generic_string() << "` | " << markdown_cell(l.lesson.title) << " | "
            << markdown_cell(l.lesson.source) << " |\n";
    }
}

Json json_of(const ListedLesson& l) {
    Json slides = Json::array();
    for (const SlideRange& range : slides_in(l.lesson.source)) {
        slides.push_back({{"first", range.first}, {"last", range.last}});
    }
    Json joints = Json::array();
    for (const Joint& joint : l.lesson.mechanism.joints) {
        if (std::ranges::find(joints, Json(joint.type->name)) == joints.end()) {
            joints.push_back(joint.type->name);
        }
    }
    return {{"file", l.path},          {"chapter", l.chapter()},
            {"title", l.lesson.title}, {"source", l.lesson.source},
            {"slides", slides},        {"joints", joints},
            {"text", l.lesson.text},   {"exercises", l.exercises_here}};
}

void write_json(
    const std::vector<ListedLesson>& lessons, const std::vector<Chapter>& chapters,
    const ListRequest& request, std::ostream& out) {
    Json json{{"format", "jointwise list"}, {"version", kJsonVersion},   {"folder", request.folder},
              {"words", request.words},     {"chapters", Json::array()}, {"lessons", Json::array()}};
    for (const Chapter& c : chapters) {
        json["chapters"].push_back(
            {{"name", c.name},
             {"title", shown_text(c.title)},
             {"about", shown_text(c.about)},
             {"needs", c.needs}});
    }
    for (const ListedLesson& l : lessons) { json["lessons"].push_back(json_of(l)); }
    out << json_document(json);
}

Exit list(const ListOptions& options, const Streams& streams) {
    const ListRequest request = request_of(options.arguments);
    const CourseLessons course = course_lessons(request.folder);
    if (course.lessons.empty()) {
        throw bad_input(
            "no lesson (*.toml) below '" + request.folder +
            "'; give another folder, or set JOINTWISE_LESSONS");
    }
    Exit exit = course.report.empty() ? Exit::done : Exit::bad_input;
    streams.err << course.report;
    const std::vector<IndexedExercise> exercises = exercises_of_course(request.folder);
    std::vector<ListedLesson> lessons;
    for (const CourseLessons::Entry& entry : course.lessons) {
        ReadResult read = read_lesson_file(entry.file);
        if (!read.lesson) {
            streams.err << read.report();
            exit = Exit::bad_input;
        } else if (fits(searchable_of(*read.lesson, entry.file), request.words)) {
            const auto count =
                std::ranges::count(exercises, lesson_name(entry.file), &IndexedExercise::lesson);
            lessons.push_back(
                {entry, shown_lesson(std::move(*read.lesson)), fs::relative(entry.file).string(),
                 static_cast<std::size_t>(count)});
        }
    }
    if (lessons.empty() && exit == Exit::done) {
        streams.err << "jointwise: no lesson has all of these words: " << request.words << '\n';
        exit = Exit::check_failed;
    }
    if (options.format == "markdown") {
        write_markdown(lessons, request.folder, streams.out);
    } else if (options.format == "json") {
        write_json(lessons, course.chapters, request, streams.out);
    } else {
        write_text(lessons, streams.out);
    }
    return exit;
}

}  // namespace

void add_list(const CommandLine& line) {
    auto [command, options] = add_command<ListOptions>(
        line, "list", "show the lessons, by chapter, or search them", list,
        "Example: jointwise list slide 5");
    add_value(
        command, "FOLDER", options.arguments, "[WORDS...]",
        "folder to search, and words that lessons must have; 'slide 5' is looked for in their source");
    add_format_option(command, options.format, {"text", "markdown", "json"});
}

}  // namespace jw
