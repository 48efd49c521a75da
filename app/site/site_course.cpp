#include "app/site/site_course.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <utility>

#include "app/host/lesson/catalogue.hpp"
#include "app/session/try/trials.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/shown_lesson.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/exercise/exercise_index.hpp"
#include "lessons/exercise/read_exercises.hpp"
#include "lessons/files/course.hpp"
#include "lessons/read/reader.hpp"

namespace jw::site {

namespace fs = std::filesystem;

namespace {

// no lecture has more: a source that names more slides is a mistake of its author
constexpr int kMostSlides = 1000;

class CourseReader {
public:
    CourseReader(fs::path folder, const fs::path& exercises) {
        read_.course.folder = std::move(folder);
        // a single chapter has no folder of exercises beside it: such files are about several chapters
        const fs::path beside = fs::absolute(read_.course.folder) / ".." / kExercisesFolder;
        std::error_code error;
        if (!exercises.empty()) {
            read_.course.exercise_files = exercise_files_in(exercises);
        } else if (!fs::equivalent(beside, read_.course.folder, error)) {
            read_.course.exercise_files = exercise_files_in(beside);
        }
    }

    SiteCourseRead read(const std::function<void(double)>& progress) {
        const CourseLessons found = course_lessons(read_.course.folder);
        read_.report = found.report;
        read_exercises();
        for (std::size_t k = 0; k < found.lessons.size(); ++k) {
            progress(static_cast<double>(k) / static_cast<double>(found.lessons.size()));
            add(found.lessons[k], found.chapters);
        }
        // exercises of lessons that do not exist were refused when they were read
        for (const Exercise& exercise : exercises_[{}]) {
            read_.notes.push_back("exercise '" + exercise.name + "' belongs to no lesson; it is left out");
        }
        return std::move(read_);
    }

private:
    void read_exercises() {
        for (const fs::path& file : read_.course.exercise_files) { take_exercises_of(file); }
    }

    void take_exercises_of(const fs::path& file) {
        ExercisesRead read = read_exercise_file(file);
        read_.report += read.report();
        for (Exercise& exercise : read.exercises) {
            if (!names_.insert(exercise.name).second) {
                read_.report += file.string() + ": error: there are two exercises '" + exercise.name +
                                "' in the course; expected each name once\n";
            }
            exercises_[exercise.lesson].push_back(shown_exercise(std::move(exercise)));
        }
    }

    void add(const CourseLessons::Entry& entry, const std::vector<Chapter>& chapters) {
        const ReadResult read = read_lesson_file(entry.file);
        if (!read.lesson) {
            read_.report += read.report();
            return;
        }
        SiteLesson lesson;
        lesson.file = entry.file;
        lesson.name = host::name_below(entry.file, read_.course.folder);
        lesson.address = host::name_in_addresses(entry.file, read_.course.folder);
        lesson.lesson = shown_lesson(*read.lesson);
        check_page(lesson);
        lesson.searchable = searchable_of(lesson.lesson, entry.file);
        check(lesson);
        const std::string name = lesson_name(entry.file);
        if (!exercises_of_lesson(exercises_named_in(entry.file), name).empty()) {
            take_exercises_of(entry.file);
        }
        lesson.exercises = std::move(exercises_[name]);
        exercises_.erase(name);
        chapter_of(entry, chapters).lessons.push_back(read_.course.lessons.size());
        read_.course.lessons.push_back(std::move(lesson));
    }

    /// Refuses names of pages that differ only in capitals: many file systems take them for the same name.
    void check_page(const SiteLesson& lesson) {
        std::string page = lesson.name;
        std::ranges::transform(page, page.begin(), [](unsigned char c) { return std::tolower(c); });
        const auto [other, is_new] = pages_.emplace(page, lesson.file);
        if (is_new) { return; }
        read_.report += lesson.file.string() + ": error: its page and that of " +
                        in_quotes(other->second.filename().string()) +
                        " differ in capitals alone, and are one on many disks; expected another name\n";
    }

    void check(SiteLesson& lesson) {
        lesson.claims = check_claims(lesson.lesson);
        for (const std::vector<ClaimResult>& results : {lesson.claims, check_trials(lesson.lesson)}) {
            for (const ClaimResult& result : results) {
                if (result.holds) { continue; }
                read_.failed_claims += lesson.file.string() + ':' + std::to_string(result.span.line) + ':' +
                                       std::to_string(result.span.column) + ": " + result.moment + ", " +
                                       result.subject + ": expected " + result.expected + ", found " +
                                       result.found + '\n';
            }
        }
    }

    /// The chapter of an entry, which is created for its first entry.
    SiteChapter& chapter_of(const CourseLessons::Entry& entry, const std::vector<Chapter>& chapters) {
        std::vector<SiteChapter>& all = read_.course.chapters;
        const auto begun = std::ranges::find(all, entry.folder, &SiteChapter::name);
        if (begun != all.end()) { return *begun; }
        SiteChapter chapter;
        chapter.name = entry.folder;
        chapter.title = shown_text(entry.chapter_title);
        if (chapter.title.empty()) { chapter.title = entry.folder.empty() ? tr("Lessons") : entry.folder; }
        const auto told = std::ranges::find(chapters, entry.folder, &Chapter::name);
        if (told != chapters.end()) {
            chapter.about = shown_text(told->about);
            for (const std::string& needed : told->needs) {
                const auto other = std::ranges::find(chapters, needed, &Chapter::name);
                chapter.needs.push_back(other == chapters.end() ? needed : shown_text(other->title));
            }
        }
        return all.emplace_back(std::move(chapter));
    }

    SiteCourseRead read_;
    std::map<std::string, fs::path> pages_;                   ///< files of lessons by names in small letters
    std::set<std::string> names_;                             ///< of exercises
    std::map<std::string, std::vector<Exercise>> exercises_;  ///< by lesson, until the lesson takes them
};

}  // namespace

SiteCourseRead read_site_course(
    const fs::path& folder, const fs::path& exercises, const std::function<void(double)>& progress) {
    return CourseReader(folder, exercises).read(progress);
}

std::string lessons_folder_of(const SiteCourse& course) {
    const fs::path whole = fs::absolute(course.folder).lexically_normal();
    const std::string name = (whole.has_filename() ? whole : whole.parent_path()).filename().generic_string();
    // the folder of exercises is beside it, so the two names must differ
    return name.empty() || name == kExercisesFolder ? "lessons" : name;
}

std::vector<int> slide_numbers(const std::string& source) {
    std::vector<int> numbers;
    for (const SlideRange& range : slides_in(source)) {
        for (int slide = range.first; slide <= range.last && numbers.size() < kMostSlides; ++slide) {
            numbers.push_back(slide);
        }
    }
    return numbers;
}

}  // namespace jw::site
