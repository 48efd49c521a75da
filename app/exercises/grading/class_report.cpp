#include <algorithm>
#include <array>
#include <cmath>

#include "app/exercises/grading/grade_reports.hpp"
#include "app/exercises/grading/page_styles.hpp"
#include "app/session/encoding/html_words.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "app/session/wording/shown_lesson.hpp"
#include "lessons/exercise/exercise_index.hpp"
#include "lessons/text/text.hpp"

namespace jw {

namespace {

/// "vectors/frames" as "lesson-vectors-frames"
std::string anchor_of(const SlideLesson& lesson) {
    std::string anchor = "lesson-" + lesson_name(lesson.file);
    std::ranges::replace(anchor, '/', '-');
    return anchor;
}

/// A link to the section of a lesson; with the slide before it if there is one.
std::string lesson_link(const SlideLesson& lesson, const std::string& slide) {
    return "<a href=\"#" + markup_text(anchor_of(lesson)) + "\">" +
           (slide.empty() ? "" : markup_text(shown_slides(slide)) + ": ") + html_words(lesson.title) + "</a>";
}

/// The first text of a lesson, its summary, and how to open it.
std::string lesson_section(const SlideLesson& lesson) {
    const std::string name = lesson_name(lesson.file);
    std::string html = "<h3 id=\"" + markup_text(anchor_of(lesson)) + "\">" + html_words(lesson.title) +
                       " <small>(" + markup_text(name) + ")</small></h3>\n<p>" + html_words(lesson.text) +
                       "</p>\n";
    if (!lesson.summary.empty()) { html += "<p><b>" + html_words(lesson.summary) + "</b></p>\n"; }
    return html + "<p>" + markup_text(tr("In the program:")) + " <code>jointwise open lessons/catalogue/" +
           markup_text(name) + ".toml</code></p>\n";
}

constexpr int kBins = 10;

std::string width_of(int count, int all) {
    return "style=\"width:" + number_text(all > 0 ? 100.0 * count / all : 0.0, 4) + "%\"";
}

std::string histogram(const std::vector<Grade>& grades) {
    std::vector<int> bins(kBins, 0);
    for (const Grade& grade : grades) {
        const double share = grade.points() > 0.0 ? grade.earned() / grade.points() : 0.0;
        ++bins[static_cast<std::size_t>(std::min(kBins - 1, static_cast<int>(kBins * share)))];
    }
    const int most = std::max(1, *std::ranges::max_element(bins));
    std::string html = "<div class=\"hist\" role=\"img\" aria-label=\"" +
                       markup_text(tr("students by share of points")) + "\">";
    for (const int count : bins) {
        html += "<div style=\"height:" + number_text(100.0 * count / most * 0.85, 4) + "%\"><b>" +
                (count > 0 ? std::to_string(count) : "") + "</b></div>";
    }
    html += "</div><div class=\"axis\">";
    for (int k = 0; k < kBins; ++k) {
        html += "<span>" + std::to_string(100 * k / kBins) + "–" + std::to_string(100 * (k + 1) / kBins) +
                "&nbsp;%</span>";
    }
    return html + "</div>\n";
}

std::string count_bar(const ExerciseCount& c, int all) {
    return "<div class=\"bar\"><i class=\"right\" " + width_of(c.right, all) + "></i><i class=\"partly\" " +
           width_of(c.partly, all) + "></i><i class=\"wrong\" " + width_of(c.wrong, all) +
           "></i><i class=\"lost\" " + width_of(c.not_understood + c.not_run, all) +
           "></i><i class=\"missing\" " + width_of(c.missing, all) + "></i></div>\n";
}

std::string key_of_bars() {
    constexpr std::array<std::array<const char*, 2>, 5> kParts{
        {{"right", tr_later("right")},
         {"partly", tr_later("partly")},
         {"wrong", tr_later("wrong")},
         {"lost", tr_later("not understood or not run")},
         {"missing", tr_later("not handed in")}}};
    std::string html = "<p class=\"key\">";
    for (const auto& [style, words] : kParts) {
        html += std::string("<span><i class=\"") + style + "\"></i>" + markup_text(tr(words)) + "</span>";
    }
    return html + "</p>\n";
}

/// Lessons that the page links to, each once.
using LinkedLessons = std::vector<const SlideLesson*>;

std::string answer_cell(
    const ExerciseCount& c, const ExerciseCount::Mistake& mistake, const AnsweringLessons& lessons,
    LinkedLessons& linked) {
    const SlideLesson* const lesson = lessons.find(c.name, mistake.slide);
    if (lesson == nullptr) {
        return "<a href=\"#" + markup_text(c.name) + "\">" + markup_text(tr("the solution of the sheet")) +
               "</a>";
    }
    if (std::ranges::find(linked, lesson) == linked.end()) { linked.push_back(lesson); }
    return lesson_link(*lesson, mistake.slide);
}

std::string about_lessons(const LinkedLessons& linked) {
    if (linked.empty()) { return {}; }
    std::string html = "<h2>" + markup_text(tr("Where to read about these mistakes")) + "</h2>\n";
    for (const SlideLesson* lesson : linked) { html += lesson_section(*lesson); }
    return html;
}

std::string counts_text(const ExerciseCount& c) {
    if (c.not_run == 0) {
        return tr(
            "{0} right, {1} partly, {2} wrong, {3} not understood, {4} not handed in.", c.right, c.partly,
            c.wrong, c.not_understood, c.missing);
    }
    return tr(
        "{0} right, {1} partly, {2} wrong, {3} not understood, {4} not run, {5} not handed in.", c.right,
        c.partly, c.wrong, c.not_understood, c.not_run, c.missing);
}

std::string about_exercise(
    const ExerciseCount& c, int all, const AnsweringLessons& lessons, LinkedLessons& linked) {
    std::string html = "<h2 id=\"" + markup_text(c.name) + "\">" + html_words(c.title) + " <small>(" +
                       markup_text(c.name) + ")</small></h2>\n" + count_bar(c, all);
    html += "<p>" + markup_text(counts_text(c)) + "</p>\n";
    if (c.mistakes.empty()) { return html; }
    html += "<table><tr><th>" + markup_text(tr("mistake")) + "</th><th class=\"n\">" +
            markup_text(tr("students")) + "</th><th>" + markup_text(tr("explained in")) + "</th></tr>\n";
    for (const ExerciseCount::Mistake& m : c.mistakes) {
        html += "<tr><td>" + html_words(m.title) + "</td><td class=\"n\">" + std::to_string(m.count) +
                "</td><td>" + answer_cell(c, m, lessons, linked) + "</td></tr>\n";
    }
    return html + "</table>\n";
}

std::string about_refused(const std::vector<Grade>& grades) {
    std::string rows;
    for (const Grade& grade : grades) {
        if (grade.problem.empty()) { continue; }
        rows += "<tr><td>" + markup_text(grade.submission) + "</td><td>" + markup_text(grade.problem) +
                "</td></tr>\n";
    }
    return rows.empty() ? rows
                        : "<h2>" + markup_text(tr("Not graded")) + "</h2><table><tr><th>" +
                              markup_text(tr("submission")) + "</th><th>" + markup_text(tr("why")) +
                              "</th></tr>\n" + rows + "</table>\n";
}

}  // namespace

const SlideLesson* AnsweringLessons::find(const std::string& exercise, const std::string& slide) const {
    if (const SlideLesson* const of_slide = lesson_of_slide(*lessons_, slide)) { return of_slide; }
    const auto asked = std::ranges::find(*exercises_, exercise, &Exercise::name);
    if (asked == exercises_->end()) { return nullptr; }
    const auto own = std::ranges::find_if(
        *lessons_, [&](const SlideLesson& lesson) { return lesson_name(lesson.file) == asked->lesson; });
    return own != lessons_->end() ? &*own : lesson_of_slide(*lessons_, asked->source);
}

std::string class_report_html(
    const std::vector<Grade>& grades, const std::string& title, const AnsweringLessons& lessons) {
    const int all = static_cast<int>(grades.size());
    double sum = 0.0;
    double points = 0.0;
    for (const Grade& grade : grades) {
        sum += grade.earned();
        points = std::max(points, grade.points());
    }
    const double mean = all > 0 ? sum / all : 0.0;
    std::string html =
        "<!doctype html>\n<html lang=\"" + std::string(language()) +
        "\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\"><title>" +
        markup_text(title) + "</title><style>" + kClassStyle + "</style></head><body>\n<h1>" +
        markup_text(title) + "</h1>\n<p>" +
        markup_text(tr_count(
            all, "{0} submission, {1} of {2} points.", "{0} submissions, {1} of {2} points on average.",
            number_text(mean, 3), number_text(points, 6))) +
        "</p>\n" + histogram(grades) + key_of_bars();
    const ProgramsNotRun programs = programs_not_run(grades);
    if (programs.count > 0) { html += "<p><b>" + markup_text(programs.text()) + ".</b></p>\n"; }
    LinkedLessons linked;
    for (const ExerciseCount& count : counts_of(grades)) {
        html += about_exercise(count, all, lessons, linked);
    }
    return html + about_refused(grades) + about_lessons(linked) + "</body></html>\n";
}

}  // namespace jw
