#include "app/snapshot/explanation.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "app/snapshot/facts/facts.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/exercise/scene_difference.hpp"
#include "lessons/exercise/scene_edits.hpp"
#include "lessons/format/key.hpp"

namespace jw::snapshot {

namespace {

constexpr std::size_t kLongestValue = 60;
constexpr std::size_t kBeforeChange = 20;  // bytes of a long text that are shown before its change

constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};

/// The number of the right choice: a number, but "larger" and "smaller" make no sense for it.
constexpr std::string_view kChoice = "answer";

/// Values of a function of time, in the unit of the function.
constexpr std::array<std::string_view, 6> kValues{"polynomial", "amplitude", "from",
                                                  "to",         "values",    "formula"};

/// "radius" of "body.crank.shape.0.rod.radius"
std::string_view last_key(std::string_view path) { return path.substr(path.find_last_of('.') + 1); }

/// "body" of "body.crank.shape.0.rod.radius"
std::string_view table_of(std::string_view path) { return path.substr(0, path.find('.')); }

/// "body.crank" of "body.crank.shape.0.rod.radius"; all of a shorter path
std::string entry_of(const std::string& path) {
    const std::size_t first = path.find('.');
    return first == std::string::npos ? path : path.substr(0, path.find('.', first + 1));
}

/// Unit of a number of a force or torque; empty for those that have none.
std::string unit_of_load(const std::string& lesson, const std::string& path, std::size_t index) {
    const std::string unit = table_of(path) == "force" ? "N" : "N m";
    const std::string_view key = last_key(path);
    if (std::ranges::find(kValues, key) == kValues.end()) { return {}; }
    // beside a vector in N, a function is only a factor
    const bool is_factor = value_in(lesson, entry_of(path) + ".direction").empty();
    return is_factor ? std::string() : unit_of_coefficient(unit, key == "polynomial" ? index : 0);
}

/// A difference of two numbers with its unit: "1 mm", "0.2 m", "5 deg", "1 N"; without a unit if it is not
/// known.
/// @param lesson  the other keys of the load tell whether a function of time is a force or a factor of one
/// @param path    of the key, as `difference_of` names it
/// @param index   of the number in its list, 0 for a single one
std::string amount_text(
    const std::string& lesson, const std::string& path, std::size_t index, double amount) {
    const std::string_view table = table_of(path);
    std::string unit = unit_of_key(path);
    if (unit.empty() && (table == "force" || table == "torque")) { unit = unit_of_load(lesson, path, index); }
    if (unit == "m" && amount < 0.1) { return short_number(1000.0 * amount, 4) + " mm"; }
    return short_number(amount, 4) + (unit.empty() ? "" : " " + unit);
}

/// "crank" of "body.crank.shape.0.rod.radius"; empty for a key of the lesson itself.
std::string subject_of(const std::string& path) {
    const std::size_t first = path.find('.');
    if (first == std::string::npos) { return {}; }
    const std::size_t second = path.find('.', first + 1);
    if (second == std::string::npos) { return path.substr(0, first); }
    const std::string name = path.substr(first + 1, second - first - 1);
    const bool is_number = name.find_first_not_of("0123456789") == std::string::npos;
    // counted from 1, as names of snapshots are: "answer-1" belongs to the first question
    return is_number ? path.substr(0, first) + " " + std::to_string(std::stoul(name) + 1) : name;
}

/// The number, or the numbers of a list; empty if it is neither.
std::vector<double> numbers_in(std::string_view text) {
    std::vector<double> numbers;
    while (!text.empty()) {
        if (text.front() == ' ' || text.front() == ',' || text.front() == '[' || text.front() == ']') {
            text.remove_prefix(1);
            continue;
        }
        double value = 0.0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc()) { return {}; }
        numbers.push_back(value);
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    }
    return numbers;
}

/// "1 mm larger", "x 2 mm smaller, z 1 mm larger"; nothing for values that are not numbers.
std::optional<std::string> in_numbers(
    const std::string& lesson, const std::string& path, const std::string& before, const std::string& now) {
    const std::vector<double> a = numbers_in(before);
    const std::vector<double> b = numbers_in(now);
    if (a.empty() || a.size() != b.size()) { return std::nullopt; }
    std::string text;
    for (std::size_t k = 0; k < a.size(); ++k) {
        if (a[k] == b[k]) { continue; }
        const std::string which = a.size() == 1   ? ""
                                  : a.size() == 3 ? std::string(kAxes[k]) + " "
                                                  : "number " + std::to_string(k + 1) + " ";
        text += (text.empty() ? "" : ", ") + which + amount_text(lesson, path, k, std::abs(b[k] - a[k])) +
                (b[k] > a[k] ? " larger" : " smaller");
    }
    return text;
}

