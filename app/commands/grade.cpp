#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>

#include "app/commands/options/course_option.hpp"
#include "app/commands/options/shared_options.hpp"
#include "app/commands/program/add_command.hpp"
#include "app/exercises/grading/grade_reports.hpp"
#include "app/exercises/grading/workers.hpp"
#include "app/exercises/random.hpp"
#include "app/exercises/run/safe_text.hpp"
#include "app/session/wording/messages.hpp"
#include "lessons/files/catalogue.hpp"
#include "render/files/atomic_file.hpp"

namespace jw {

namespace {

namespace fs = std::filesystem;

struct GradeOptions {
    std::vector<std::string> folders;
    std::vector<std::string> exercises;
    std::string key;
    std::string out;
    std::string format;
    int jobs = 0;
    bool again = false;
};

/// The file of answers may be anything, even a link or a pipe; it only has to exist.
bool is_submission(const fs::path& folder) {
    std::error_code error;
    return !fs::is_directory(folder, error) || fs::exists(fs::symlink_status(folder / kAnswersFile, error));
}

/// A folder that the command names, without '/' at its end; a link is replaced by its target.
fs::path named_folder(const std::string& name) {
    std::error_code error;
    const fs::path folder = fs::path(name).lexically_normal();
    const fs::path clean = folder.filename().empty() ? folder.parent_path() : folder;
    const bool real = clean.has_filename() && clean.filename() != "." && clean.filename() != "..";
    return real && !fs::is_symlink(clean, error) ? clean : fs::weakly_canonical(clean, error);
}

void warn_of_archive(const fs::path& file, const Streams& streams) {
    constexpr std::array<std::string_view, 6> kArchives{".zip", ".7z", ".rar", ".tar", ".gz", ".tgz"};
    if (std::ranges::find(kArchives, file.extension().string()) == kArchives.end()) { return; }
    streams.err << "jointwise: warning: '" << exercises::printable(file.filename().string())
                << "' is an archive and not graded; unpack it into a folder of its own\n";
}

/// The folders in a folder of submissions; the folder itself if there are none.
std::vector<fs::path> folders_in(const fs::path& folder, const Streams& streams) {
    std::vector<fs::path> inside;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        std::error_code unknown;
        if (entry->path().filename().string().starts_with('.')) { continue; }
        if (entry->is_directory(unknown) || entry->is_symlink(unknown)) {
            inside.push_back(entry->path());
        } else {
            warn_of_archive(entry->path(), streams);
        }
    }
    if (error) { throw bad_input("cannot read the folder '" + folder.string() + "': " + error.message()); }
    std::ranges::sort(inside);
    if (inside.empty()) { inside.push_back(folder); }
    return inside;
}

/// If one of the named folders has answers.toml, all of them are submissions; otherwise they are folders of
/// submissions. So a student cannot become several students by handing in folders without answers.
std::vector<fs::path> submissions_of(const std::vector<std::string>& names, const Streams& streams) {
    std::vector<fs::path> found;
    std::ranges::transform(names, std::back_inserter(found), named_folder);
    if (std::ranges::none_of(found, is_submission)) {
        std::vector<fs::path> inside;
        for (const fs::path& folder : found) {
            std::ranges::move(folders_in(folder, streams), std::back_inserter(inside));
        }
        found = std::move(inside);
    }
    std::set<fs::path> known;
    for (const fs::path& folder : found) {
        if (!known.insert(folder.filename()).second) {
            throw bad_input(
                "two submissions are called '" + folder.filename().string() +
                "'; expected different folders");
        }
    }
    return found;
}

/// Results of an earlier run that are still valid.
class KeptGrades {
public:
    explicit KeptGrades(const GradeOptions& options)
        : folder_(options.out.empty() ? fs::path() : fs::path(options.out) / "results"),
          again_(options.again) {
        if (!folder_.empty()) { make_folder(folder_); }
    }

