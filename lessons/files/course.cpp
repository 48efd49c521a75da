#include "lessons/files/course.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "lessons/fields/fields.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/files/file_text.hpp"

namespace jw {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLargestCourse = 1U << 20U;
constexpr std::size_t kMostChapters = 1000;

using Names = std::vector<std::string>;

bool is_in(const Names& names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
}

/// True for the name of one folder or file, false for a path.
bool is_plain_name(const std::string& name) {
    return !name.empty() && name != "." && name != ".." && name.find('/') == std::string::npos;
}

Names folders_in(const fs::path& folder) {
    Names names;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
        std::error_code ignored;
        if (entry->is_directory(ignored)) { names.push_back(entry->path().filename().string()); }
    }
    std::ranges::sort(names);
    return names;
}

/// @param folder  contains the folders of the chapters; empty: this is not checked
std::string name_in(Fields& fields, const Names& before, const fs::path& folder) {
    fields.require("name", "the name of the chapter's folder");
    const auto name = fields.text("name");
    if (!name) { return {}; }
    fields.call("chapter " + in_quotes(name->value));
    if (!is_plain_name(name->value)) {
        fields.report(
            Code::course_name, name->span,
            in_quotes(name->value) + " is not the name of a folder; expected the folder beside this file");
    } else if (is_in(before, name->value)) {
        fields.report(
            Code::course_twice, name->span,
            "there are two chapters " + in_quotes(name->value) + "; expected each of them once");
    } else if (std::error_code error; !folder.empty() && !fs::is_directory(folder / name->value, error)) {
        fields.report(
            Code::course_name, name->span,
            "there is no folder " + in_quotes(name->value) +
                " beside this file; expected that of the chapter",
            did_you_mean(name->value, folders_in(folder)));
    }
    return name->value;
}

Names needs_in(Fields& fields, const Names& before) {
    Names needs;
    const auto list = fields.texts("needs");
    if (!list) { return needs; }
    for (const auto& [name, span] : list->value) {
        if (!is_in(before, name)) {
            fields.report(
                Code::course_needs, span,
                "no chapter " + in_quotes(name) + " comes before this one; expected " +
                    (before.empty() ? "an empty list" : "some of " + comma_list(before)),
                did_you_mean(name, before));
        }
        needs.push_back(name);
    }
    return needs;
}

Names lessons_in(Fields& fields) {
    Names lessons;
    const auto list = fields.texts("lessons");
    if (!list) { return lessons; }
    for (const auto& [name, span] : list->value) {
        if (!is_plain_name(name) || !name.ends_with(".toml")) {
            fields.report(
                Code::course_name, span,
                in_quotes(name) + " is not the name of a lesson file; expected one such as 'four-bar.toml'");
        } else if (is_in(lessons, name)) {
            fields.report(
                Code::course_twice, span,
                "the lesson " + in_quotes(name) + " is named twice; expected each of them once");
        }
        lessons.push_back(name);
    }
    return lessons;
}

Course course_in(Fields& root, const fs::path& folder) {
    Course course;
    Names names;
    root.require("format", "format = 1");
    root.integer("format", 1, 1);
    root.require("chapter", "at least one [[chapter]]");
    for (Fields& fields : root.tables("chapter", kMostChapters)) {
        Chapter chapter;
        chapter.name = name_in(fields, names, folder);
        fields.require("title", "the title of the chapter");
        if (const auto title = fields.plain_words("title")) { chapter.title = title->value; }
        if (const auto about = fields.plain_words("about")) { chapter.about = about->value; }
        chapter.about.drop_line_feeds();
        chapter.needs = needs_in(fields, names);
        chapter.lessons = lessons_in(fields);
        fields.finish();
        names.push_back(chapter.name);
        course.chapters.push_back(std::move(chapter));
    }
    root.finish();
    return course;
}

/// The courses around lessons, each read once.
class Courses {
public:
    /// @param highest  folders above this one are not searched
    explicit Courses(fs::path highest) : highest_(std::move(highest)) {}

    /// The nearest folder at or above `folder` with a course; empty if there is none.
    fs::path around(const fs::path& folder) {
        for (fs::path at = folder;; at = at.parent_path()) {
            if (!of(at).course.chapters.empty()) { return at; }
            if (at == highest_ || at == at.parent_path()) { return {}; }
        }
    }

