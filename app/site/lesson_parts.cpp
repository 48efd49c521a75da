#include "app/site/lesson_parts.hpp"

#include "app/host/lesson/address.hpp"
#include "app/session/encoding/html_words.hpp"
#include "app/session/view/view.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "app/site/lesson_page.hpp"
#include "lessons/exercise/exercise_index.hpp"

namespace jw::site {

namespace {

std::string item(const std::string& name, const std::string& value) {
    return "<div><dt>" + markup_text(name) + "</dt><dd>" + value + "</dd></div>";
}

/// The numbers of a rank, each with its name.
std::string rank_html(const RankView& rank) {
    const std::string before = rank.rank_before >= 0 && rank.rank_before != rank.rank
                                   ? std::to_string(rank.rank_before) + " → "
                                   : "";
    return "<dl class=\"numbers\">" + item(tr("equations"), std::to_string(rank.rows)) +
           item(tr("columns"), std::to_string(rank.columns)) +
           item(tr("rank"), before + std::to_string(rank.rank)) +
           item(tr("freedoms"), std::to_string(rank.dof)) +
           item(tr("redundant"), std::to_string(rank.redundant())) + "</dl>\n";
}

std::string combinations_html(const RankView& rank) {
    std::string items;
    for (const std::string& combination : rank.combinations) {
        items += "<li>" + words_html(combination) + "</li>\n";
    }
    return items.empty() ? items
                         : "<details><summary>" + markup_text(tr("Redundant equations")) +
                               "</summary>\n<ul>\n" + items + "</ul>\n</details>\n";
}

std::string equations_html(const std::vector<EquationGroup>& groups) {
    std::string html;
    for (const EquationGroup& group : groups) {
        html += "<div class=\"equation\">" + html_words("$$" + group.formula + "$$");
        if (group.choice && !group.choice->reason.empty()) {
            html += "<p>" + words_html(group.choice->reason) + "</p>";
        }
        html += "</div>\n";
    }
    return html;
}

std::string answers_html(const QuestionView& question) {
    std::string html;
    for (const std::string& choice : question.choices) { html += "<li>" + words_html(choice) + "</li>\n"; }
    if (!html.empty()) { html = "<ol>\n" + html + "</ol>\n"; }
    return html + "<details><summary>" + markup_text(tr("Answer")) + "</summary>\n" +
           paragraphs_html(question.answer) + paragraphs_html(question.why) + "</details>\n";
}

}  // namespace

std::string LessonParts::go(const std::string& fragment, const char* words) const {
    return link_html(*top_ + live_address(fragment), markup_text(words), "go");
}

std::string LessonParts::part(const char* id, const std::string& title, const std::string& content) const {
    if (content.empty()) { return {}; }
    return "<section class=\"" + std::string(id) + "\" id=\"" + id + "\">\n<h2>" + markup_text(title) +
           "</h2>\n" + content + "</section>\n";
}

std::string LessonParts::station(const Station& station) const {
    const View view = view_of(*story_, station.told, ViewParts::without_matrix);
    host::Address address;
    address.lesson = lesson_->address;
    address.at = std::to_string(station.told + 1);
    std::string html = "<section class=\"station\" id=\"" + station.id + "\">\n<h3>" +
                       words_html(station.moves ? tr("Motion, t = {0} s", number_text(view.t)) : view.title) +
                       "</h3>\n";
    if (station.pictured) {
        html += "<img loading=\"lazy\" width=\"800\" height=\"500\" src=\"" + *top_ +
                path_in_address(path_of_picture(*lesson_, station)) + "\" alt=\"" +
                markup_text(words_plain(view.title)) + "\" />\n";
    }
    if (station.equations >= 0) {
        html += equations_html(view_of(*story_, station.equations, ViewParts::without_matrix).equations);
    }
    // the text of the lesson is already at the top of the page
    const bool bodies = view.kind == Step::Kind::bodies;
    html += paragraphs_html(bodies ? lesson_->lesson.step_texts.bodies : view.author_text);
    if (!station.moves) { html += paragraphs_html(view.sentence); }
    if (!station.moves && !bodies) { html += rank_html(view.rank); }
    if (!view.failure.empty()) { html += "<p class=\"failure\">" + words_html(view.failure) + "</p>\n"; }
    return html + combinations_html(view.rank) + "<p>" +
           go(fragment_of(address), tr("Show it in the figure")) + "</p>\n</section>\n";
}

std::string LessonParts::stations(const std::vector<Station>& stations) const {
    std::string html;
    for (const Station& one : stations) { html += station(one); }
    return part("steps", tr("Step by step"), html);
}

std::string LessonParts::questions() const {
    std::string html;
    for (const Step& step : story_->steps()) {
        if (step.kind != Step::Kind::answer) { continue; }
        const QuestionView question = question_view_of(*story_, step);
        html += "<li>" + paragraphs_html(question.ask) + answers_html(question) + "</li>\n";
    }
    return part("questions", tr("Questions"), html.empty() ? html : "<ol>\n" + html + "</ol>\n");
}

std::string LessonParts::summary() const {
    return part("summary", tr("To remember"), paragraphs_html(lesson_->lesson.summary));
}

std::string LessonParts::trials() const {
    std::string html;
    for (const Trial& trial : lesson_->lesson.trials) {
        host::Address address;
        address.lesson = lesson_->address;
        address.experiments = trial.actions;
        html += "<li>" + paragraphs_html(trial.text) + "<p>" +
                go(fragment_of(address),
                   trial.breaks ? tr("Break it in the figure") : tr("Try it in the figure")) +
                "</p></li>\n";
    }
    return part("trials", tr("To try"), html.empty() ? html : "<ul>\n" + html + "</ul>\n");
}

std::string LessonParts::exercise(const Exercise& exercise) const {
    host::Address address;
    address.lesson = lesson_->address;
    address.exercise = exercise.name;
    std::string hints;
    for (std::size_t k = 0; k < exercise.hints.size(); ++k) {
        hints += "<details><summary>" + markup_text(tr("Hint {0}", k + 1)) + "</summary>\n" +
                 paragraphs_html(exercise.hints[k]) + "</details>\n";
    }
    return "<section class=\"exercise\" id=\"exercise-" + exercise.name + "\">\n<h3>" +
           words_html(exercise.title) + "</h3>\n" +
           (exercise.source.empty()
                ? std::string()
                : "<p class=\"source\">" + source_html(exercise.source, *top_) + "</p>\n") +
           paragraphs_html(exercise.ask) + hints + "<p>" +
           go(fragment_of(address), tr("Solve it in the figure")) + "</p>\n</section>\n";
}

std::string LessonParts::exercises() const {
    std::string html;
    for (const Exercise& one : lesson_->exercises) { html += exercise(one); }
    if (html.empty()) { return html; }
    return part(
        "exercises", tr("Exercises"),
        "<p>" +
            markup_text(tr("The figure chooses numbers of your own and says what is wrong with an answer; "
                           "nothing is sent anywhere.")) +
            "</p>\n" + html);
}

std::string LessonParts::claims() const {
    std::string rows;
    for (const ClaimResult& claim : lesson_->claims) {
        rows += "<tr><td>" + words_html(claim.moment) + "</td><td>" + words_html(claim.subject) +
                "</td><td>" + words_html(claim.expected) + "</td></tr>\n";
    }
    if (rows.empty()) { return rows; }
    const auto count = static_cast<int>(lesson_->claims.size());
    return part(
        "claims", tr("Proved"),
        "<details><summary>" +
            markup_text(tr_count(
                count, "{0} claim of this lesson was computed when this page was made, and holds",
                "{0} claims of this lesson were computed when this page was made, and all hold")) +
            "</summary>\n<div class=\"wide\"><table>\n<thead><tr><th>" + markup_text(tr("when")) +
            "</th><th>" + markup_text(tr("what")) + "</th><th>" + markup_text(tr("value")) +
            "</th></tr></thead>\n<tbody>\n" + rows + "</tbody>\n</table></div>\n</details>\n");
}

std::string lessons_folder_of(const SiteCourse& course) {
    const std::filesystem::path whole = std::filesystem::absolute(course.folder).lexically_normal();
    const std::string name = (whole.has_filename() ? whole : whole.parent_path()).filename().generic_string();
    // the folder of exercises is beside it, so the two names must differ
    return name.empty() || name == kExercisesFolder ? "lessons" : name;
}

}  // namespace jw::site
