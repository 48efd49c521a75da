#include "app/exercises/grading/page_styles.hpp"
#include "app/exercises/grading/sheet.hpp"
#include "app/session/encoding/base64.hpp"
#include "app/session/encoding/html_words.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw {

namespace {

std::string list_html(const std::vector<std::string>& items) {
    std::string html;
    for (const std::string& item : items) { html += "<li>" + html_words(item) + "</li>\n"; }
    return html.empty() ? html : "<ol>\n" + html + "</ol>\n";
}

std::string given_html(const SheetEntry& entry) {
    std::string html;
    for (const std::string& given : entry.given) { html += "<span>" + html_words(given) + "</span>\n"; }
    return html.empty() ? html : "<div class=\"given\">" + html + "</div>\n";
}

std::string hints_html(const Exercise& exercise) {
    std::string html;
    for (std::size_t k = 0; k < exercise.hints.size(); ++k) {
        html += "<details><summary>" + markup_text(tr("Hint {0}", k + 1)) + "</summary>" +
                html_words(exercise.hints[k]) + "</details>\n";
    }
    return html;
}

std::string solution_html(const SheetEntry& entry) {
    const Exercise& exercise = entry.task.exercise();
    std::string html = "<div class=\"solution\"><p><b>" + markup_text(tr("Solution.")) + "</b> <code>" +
                       markup_text(solution_text(entry)) + "</code></p>\n";
    if (!entry.task.asked.latex.empty()) {
        html += "<p>" + html_words("$$" + entry.task.asked.latex + "$$") + "</p>\n";
    }
    if (!exercise.why.empty()) { html += "<p>" + html_words(exercise.why) + "</p>\n"; }
    std::string rows;
    for (const KnownMistake& mistake : entry.task.asked.mistakes) {
        rows += "<li><code>" + markup_text(written(mistake.answer, 5)) + "</code> " +
                html_words(mistake_text(mistake)) + "</li>\n";
    }
    if (!rows.empty()) {
        html += "<details><summary>" + markup_text(tr("Known mistakes")) + "</summary><ul>\n" + rows +
                "</ul></details>\n";
    }
    return html + "</div>\n";
}

std::string code_html(const std::string& text) { return "<code>" + markup_text(text) + "</code>"; }

std::string hand_in_html(const SheetEntry& entry) {
    const Exercise& exercise = entry.task.exercise();
    std::string html;
    if (!entry.file.empty()) { html = tr("The scene is in the file {0}.", code_html(entry.file)); }
    html = followed(html, markup_text(followed(unit_text_of(entry), hand_in_text(entry))));
    if (exercise.kind == ExerciseKind::code) {
        std::string names;
        for (const std::string& name : input_names(exercise)) {
            names += (names.empty() ? "" : " ") + code_html(name);
        }
        html = followed(html, tr("Inputs of a case: {0}.", names));
    }
    return "<p class=\"hand\">" + html + "</p>\n";
}

}  // namespace

std::string sheet_html(const Sheet& sheet, bool solution) {
    std::string html =
        "<!doctype html>\n<html lang=\"" + std::string(language()) +
        "\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\"><title>" +
        markup_text(sheet.title) + "</title><style>" + kSheetStyle + "</style></head><body>\n<h1>" +
        html_words(sheet.title) + "</h1>\n<p class=\"head\">" + markup_text(student_text(sheet, solution)) +
        "</p>\n";
    for (const SheetEntry& entry : sheet.entries) {
        const Exercise& exercise = entry.task.exercise();
        html += "<section>\n<h2>" + entry.number + ". " + html_words(exercise.title) +
                "</h2>\n<p class=\"head\">" +
                tr("{0}; answer {1}", markup_text(head_text(entry)), code_html(exercise.name)) + "</p>\n<p>" +
                html_words(exercise.ask) + "</p>\n";
        if (!entry.figure.empty()) {
            html += "<figure><img alt=\"" + markup_text(tr("the scene of {0}", exercise.name)) +
                    "\" src=\"data:image/png;base64," + base64(entry.figure) + "\"></figure>\n";
        }
        html += given_html(entry) + list_html(entry.task.shown) + hand_in_html(entry) + hints_html(exercise);
        if (solution) { html += solution_html(entry); }
        html += "</section>\n";
    }
    return html + "</body></html>\n";
}

}  // namespace jw