    const CourseRead& of(const fs::path& folder) {
        const auto [entry, is_new] = read_.try_emplace(folder);
        // where only one chapter is read, the other chapters need not exist
        const auto chapters = folder == highest_ ? ChapterFolders::not_asked : ChapterFolders::must_be_there;
        if (is_new) { entry->second = read_course_of(folder, chapters); }
        return entry->second;
    }

    const std::map<fs::path, CourseRead>& all() const { return read_; }

private:
    fs::path highest_;
    std::map<fs::path, CourseRead> read_;
};

/// A lesson and its sort key.
struct Placed {
    CourseLessons::Entry entry;
    fs::path course;  ///< folder of the course, or of all lessons
    std::size_t chapter_place = 0;
    std::size_t lesson_place = 0;
    const Chapter* chapter = nullptr;

    auto key() const { return std::tie(course, chapter_place, entry.folder, lesson_place, entry.file); }
};

Placed placed(const fs::path& file, const fs::path& absolute, const fs::path& top, Courses& courses) {
    Placed p;
    p.entry.file = file;
    const fs::path around = courses.around(absolute.parent_path());
    p.course = around.empty() ? top : around;
    const fs::path below = absolute.lexically_relative(p.course);
    const fs::path rest = below.has_parent_path() ? below.lexically_relative(*below.begin()) : below;
    if (below.has_parent_path()) { p.entry.folder = below.begin()->string(); }
    const Course& course = courses.of(p.course).course;
    p.chapter_place = course.place_of_chapter(p.entry.folder);
    p.lesson_place = course.place_of_lesson(p.entry.folder, rest.generic_string());
    if (p.chapter_place < course.chapters.size()) {
        p.chapter = &course.chapters[p.chapter_place];
        p.entry.chapter_title = p.chapter->title;
    }
    return p;
}

}  // namespace

std::size_t Course::place_of_chapter(const std::string& name) const {
    return static_cast<std::size_t>(std::ranges::find(chapters, name, &Chapter::name) - chapters.begin());
}

std::size_t Course::place_of_lesson(const std::string& chapter, const std::string& file) const {
    const std::size_t place = place_of_chapter(chapter);
    if (place == chapters.size()) { return 0; }
    const Names& lessons = chapters[place].lessons;
    return static_cast<std::size_t>(std::ranges::find(lessons, file) - lessons.begin());
}

CourseRead read_course(std::string source, std::string file_name, const fs::path& folder) {
    CourseRead read;
    const auto take = [&](const toml::table& table, Problems& problems) {
        Fields root(table, "the course", problems);
        Course course = course_in(root, folder);
        if (problems.errors_count() == 0) { read.course = std::move(course); }
    };
    read_toml(read, std::move(source), std::move(file_name), take);
    return read;
}

CourseRead read_course_of(const fs::path& folder, ChapterFolders chapters) {
    const fs::path path = folder / kCourseFile;
    std::error_code error;
    if (!fs::exists(path, error)) { return {}; }
    FileText file = read_file_text(path, kLargestCourse);
    if (file.problem.empty()) {
        const bool asks = chapters == ChapterFolders::must_be_there;
        return read_course(std::move(file.text), path.string(), asks ? folder : fs::path());
    }
    CourseRead read;
    read.blame(path.string(), Code::file_unreadable, file.problem + "; expected the order of a course");
    return read;
}

CourseLessons course_lessons(const fs::path& folder) {
    std::error_code error;
    const fs::path top = fs::weakly_canonical(folder, error);
    Courses courses(top.parent_path());
    std::vector<Placed> all;
    for (const fs::path& file : lessons_below(folder)) {
        const fs::path absolute = top / file.lexically_relative(folder);
        all.push_back(placed(file, absolute, top, courses));
    }
    std::ranges::sort(all, [](const Placed& a, const Placed& b) { return a.key() < b.key(); });
    CourseLessons found;
    const Chapter* last = nullptr;
    for (Placed& p : all) {
        if (p.chapter != nullptr && p.chapter != last) { found.chapters.push_back(*p.chapter); }
        last = p.chapter;
        found.lessons.push_back(std::move(p.entry));
    }
    for (const auto& [where, read] : courses.all()) {
        if (read.diagnostics.empty()) { continue; }
        found.report += read.report();
        found.faulty.push_back(where / kCourseFile);
    }
    return found;
}

}  // namespace jw
