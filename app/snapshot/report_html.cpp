#include <algorithm>

#include "app/session/encoding/base64.hpp"
#include "app/session/encoding/html_words.hpp"
#include "app/snapshot/report_parts.hpp"
#include "app/snapshot/reports.hpp"

namespace jw::snapshot {

namespace {

std::string image_source(const std::vector<std::uint8_t>& png) {
    return "data:image/png;base64," + base64(png);
}

std::string figure_of(const std::vector<std::uint8_t>& png, const std::string& words) {
    if (png.empty()) { return {}; }
    return "<figure><img src=\"" + image_source(png) + "\" alt=\"" + xml_attribute(words) +
           "\"><figcaption>" + xml_text(words) + "</figcaption></figure>";
}

/// Expected and actual picture on top of each other, with a slider between them; below, the differences.
std::string comparison_of(const SnapshotResult& result) {
    if (result.golden_png.empty() || result.actual_png.empty()) {
        return "<div class=\"row\">" + figure_of(result.golden_png, "expected") +
               figure_of(result.actual_png, "now") + "</div>\n";
    }
    return "<div class=\"compare\"><div class=\"over\"><img src=\"" + image_source(result.actual_png) +
           "\" alt=\"now\"><img class=\"top\" src=\"" + image_source(result.golden_png) +
           "\" alt=\"expected\"></div><label>left: expected, right: now <input type=\"range\" min=\"0\" "
           "max=\"100\" value=\"50\" aria-label=\"where expected and present picture meet\"></label> <button "
           "type=\"button\">Blink</button></div>\n<div class=\"row\">" +
           figure_of(result.marked_png, "colours that differ, in red") +
           figure_of(result.marked_ids_png, "things or depths that differ, in red") + "</div>\n";
}

constexpr std::size_t kFactsAtOnce = 12;
/// The page has the pictures of this many snapshots of a lesson: with more it would be too large to open.
constexpr int kMostPictures = 12;

std::string row_of(const FactChange& change) {
    return "<tr><td>" + xml_text(change.name) + "</td><td>" + xml_text(change.before) + "</td><td>" +
           xml_text(change.after) + "</td></tr>\n";
}

std::string table_of(const std::vector<FactChange>& facts, std::size_t from, std::size_t to) {
    std::string rows;
    for (std::size_t k = from; k < to; ++k) { rows += row_of(facts[k]); }
    return "<table><tr><th>what</th><th>expected</th><th>now</th></tr>\n" + rows + "</table>\n";
}

std::string facts_of(const std::vector<FactChange>& facts) {
    if (facts.empty()) { return {}; }
    const std::size_t first = std::min(facts.size(), kFactsAtOnce);
    std::string html = table_of(facts, 0, first);
    if (first < facts.size()) {
        html += "<details><summary>" + std::to_string(facts.size() - first) + " more</summary>" +
                table_of(facts, first, facts.size()) + "</details>\n";
    }
    return html;
}

std::string section_of(const SnapshotResult& result, bool with_pictures) {
    std::string html = "<h3>" + xml_text(result.name) + " <span class=\"" +
                       (fails(result.verdict) ? "bad" : "soft") + "\">" + word_of(result.verdict) +
                       "</span></h3>\n<div class=\"soft\">" + xml_text(result.title) + "</div>\n<ul>";
    for (const std::string& reason : reasons_of(result)) { html += "<li>" + xml_text(reason) + "</li>"; }
    for (const std::string& thing : result.difference.things) { html += "<li>" + xml_text(thing) + "</li>"; }
    return html + "</ul>\n" + facts_of(result.difference.facts) +
           (with_pictures ? comparison_of(result)
                          : "<p class=\"soft\">Its pictures are left out: those above are enough.</p>\n");
}

std::string controls_of(const LessonResult& result) {
    const auto& [made, skipped] = result.controls;
    if (made.empty() && skipped.empty()) { return {}; }
    std::string html = "<details><summary>negative controls: faults that must be noticed</summary><ul>";
    for (const ControlResult& control : made) {
        html += std::string("<li class=\"") + (control.noticed ? "good" : "bad") + "\">" +
                xml_text(
                    control.fault + " (" + control.layer +
                    "): " + (control.noticed ? "noticed" : "NOT NOTICED")) +
                "</li>";
    }
    for (const SkippedControl& control : skipped) {
        html += "<li class=\"soft\">" +
                xml_text(control.fault + " (" + control.layer + "): not made here, " + control.reason) +
                "</li>";
    }
    return html + "</ul></details>\n";
}

std::string section_of(const LessonResult& result) {
    std::string html = "<h2>" + xml_text(result.lesson.name) + " <span class=\"" +
                       (result.fails() ? "bad\">differs" : "good\">as expected") +
                       "</span></h2>\n<div class=\"soft\">" + xml_text(result.title) + "</div>\n";
    if (!result.problem.empty()) { return html + "<p class=\"bad\">" + xml_text(result.problem) + "</p>\n"; }
    if (const std::string why = result.explanation(); !why.empty()) {
        html += "<p class=\"why\">" + xml_text(why) + "</p>\n";
    }
    if (const std::string steps = result.steps_line(); !steps.empty() && steps != result.explanation()) {
        html += "<p>" + xml_text(steps) + "</p>\n";
    }
    if (result.lesson_changes.size() > 1) {
        html += "<ul>";
        for (const std::string& line : result.lesson_changes) { html += "<li>" + xml_text(line) + "</li>"; }
        html += "</ul>\n";
    }
    std::string same;
    int shown = 0;
    for (const SnapshotResult& snapshot : result.snapshots) {
        if (snapshot.verdict == Verdict::same) {
            same += (same.empty() ? "" : ", ") + snapshot.name;
        } else {
            html += section_of(snapshot, ++shown <= kMostPictures);
        }
    }
    if (!same.empty()) { html += "<p class=\"soft\">Same as before: " + xml_text(same) + "</p>\n"; }
    return html + controls_of(result);
}

}  // namespace

std::string html_of(const std::vector<LessonResult>& results) {
    std::string html =
        std::string(
            "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
            "content=\"width=device-width\"><title>Snapshots</title><style>") +
        kStyle + "</style></head><body>\n<h1>Snapshots</h1>\n<p>" + xml_text(summary(results)) + "</p>\n";
    std::vector<const LessonResult*> sorted;
    for (const LessonResult& result : results) { sorted.push_back(&result); }
    std::ranges::stable_sort(
        sorted, std::ranges::greater(), [](const LessonResult* r) { return r->fails(); });
    for (const LessonResult* const result : sorted) { html += section_of(*result); }
    return html + "<script>" + kScript + "</script></body></html>\n";
}

}  // namespace jw::snapshot
