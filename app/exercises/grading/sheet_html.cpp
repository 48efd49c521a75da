#include "app/exercises/grading/markup.hpp"
#include "app/exercises/grading/sheet.hpp"

namespace jw {

namespace {

constexpr const char* kSheetStyle =
    "body{font:17px/1.5 Georgia,'DejaVu Serif',serif;max-width:46rem;margin:2rem auto;padding:0 "
    "1rem;color:#1d2733;"
    "background:#fff}h1,h2{font-family:system-ui,sans-serif;line-height:1.2}h2{margin:2.4rem 0 "
    ".2rem;font-size:1.15rem}"
    ".head{color:#5a6773;font:.85rem system-ui,sans-serif;margin:0 0 "
    ".8rem}.given{display:flex;flex-wrap:wrap;gap:.6rem "
    "1.6rem;margin:.8rem 0;align-items:center}figure{margin:1rem 0}img{max-width:100%;border:1px solid "
    "#dfe4ea}"
    ".hand{font:.9rem system-ui,sans-serif;color:#36424e}details{margin:.4rem "
    "0;font-size:.95rem}.solution{border-left:"
    "3px solid #2f7d4f;padding-left:1rem;margin-top:1rem}code{background:#eef1f4;padding:0 .25rem}@media "
    "print{h2{break-"
    "after:avoid}section{break-inside:avoid}details{display:none}}";

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
        html += "<details><summary>Hint " + std::to_string(k + 1) + "</summary>" +
                html_words(exercise.hints[k]) + "</details>\n";
    }
    return html;
}

std::string solution_html(const SheetEntry& entry) {
    const Exercise& exercise = entry.task.exercise();
    std::string html = "<div class=\"solution\"><p><b>Solution.</b> <code>" +
                       markup_text(solution_text(entry)) + "</code></p>\n";
    if (!entry.task.asked.latex.empty()) {
        html += "<p>" + html_words("$$" + entry.task.asked.latex + "$$") + "</p>\n";
    }
    if (!exercise.why.empty()) { html += "<p>" + html_words(exercise.why) + "</p>\n"; }
    std::string rows;
    for (const KnownMistake& mistake : entry.task.asked.mistakes) {
        rows += "<li><code>" + markup_text(written(mistake.answer, 5)) + "</code> " +
                html_words(mistake.title) + ". " + markup_text(mistake.says) + "</li>\n";
    }
    if (!rows.empty()) {
        html += "<details><summary>Known mistakes</summary><ul>\n" + rows + "</ul></details>\n";
    }
    return html + "</div>\n";
}

std::string hand_in_html(const SheetEntry& entry) {
    const Exercise& exercise = entry.task.exercise();
    std::string html = "<p class=\"hand\">";
    if (!entry.file.empty()) {
        html += "The scene is in the file <code>" + markup_text(entry.file) + "</code>. ";
    }
    if (!entry.task.asked.unit.empty()) {
        html += "The answer is in " + markup_text(entry.task.asked.unit) + ". ";
    }
    html += markup_text(hand_in_text(entry));
    if (exercise.kind == ExerciseKind::code) {
        html += " Inputs of a case:";
        for (const std::string& name : input_names(exercise)) {
            html += " <code>" + markup_text(name) + "</code>";
        }
        html += ".";
    }
    return html + "</p>\n";
}

}  // namespace

std::string sheet_html(const Sheet& sheet, bool solution) {
    std::string html =
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
        "content=\"width=device-width\"><title>" +
        markup_text(sheet.title) + "</title><style>" + kSheetStyle + "</style></head><body>\n<h1>" +
        html_words(sheet.title) + "</h1>\n<p class=\"head\">" + markup_text(sheet.student) +
        (solution ? ", solutions" : "") + "</p>\n";
    for (const SheetEntry& entry : sheet.entries) {
        const Exercise& exercise = entry.task.exercise();
        html += "<section>\n<h2>" + entry.number + ". " + html_words(exercise.title) +
                "</h2>\n<p class=\"head\">" + markup_text(head_text(entry)) + "; answer <code>" +
                markup_text(exercise.name) + "</code></p>\n<p>" + html_words(exercise.ask) + "</p>\n";
        if (!entry.figure.empty()) {
            html += "<figure><img alt=\"the scene of " + markup_text(exercise.name) +
                    "\" src=\"data:image/png;base64," + base64(entry.figure) + "\"></figure>\n";
        }
        html += given_html(entry) + list_html(entry.task.shown) + hand_in_html(entry) + hints_html(exercise);
        if (solution) { html += solution_html(entry); }
        html += "</section>\n";
    }
    return html + "</body></html>\n";
}

}  // namespace jw
