#include "app/site/live_page.hpp"

#include <fstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "app/host/frames/frame_draft.hpp"
#include "app/session/output/json.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/text_width.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/exercise/exercise_index.hpp"
#include "lessons/exercise/read_exercises.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/files/course.hpp"
#include "lessons/files/file_text.hpp"

namespace jw::site {

namespace fs = std::filesystem;

namespace {

constexpr const char* kBundleFile = "lessons.json";
constexpr const char* kWorkerFile = "service_worker.js";
constexpr const char* kIndexFile = "index.html";
// folder of the course in the page
const fs::path kCourse = "/course";
constexpr std::string_view kVersionBefore = "const VERSION = \"";
constexpr std::size_t kVersionDigits = 16;
constexpr std::size_t kMostBytes = 1U << 30U;  // slides are the largest

void write(const fs::path& file, const std::string& text) {
    std::ofstream out(file, std::ios::binary);
    out << text;
    out.close();
    if (!out) { host::refuse(file, "cannot be written; is there room?"); }
}

/// Copies a file with default permissions, so that others can read the copy even if the original is private.
void copy_readable(const fs::path& from, const fs::path& to) { write(to, file_text(from)); }

/// A file of the course, and where the page finds it.
struct CourseFile {
    fs::path file;
    fs::path place;  ///< below the folder of the course in the page
};

void add_folder(const fs::path& folder, const fs::path& place, std::vector<CourseFile>& files) {
    for (const fs::path& file : lessons_below(folder)) {
        files.push_back({file, place / file.lexically_relative(folder)});
    }
}

/// Adds the files with the order of lessons; if the folder is part of a course, that of the whole course.
void add_orders(const fs::path& folder, const fs::path& place, std::vector<CourseFile>& files) {
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator(folder, error)) {
        if (entry.path().filename() == kCourseFile && entry.is_regular_file(error)) {
            files.push_back({entry.path(), place / entry.path().lexically_relative(folder)});
        }
    }
    if (!fs::exists(folder / kCourseFile, error) && fs::is_regular_file(folder / ".." / kCourseFile, error)) {
        files.push_back({folder / ".." / kCourseFile, place.parent_path() / kCourseFile});
    }
}

std::vector<CourseFile> files_of(const SiteCourse& course) {
    const fs::path lessons = lessons_folder_of(course);
    std::vector<CourseFile> files;
    add_folder(course.folder, lessons, files);
    add_orders(course.folder, lessons, files);
    if (!course.exercise_files.empty()) {
        // together with the scenes that they name
        add_folder(course.exercise_files.front().parent_path(), kExercisesFolder, files);
    }
    return files;
}

/// Version of a page, from its service worker; empty if it has none.
std::string version_in(const std::string& worker) {
    const std::size_t at = worker.find(kVersionBefore);
    return at == std::string::npos ? std::string()
                                   : worker.substr(at + kVersionBefore.size(), kVersionDigits);
}

}  // namespace

std::string file_text(const fs::path& file) {
    FileText read = read_file_text(file, kMostBytes);
    if (!read.problem.empty()) { host::refuse(file, "cannot be read: " + read.problem); }
    return std::move(read.text);
}

std::string problem_of_page(const fs::path& folder) {
    std::error_code error;
    for (const char* file :
         {kIndexFile, kWorkerFile, kBundleFile, "jointwise.js", "jointwise.wasm", "jointwise.data"}) {
        if (!fs::is_regular_file(folder / file, error)) {
            return in_quotes((folder / file).string()) +
                   " is not there; expected the files of the page, as './dev web' builds them into "
                   "build/web/page";
        }
    }
    if (version_in(file_text(folder / kWorkerFile)).empty()) {
        return in_quotes((folder / kWorkerFile).string()) +
               " names no version; build the page again with './dev web'";
    }
    return {};
}

std::string lessons_bundle(const SiteCourse& course) {
    Json files = Json::object();
    for (const CourseFile& file : files_of(course)) {
        files[(kCourse / file.place).generic_string()] = file_text(file.file);
    }
    return json_document(
        Json{
            {"lessons", (kCourse / lessons_folder_of(course)).generic_string()},
            {"language", std::string(language())},
            {"site", "../index.html"},
            {"files", std::move(files)}},
        -1);
}

void write_live_page(const fs::path& page, const std::string& bundle, const fs::path& into) {
    fs::create_directories(into);
    for (const fs::directory_entry& entry : fs::directory_iterator(page)) {
        if (entry.is_regular_file()) { copy_readable(entry.path(), into / entry.path().filename()); }
    }
    write(into / kBundleFile, bundle);
    const std::string before = version_in(file_text(page / kWorkerFile));
    const std::string after = before.substr(0, kVersionDigits / 2) +
                              host::sha256_of(into / kBundleFile).substr(0, kVersionDigits / 2);
    for (const char* file : {kWorkerFile, kIndexFile}) {
        write(into / file, replaced(file_text(page / file), before, after));
    }
}

void write_course_files(const SiteCourse& course, const fs::path& into) {
    for (const CourseFile& file : files_of(course)) {
        fs::create_directories((into / file.place).parent_path());
        copy_readable(file.file, into / file.place);
    }
    for (const fs::path& file : exercise_files_in(into / kExercisesFolder)) {
        const ExercisesRead read = read_exercise_file(file);
        if (read.exercises.empty() && !read.diagnostics.empty()) {
            throw std::runtime_error(
                "the exercises would not find their scenes in the site; expected scenes in the folder of the "
                "exercises or of the lessons:\n" +
                read.report());
        }
    }
}

}  // namespace jw::site