/// A value as it is shown: numbers as they are usually written.
std::string shown(const std::string& value) {
    const std::vector<double> numbers = numbers_in(value);
    std::string line = numbers.empty() ? value : "";
    for (const double number : numbers) { line += (line.empty() ? "" : ", ") + short_number(number, 9); }
    if (numbers.size() > 1) { line = "[" + line + "]"; }
    std::ranges::replace(line, '\n', ' ');
    return line;
}

/// The start of the character that a byte belongs to.
std::size_t character_at(std::string_view text, std::size_t byte) {
    while (byte > 0 && byte < text.size() && (static_cast<unsigned char>(text[byte]) & 0xC0U) == 0x80U) {
        --byte;
    }
    return std::min(byte, text.size());
}

/// The piece of a long text around this byte.
std::string piece_of(std::string_view text, std::size_t byte) {
    if (text.size() <= kLongestValue) { return std::string(text); }
    const std::size_t from = character_at(text, byte < kBeforeChange ? 0 : byte - kBeforeChange);
    const std::size_t to = character_at(text, from + kLongestValue);
    return (from > 0 ? "..." : "") + std::string(text.substr(from, to - from)) +
           (to < text.size() ? "..." : "");
}

/// "'before' → 'now'"; for long texts, the piece where they begin to differ.
std::string both_shown(const std::string& before, const std::string& now) {
    const std::string a = shown(before);
    const std::string b = shown(now);
    const auto first = static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
    return piece_of(a, first) + " → " + piece_of(b, first);
}

/// "radius of crank"; "force on rod" for the vector of a force, "polynomial of force on rod".
std::string what_changed(const std::string& path, const std::string& lesson_before) {
    const std::string key(last_key(path));
    const std::string table(table_of(path));
    const std::string subject = subject_of(path);
    if (table != "force" && table != "torque") { return key + (subject.empty() ? "" : " of " + subject); }
    std::string body = value_in(lesson_before, entry_of(path) + ".body");
    std::erase_if(body, [](char c) { return c == '\'' || c == '"'; });
    return (key == table ? "" : key + " of ") + table + " on " + body;
}

/// "joint.A: added"; "shape 2 of crank: inserted (body.crank.shape.1)" for an entry without a name.
std::string entry_text(const std::string& path, bool is_there_now) {
    const std::string key(last_key(path));
    if (key.find_first_not_of("0123456789") != std::string::npos) {
        return path + (is_there_now ? ": added" : ": left out");
    }
    const std::string what = is_there_now ? "inserted" : "left out";
    const std::string list = path.substr(0, path.rfind('.'));
    const std::string subject = list.find('.') == std::string::npos ? "" : " of " + subject_of(list);
    return std::string(last_key(list)) + " " + std::to_string(std::stoul(key) + 1) + subject + ": " + what +
           " (" + path + ")";
}

/// "order of bodies: frame, leaf → leaf, frame"; entries without a name are numbered from 1.
std::string order_text(const OtherOrder& order) {
    const std::string key(last_key(order.path));
    const std::string subject = order.path == key ? "" : " of " + subject_of(order.path);
    const auto line = [&](const std::vector<std::string>& entries) {
        std::string text;
        for (const std::string& entry : entries) {
            const bool is_number = entry.find_first_not_of("0123456789") == std::string::npos;
            text += (text.empty() ? "" : ", ") + (is_number ? std::to_string(std::stoul(entry) + 1) : entry);
        }
        return text;
    };
    return "order of " + (key == "body" ? "bodies" : key + "s") + subject + ": " +
           both_shown(line(order.before), line(order.after));
}

std::string change_text(
    const std::string& path, const std::string& lesson_before, const std::string& lesson_now) {
    const std::string before = value_in(lesson_before, path);
    const std::string now = value_in(lesson_now, path);
    const std::string values = both_shown(before, now);
    const std::string what = what_changed(path, lesson_before);
    const auto difference =
        last_key(path) == kChoice ? std::optional<std::string>() : in_numbers(lesson_now, path, before, now);
    const std::string place = path.find('.') == std::string::npos ? values : path + ", " + values;
    return difference ? what + ": " + *difference + " (" + place + ")" : what + ": " + values;
}

}  // namespace

std::vector<std::string> lesson_changes(const std::string& before, const std::string& now) {
    const SceneDifference found = jw::difference_of(before, now, SceneParts::all);
    // the camera matters less than the things that it shows
    std::vector<std::string> lines;
    std::vector<std::string> of_camera;
    const auto add = [&](const std::string& path, std::string line) {
        const bool is_camera = path == "camera" || path.starts_with("camera.");
        (is_camera ? of_camera : lines).push_back(std::move(line));
    };
    for (const std::string& path : found.removed) { add(path, entry_text(path, false)); }
    for (const std::string& path : found.added) { add(path, entry_text(path, true)); }
    for (const OtherOrder& order : found.reordered) { add(order.path, order_text(order)); }
    for (const std::string& path : found.changed) { add(path, change_text(path, before, now)); }
    lines.insert(lines.end(), of_camera.begin(), of_camera.end());
    return lines;
}

}  // namespace jw::snapshot
