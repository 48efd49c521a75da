#include "lessons/read/reader.hpp"

#include <algorithm>

#include "lessons/fields/fields.hpp"
#include "lessons/files/course.hpp"
#include "lessons/files/file_text.hpp"
#include "lessons/read/reading.hpp"

namespace jw {

namespace {

constexpr int kFormat = 1;
constexpr std::size_t kLargestFile = 10U << 20U;
constexpr std::size_t kMostReported = 50;

/// Reads the format first, so that a reader of another version can report it instead of guessing.
/// @return true if the rest can be read
bool read_format(Fields& root, const toml::table& table) {
    root.require("format", "format = 1 as the first key");
    const auto format = root.integer("format", -1000000, 1000000);
    if (!format) { return true; }
    if (format->value != kFormat) {
        root.report(
            Code::other_format, format->span,
            "this is format " + std::to_string(format->value) + "; expected format = 1",
            "a newer version of Jointwise may support it");
        return false;
    }
    const auto is_before = [&](const toml::key& key) {
        // a key that the program has inserted does not have a line
        const int line = span_of(key.source()).line;
        return line > 0 && line < format->span.line;
    };
    if (std::ranges::any_of(table, [&](const auto& entry) { return is_before(entry.first); })) {
        root.report(
            Code::format_not_first, format->span,
            "'format' comes after other keys; expected it as the first key");
    }
    return true;
}

/// Warns of moving bodies that nothing constrains or drives: without dynamics, they are rarely intended.
void warn_of_loose_bodies(const reading::Reading& read, Problems& problems) {
    if (read.lesson.dynamics) { return; }
    const Mechanism& mechanism = read.lesson.mechanism;
    std::vector<bool> held(mechanism.bodies.size(), false);
    const auto hold = [&](const auto& links) {
        for (const auto& link : links) { held[at(link.body_i)] = held[at(link.body_j)] = true; }
    };
    hold(mechanism.joints);
    hold(mechanism.drivers);
    for (std::size_t b = 0; b < held.size(); ++b) {
        const Body& body = mechanism.bodies[b];
        const auto named = read.names.find(body.name);
        if (held[b] || body.fixed || named == read.names.end()) { continue; }
        problems.warn(
            Code::loose_body, named->second.span,
            "no joint and no driver constrains body " + in_quotes(body.name), "it keeps six freedoms");
    }
}

/// Reports the mistakes in the order of a course, or that the file is a course.
ReadResult no_lesson_but_course(std::string source, const std::filesystem::path& path) {
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    CourseRead course = read_course(std::move(source), path.string(), folder);
    if (course.diagnostics.empty()) {
        course.blame(
            path.string(), Code::course_no_lesson,
            "this is the order of a course; expected a lesson (.toml)");
    }
    return {{std::move(course.diagnostics), std::move(course.source), {}}, std::nullopt};
}

Lesson read_root(Fields& root, Problems& problems) {
    reading::Reading read;
    read.problems = &problems;
    reading::read_head(root, read.lesson);
    reading::read_motion(root, read.lesson);
    reading::read_camera(root, read.lesson);
    reading::read_bodies(root, read);
    reading::read_dynamics(root, read);
    reading::read_precision(root, read.lesson);
    reading::read_joints(root, read);
    reading::read_drivers(root, read);
    reading::read_loads(root, read);
    reading::read_order(root, read);
    reading::read_steps(root, read);
    reading::read_claims(root, read);
    reading::read_questions(root, read);
    // exercises are read when they are needed (lessons/exercise)
    root.has("exercise");
    root.finish();
    if (problems.errors_count() == 0) {
        warn_of_loose_bodies(read, problems);
        reading::take_start_values(read);
    }
    return std::move(read.lesson);
}

void read_table(
    const toml::table& table, const std::string& file_name, Problems& problems, ReadResult& result) {
    Fields root(table, "the lesson", problems, &key_tables().front());
    if (!read_format(root, table)) { return; }
    Lesson lesson = read_root(root, problems);
    lesson.file_name = file_name;
    if (problems.errors_count() == 0) { result.lesson = std::move(lesson); }
}

}  // namespace

std::string ReadResult::report() const {
    std::string text;
    for (std::size_t k = 0; k < std::min(kMostReported, diagnostics.size()); ++k) {
        text += to_string(diagnostics[k], source);
    }
    if (diagnostics.size() > kMostReported) {
        const char* at_least = diagnostics.size() >= kMostProblems ? "at least " : "";
        text += std::string("... and ") + at_least + std::to_string(diagnostics.size() - kMostReported) +
                " more\n";
    }
    return text;
}

ReadResult read_lesson(std::string source, std::string file_name) {
    ReadResult result;
    read_toml(result, std::move(source), file_name, [&](const toml::table& table, Problems& problems) {
        read_table(table, file_name, problems, result);
    });
    return result;
}

ReadResult read_lesson_with_claims(std::string source, std::string file_name, const std::string& claims) {
    ReadResult result;
    read_toml(result, std::move(source), file_name, [&](toml::table& table, Problems& problems) {
        for (const char* key : {"expect", "question", "try", "exercise"}) { table.erase(key); }
        toml::table others = toml::parse(claims);
        if (toml::node* const list = others.get("expect")) { table.insert("expect", std::move(*list)); }
        read_table(table, file_name, problems, result);
    });
    return result;
}

ReadResult read_lesson_file(const std::filesystem::path& path) {
    FileText file = read_file_text(path, kLargestFile);
    if (!file.problem.empty()) {
        ReadResult result;
        const std::string message = file.problem + "; expected a lesson (.toml)";
        result.blame(path.empty() ? "''" : path.string(), Code::file_unreadable, message);
        return result;
    }
    if (path.filename() == kCourseFile) { return no_lesson_but_course(std::move(file.text), path); }
    return read_lesson(std::move(file.text), path.string());
}

std::string toml_version() {
    return std::to_string(TOML_LIB_MAJOR) + '.' + std::to_string(TOML_LIB_MINOR) + '.' +
           std::to_string(TOML_LIB_PATCH);
}

}  // namespace jw