    bool find(const fs::path& submission, const std::string& digest, Grade& grade) const {
        if (folder_.empty() || again_) { return false; }
        std::ifstream file(path_of(submission), std::ios::binary);
        std::string first;
        if (!std::getline(file, first) || first != digest) { return false; }
        std::ostringstream rest;
        rest << file.rdbuf();
        return read_grade(rest.str(), grade);
    }

    void keep(const fs::path& submission, const std::string& digest, const Grade& grade) const {
        if (folder_.empty()) { return; }
        render::write_file_atomically(path_of(submission), digest + "\n" + json_text(grade));
    }

private:
    /// Names of files may have 255 bytes, including the ending and what is added while the file is written.
    fs::path path_of(const fs::path& submission) const {
        constexpr std::size_t kLongest = 180;
        const std::string name = submission.filename().string();
        return folder_ / (name.size() <= kLongest ? name + ".json"
                                                  : name.substr(0, kLongest) + "-" +
                                                        std::to_string(seed_of(name, "", "")) + ".json");
    }

    fs::path folder_;
    bool again_;
};

/// Reads the submission, then grades its exercises, one part each. A process that goes on with the next part
/// keeps what it has read.
class SubmissionParts {
public:
    SubmissionParts(const ReadyCourse& course, const fs::path& folder) : course_(course), folder_(folder) {}

    std::string carry_out(int part) {
        if (!read_) { read_ = read_submission(folder_); }
        if (part == 0) { return json_text(empty_grade(course_, *read_)); }
        return json_text(grade_exercise(course_, entry(part), *read_));
    }

    /// @param done  results of all parts; only of the first if that failed
    Grade collected(const std::vector<WorkDone>& done) const {
        Grade grade = empty_grade(course_, {folder_, {}});
        if (!read_grade(done.front().result, grade)) { grade.problem = problem_of(done.front()); }
        for (std::size_t k = 1; k < done.size(); ++k) {
            ExerciseGrade& exercise = grade.exercises[k - 1];
            if (read_grade(done[k].result, exercise)) { continue; }
            exercise.handed_in = true;
            exercise.judged.understood = false;
            exercise.judged.feedback = {problem_of(done[k])};
        }
        return grade;
    }

private:
    const CourseExercise& entry(int part) const {
        return course_.exercises[static_cast<std::size_t>(part - 1)];
    }
    static std::string problem_of(const WorkDone& done) {
        return done.problem.empty() ? tr("Grading failed.") : done.problem;
    }

    const ReadyCourse& course_;
    fs::path folder_;
    std::optional<Submission> read_;
};

/// Allowed time [s] for a part: reading the submission, or an exercise, whose kind gives its time.
double seconds_for(const ReadyCourse& course, int part) {
    constexpr double kReading = 60.0;
    return part == 0 ? kReading
                     : longest_grading(*course.exercises[static_cast<std::size_t>(part - 1)].exercise);
}

std::vector<Grade> grade_all(
    const ReadyCourse& course, const std::vector<fs::path>& submissions, const GradeOptions& options,
    const Streams& streams) {
    const KeptGrades kept(options);
    std::vector<Grade> grades(submissions.size());
    std::vector<std::string> digests(submissions.size());
    std::vector<SubmissionParts> open;
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < submissions.size(); ++k) {
        digests[k] = course.digest + "-" + digest_of(submissions[k]);
        if (kept.find(submissions[k], digests[k], grades[k])) { continue; }
        open.emplace_back(course, submissions[k]);
        places.push_back(k);
    }
    ProgressBar progress(streams, "grading");
    int finished = 0;
    Work work;
    work.pieces = static_cast<int>(open.size());
    work.parts = 1 + static_cast<int>(course.exercises.size());
    work.wall_seconds = [&](int part) { return seconds_for(course, part); };
    work.carry_out = [&](int piece, int part) {
        return open[static_cast<std::size_t>(piece)].carry_out(part);
    };
    work.ended = [&](int piece, const std::vector<WorkDone>& done) {
        const std::size_t k = places[static_cast<std::size_t>(piece)];
        grades[k] = open[static_cast<std::size_t>(piece)].collected(done);
        // a part that failed because time ran out may succeed in the next run
        const bool complete = std::ranges::all_of(done, &std::string::empty, &WorkDone::problem);
        if (complete) { kept.keep(submissions[k], digests[k], grades[k]); }
        progress.show(static_cast<double>(++finished) / static_cast<double>(work.pieces));
    };
    const int jobs = options.jobs > 0 ? options.jobs : static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN));
    do_in_processes(work, jobs, {});
    return grades;
}

