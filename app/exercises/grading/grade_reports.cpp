#include "app/exercises/grading/grade_reports.hpp"

#include <algorithm>

#include "app/exercises/run/safe_text.hpp"
#include "app/session/encoding/junit.hpp"
#include "app/session/output/export.hpp"
#include "app/session/output/json.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "lessons/math/text_parts.hpp"

namespace jw {

namespace {

std::string points_text(double points) { return number_text(points, 6); }

/// Text of a student in one line, without control characters of a terminal.
std::string in_a_line(const std::string& text) {
    std::string shown = exercises::printable(text);
    std::ranges::replace(shown, '\n', ' ');
    return shown;
}

std::string csv_field(const std::string& text) {
    // a spreadsheet would read these as formulas
    const bool formula = !text.empty() && std::string("=+-@\t").find(text.front()) != std::string::npos;
    return csv_cell(formula ? "'" + text : text);
}

std::string verdict_of(const ExerciseGrade& e) {
    if (!e.handed_in) { return tr("not handed in"); }
    if (e.not_run) { return tr("not run"); }
    if (!e.judged.understood) { return tr("not understood"); }
    if (e.judged.right && e.judged.share >= 1.0) { return tr("right"); }
    return e.judged.title.empty() ? tr("wrong") : tr("wrong: {0}", math::plain_words(e.judged.title));
}

std::string feedback_text(const ExerciseGrade& e, const std::string& before) {
    std::string text;
    for (const std::string& sentence : e.judged.feedback) {
        text += before + exercises::printable(math::plain_words(sentence)) + "\n";
    }
    return text;
}

void add_exercise(const Grade& grade, const ExerciseGrade& e, JunitSuite& suite) {
    const std::string said = grade.problem.empty() ? feedback_text(e, "") : grade.problem;
    if (e.not_run) {
        suite.skipped(e.name, in_a_line(said));
    } else if (e.earned >= e.points) {
        suite.passed(e.name);
    } else {
        suite.failed(e.name, e.judged.mistake.empty() ? "grade" : e.judged.mistake, verdict_of(e), said);
    }
}

}  // namespace

std::string grade_text(const Grade& grade) {
    const std::string who = grade.student.empty() ? grade.submission : grade.student;
    std::string text = tr("{0}: {1} of {2} points", in_a_line(who), points_text(grade.earned()),
                          points_text(grade.points())) +
                       "\n";
    if (!grade.problem.empty()) {
        return text + "  " + tr("nothing could be graded: {0}", exercises::printable(grade.problem)) + "\n";
    }
    for (const ExerciseGrade& e : grade.exercises) {
        text += "  " + points_text(e.earned) + "/" + points_text(e.points) + "  " + e.name + ": " +
                verdict_of(e) + "\n";
        text += feedback_text(e, "        ");
    }
    return text;
}

std::string grades_csv(const std::vector<Grade>& grades) {
    std::string text = "student,submission,points,of";
    if (!grades.empty()) {
        for (const ExerciseGrade& e : grades.front().exercises) {
            text += "," + csv_field(e.name) + "," + csv_field(e.name + " mistake");
        }
    }
    text += ",problem\n";
    for (const Grade& grade : grades) {
        text += csv_field(grade.student) + "," + csv_field(in_a_line(grade.submission)) + "," +
                points_text(grade.earned()) + "," + points_text(grade.points());
        for (const ExerciseGrade& e : grade.exercises) {
            text += "," + points_text(e.earned) + "," + csv_field(e.judged.mistake);
        }
        text += "," + csv_field(in_a_line(grade.problem)) + "\n";
    }
    return text;
}

std::string grades_junit(const std::vector<Grade>& grades) {
    std::vector<JunitSuite> suites;
    for (const Grade& grade : grades) {
        JunitSuite& suite = suites.emplace_back(grade.student.empty() ? grade.submission : grade.student);
        for (const ExerciseGrade& e : grade.exercises) { add_exercise(grade, e, suite); }
    }
    return junit_report("jointwise grade", suites);
}

/// Results in the format of https://gradescope-autograders.readthedocs.io/en/latest/specs/: messages about
/// the whole submission stand above the tests.
std::string gradescope_json(const Grade& grade) {
    Json tests = Json::array();
    for (const ExerciseGrade& e : grade.exercises) {
        tests.push_back(
            {{"name", e.title + " (" + e.name + ")"},
             {"score", e.earned},
             {"max_score", e.points},
             {"output",
              grade.problem.empty() ? verdict_of(e) + "\n" + feedback_text(e, "") : tr("not graded")},
             {"status", e.earned >= e.points ? "passed" : "failed"},
             {"visibility", "visible"}});
    }
    Json json{{"score", grade.earned()}, {"tests", std::move(tests)}};
    if (!grade.problem.empty()) { json["output"] = exercises::printable(grade.problem); }
    return json_document(json, 2);
}

std::string grades_json(const std::vector<Grade>& grades) {
    std::string text = "[\n";
    for (std::size_t k = 0; k < grades.size(); ++k) { text += (k > 0 ? ",\n" : "") + json_text(grades[k]); }
    return text + "]\n";
}

ProgramsNotRun programs_not_run(const std::vector<Grade>& grades) {
    ProgramsNotRun programs;
    for (const Grade& grade : grades) {
        for (const ExerciseGrade& e : grade.exercises) {
            if (!e.not_run) { continue; }
            ++programs.count;
            if (programs.reason.empty() && !e.judged.feedback.empty()) {
                programs.reason = exercises::printable(e.judged.feedback.front());
            }
        }
    }
    return programs;
}

std::string ProgramsNotRun::text() const {
    return tr_count(
        count, "{0} program was not run and got no points: {1}; grade on a machine that can run them",
        "{0} programs were not run and got no points: {1}; grade on a machine that can run them", reason);
}

std::vector<ExerciseCount> counts_of(const std::vector<Grade>& grades) {
    std::vector<ExerciseCount> counts;
    for (const Grade& grade : grades) {
        for (const ExerciseGrade& e : grade.exercises) {
            auto count = std::ranges::find(counts, e.name, &ExerciseCount::name);
            if (count == counts.end()) {
                counts.push_back({});
                counts.back().name = e.name;
                counts.back().title = e.title;
                count = counts.end() - 1;
            }
            if (!e.handed_in) {
                ++count->missing;
            } else if (e.not_run) {
                ++count->not_run;
            } else if (!e.judged.understood) {
                ++count->not_understood;
            } else if (e.judged.right && e.judged.share >= 1.0) {
                ++count->right;
            } else {
                ++(e.earned > 0.0 ? count->partly : count->wrong);
            }
            if (e.judged.title.empty()) { continue; }
            auto mistake = std::ranges::find(count->mistakes, e.judged.title, &ExerciseCount::Mistake::title);
            if (mistake == count->mistakes.end()) {
                count->mistakes.push_back({e.judged.title, e.judged.slide, 0});
                mistake = count->mistakes.end() - 1;
            }
            ++mistake->count;
        }
    }
    for (ExerciseCount& count : counts) {
        std::ranges::stable_sort(count.mistakes, std::greater{}, &ExerciseCount::Mistake::count);
    }
    return counts;
}

}  // namespace jw
