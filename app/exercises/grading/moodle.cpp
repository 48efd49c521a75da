#include <algorithm>
#include <cmath>

#include "app/exercises/grading/sheet.hpp"
#include "app/session/encoding/base64.hpp"
#include "app/session/encoding/html_words.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "app/session/wording/shown_lesson.hpp"

namespace jw {

namespace {

// Moodle compares decimals: these are more digits than any tolerance asks for
constexpr int kMoodleDigits = 12;

bool is_for_quizzes(const Exercise& exercise) {
    switch (exercise.kind) {
        case ExerciseKind::number:
        case ExerciseKind::vector:
        case ExerciseKind::matrix:
        case ExerciseKind::choose:
        case ExerciseKind::order: return true;
        default: return false;
    }
}

std::string cdata(const std::string& html) {
    std::string safe = html;
    for (std::size_t at = safe.find("]]>"); at != std::string::npos; at = safe.find("]]>", at + 12)) {
        safe.replace(at, 3, "]]]]><![CDATA[>");
    }
    return "<text><![CDATA[" + safe + "]]></text>";
}

/// The question's text; the figure is included as a file.
std::string question_text(const SheetEntry& entry, const std::string& more) {
    const Exercise& exercise = entry.task.exercise();
    std::string html = "<p>" + html_words(exercise.ask) + "</p>";
    std::string file;
    if (!entry.figure.empty()) {
        const std::string name = exercise.name + ".png";
        html +=
            "<p><img src=\"@@PLUGINFILE@@/" + name + "\" alt=\"" + markup_text(tr("the scene")) + "\"></p>";
        file =
            "<file name=\"" + name + "\" path=\"/\" encoding=\"base64\">" + base64(entry.figure) + "</file>";
    }
    for (const std::string& given : entry.given) { html += "<p>" + html_words(given) + "</p>"; }
    return "<questiontext format=\"html\">" + cdata(html + more) + file + "</questiontext>\n";
}

/// Name of a category with its slashes doubled: one slash would begin another category; Moodle reads two as
/// one slash of the name (qformat_default, question/format.php).
std::string category_name(const std::string& name) {
    std::string doubled;
    for (const char c : name) { doubled += c == '/' ? std::string("//") : std::string(1, c); }
    return markup_text(doubled);
}

std::string feedback_of(const KnownMistake& mistake) {
    return followed(
        tr(mistake.says), mistake.slide.empty() ? "" : tr("Look at {0}.", shown_slides(mistake.slide)));
}

double tolerance_of_entry(const Asked& asked) { return asked.tolerance > 0.0 ? asked.tolerance : 1e-6; }

std::string numerical(const SheetEntry& entry) {
    const Asked& asked = entry.task.asked;
    const auto answer = [&](double value, int fraction, const std::string& feedback) {
        return "<answer fraction=\"" + std::to_string(fraction) + "\"><text>" +
               number_text(value, kMoodleDigits) + "</text><tolerance>" +
               number_text(tolerance_of_entry(asked), 6) + "</tolerance><feedback format=\"html\">" +
               cdata(markup_text(feedback)) + "</feedback></answer>\n";
    };
    std::string xml = answer(asked.right(0, 0), 100, tr("Right."));
    if (asked.turn > 0.0) {
        xml += answer(asked.right(0, 0) + asked.turn, 100, tr("Right.")) +
               answer(asked.right(0, 0) - asked.turn, 100, tr("Right."));
    }
    for (const KnownMistake& mistake : asked.mistakes) {
        xml += answer(mistake.answer(0, 0), 0, feedback_of(mistake));
    }
    return xml;
}

/// Text within a gap of a cloze question. Moodle decodes entities in feedback, but removes a backslash only
/// before } and #: before other signs the student would see it.
std::string in_gap(const std::string& text) {
    std::string escaped;
    for (const char c : markup_text(text)) {
        if (std::string_view("{}~\\").find(c) != std::string_view::npos) {
            escaped += "&#" + std::to_string(static_cast<int>(c)) + ";";
        } else {
            escaped += c == '\n' ? ' ' : c;
        }
    }
    return escaped;
}

/// One gap: the right entry, and the entries of mistakes that differ from it and from one another.
std::string gap(const Asked& asked, Eigen::Index r, Eigen::Index c) {
    const double tolerance = tolerance_of_entry(asked);
    std::vector<double> used{asked.right(r, c)};
    const std::string width = number_text(tolerance, 6);
    std::string text = "{1:NUMERICAL:=" + number_text(used.front(), kMoodleDigits) + ":" + width + "#" +
                       in_gap(tr("Right."));
    for (const KnownMistake& mistake : asked.mistakes) {
        const double value = mistake.answer(r, c);
        const bool is_new =
            std::ranges::all_of(used, [&](double u) { return std::abs(u - value) > 2.0 * tolerance; });
        if (!is_new) { continue; }
        used.push_back(value);
        text += "~%0%" + number_text(value, kMoodleDigits) + ":" + width + "#" + in_gap(feedback_of(mistake));
    }
    return text + "}";
}

std::string gaps(const SheetEntry& entry) {
    const Asked& asked = entry.task.asked;
    std::string html = "<table>";
    for (Eigen::Index r = 0; r < asked.right.rows(); ++r) {
        html += "<tr>";
        for (Eigen::Index c = 0; c < asked.right.cols(); ++c) { html += "<td>" + gap(asked, r, c) + "</td>"; }
        html += "</tr>";
    }
    return html + "</table>";
}

std::string choices_xml(const SheetEntry& entry) {
    const Asked& asked = entry.task.asked;
    std::string xml =
        "<single>true</single><shuffleanswers>false</shuffleanswers><answernumbering>123</answernumbering>\n";
    for (std::size_t k = 0; k < entry.task.shown.size(); ++k) {
        const double number = static_cast<double>(k + 1);
        const bool right = asked.right(0, 0) == number;
        const auto mistake = std::ranges::find_if(
            asked.mistakes, [&](const KnownMistake& m) { return m.answer(0, 0) == number; });
        const std::string feedback = right                             ? tr("Right.")
                                     : mistake != asked.mistakes.end() ? feedback_of(*mistake)
                                                                       : "";
        xml += std::string("<answer fraction=\"") + (right ? "100" : "0") + "\" format=\"html\">" +
               cdata(html_words(entry.task.shown[k])) + "<feedback format=\"html\">" +
               cdata(html_words(feedback)) + "</feedback></answer>\n";
    }
    return xml;
}

std::string short_answers(const SheetEntry& entry) {
    const auto answer = [](const MatrixX& order, int fraction, const std::string& feedback) {
        std::string text;
        for (Eigen::Index k = 0; k < order.rows(); ++k) {
            text += (k > 0 ? "*" : "") + number_text(order(k, 0), 3);
        }
        return "<answer fraction=\"" + std::to_string(fraction) + "\"><text>" + text +
               "</text><feedback format=\"html\">" + cdata(html_words(feedback)) + "</feedback></answer>\n";
    };
    // a star matches any text between the numbers
    std::string xml = "<usecase>0</usecase>\n" + answer(entry.task.asked.right, 100, tr("Right."));
    for (const KnownMistake& mistake : entry.task.asked.mistakes) {
        xml += answer(mistake.answer, 0, feedback_of(mistake));
    }
    return xml;
}

std::string items_html(const SheetEntry& entry) {
    std::string html = "<ol>";
    for (const std::string& item : entry.task.shown) { html += "<li>" + html_words(item) + "</li>"; }
    return html + "</ol><p>" + markup_text(hand_in_text(entry)) + "</p>";
}

/// Moodle reads only numbers, not fractions or units.
std::string unit_html(const SheetEntry& entry) {
    const std::string& unit = entry.task.asked.unit;
    const std::string words = followed(
        unit.empty() ? "" : tr("The answer is in {0}, as a number without the unit.", unit),
        accuracy_text(entry.task));
    return words.empty() ? words : "<p>" + markup_text(words) + "</p>";
}

std::string question_xml(const SheetEntry& entry, const std::string& student) {
    const Exercise& exercise = entry.task.exercise();
    std::string type = "cloze";
    std::string more;
    std::string answers;
    if (exercise.kind == ExerciseKind::number) {
        type = "numerical";
        more = unit_html(entry);
        answers = numerical(entry);
    } else if (exercise.kind == ExerciseKind::choose) {
        type = "multichoice";
        answers = choices_xml(entry);
    } else if (exercise.kind == ExerciseKind::order) {
        type = "shortanswer";
        more = items_html(entry);
        answers = short_answers(entry);
    } else {
        more = unit_html(entry) + gaps(entry);
    }
    return "<question type=\"" + type + "\">\n<name><text>" + markup_text(exercise.name + " " + student) +
           "</text></name>\n" + question_text(entry, more) + "<generalfeedback format=\"html\">" +
           cdata(html_words(exercise.why)) + "</generalfeedback>\n" +
           (type == "cloze" ? "" : "<defaultgrade>" + number_text(exercise.points, 6) + "</defaultgrade>\n") +
           answers + "</question>\n";
}

}  // namespace

std::string moodle_xml(const std::vector<Sheet>& sheets, const std::string& category) {
    std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<quiz>\n";
    if (sheets.empty()) { return xml + "</quiz>\n"; }
    for (std::size_t k = 0; k < sheets.front().entries.size(); ++k) {
        const std::string name = sheets.front().entries[k].task.exercise().name;
        if (!is_for_quizzes(sheets.front().entries[k].task.exercise())) { continue; }
        // a category for each exercise: a quiz takes one of its questions at random
        xml += "<question type=\"category\"><category><text>$course$/top/" + category_name(category) + "/" +
               category_name(name) + "</text></category></question>\n";
        for (const Sheet& sheet : sheets) {
            const auto entry = std::ranges::find_if(
                sheet.entries, [&](const SheetEntry& e) { return e.task.exercise().name == name; });
            if (entry != sheet.entries.end()) { xml += question_xml(*entry, sheet.student); }
        }
    }
    return xml + "</quiz>\n";
}

std::vector<std::string> not_for_quizzes(const Sheet& sheet) {
    std::vector<std::string> names;
    for (const SheetEntry& entry : sheet.entries) {
        if (!is_for_quizzes(entry.task.exercise())) { names.push_back(entry.task.exercise().name); }
    }
    return names;
}

}  // namespace jw