void warn_of_twins(const std::vector<Grade>& grades, const Streams& streams) {
    std::set<std::string> known;
    for (const Grade& grade : grades) {
        if (grade.student.empty() || known.insert(grade.student).second) { continue; }
        streams.err << "jointwise: warning: student '" << grade.student
                    << "' hands in more than once, also as '" << exercises::printable(grade.submission)
                    << "'\n";
    }
}

/// Exit status: programs that were not judged change it, not only the points.
Exit exit_of(const std::vector<Grade>& grades, const Streams& streams) {
    const ProgramsNotRun programs = programs_not_run(grades);
    if (programs.count == 0) { return Exit::done; }
    streams.err << "jointwise: warning: " << programs.text() << '\n';
    return Exit::numerics;
}

void write_grades(const std::vector<Grade>& grades, const std::string& format, const Streams& streams) {
    if (format == "json") {
        streams.out << grades_json(grades);
    } else if (format == "junit") {
        streams.out << grades_junit(grades);
    } else if (format == "csv") {
        streams.out << grades_csv(grades);
    } else if (format == "gradescope") {
        streams.out << gradescope_json(grades.front());
    } else {
        for (const Grade& grade : grades) { streams.out << grade_text(grade); }
    }
}

Exit grade(const GradeOptions& options, const Streams& streams) {
    const CourseKey key = key_of(options.key);
    std::vector<std::string> files = options.exercises;
    if (files.empty()) {
        for (const fs::path& file : key.exercises) { files.push_back(file.string()); }
    }
    if (files.empty()) {
        throw bad_input("which exercises? Expected --exercises FILE, or exercises = [...] in the key");
    }
    const ExerciseSet set = exercises_of(files);
    const std::vector<fs::path> submissions = submissions_of(options.folders, streams);
    if (options.format == "gradescope" && submissions.size() != 1) {
        throw bad_input(
            "--format gradescope is for one submission; there are " + std::to_string(submissions.size()));
    }
    const ReadyCourse course = ready_or_refused(key, set);
    const std::vector<Grade> grades = grade_all(course, submissions, options, streams);
    warn_of_twins(grades, streams);
    write_grades(grades, options.format, streams);
    if (!options.out.empty()) {
        const fs::path out = options.out;
        const std::vector<SlideLesson> lessons = lessons_of_slides(catalogue_folder());
        render::write_file_atomically(
            out / "class.html", class_report_html(grades, set.title, {lessons, set.exercises}));
        render::write_file_atomically(out / "grades.csv", grades_csv(grades));
    }
    return exit_of(grades, streams);
}

}  // namespace

void add_grade(const CommandLine& line) {
    auto [command, options] = add_command<GradeOptions>(
        line, "grade", "grade submissions of students", grade,
        "Example: jointwise grade submissions --key key.toml --out grades");
    add_value(command, "FOLDER", options.folders, "", "submissions, or folders of submissions")->required();
    add_value(command, "--key", options.key, "FILE", "key file of the course, as for 'sheet'")->required();
    add_value(
        command, "--exercises", options.exercises, "FILE",
        "files of exercises; default: those named in the key");
    add_value(
        command, "--out", options.out, "FOLDER",
        "folder for results, a report of the class and a table; unchanged submissions with results in it are "
        "not graded again");
    add_value(
        command, "--jobs", options.jobs, "N", "submissions graded in parallel; default: one per processor")
        ->check(CLI::Range(1, 256));
    command.add_flag("--again", options.again, "grade everything again");
    add_format_option(command, options.format, {"text", "json", "junit", "gradescope", "csv"});
}

}  // namespace jw
