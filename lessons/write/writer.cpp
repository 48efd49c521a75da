#include "lessons/write/writer.hpp"

#include <algorithm>
#include <map>

#include "lessons/write/writing.hpp"

namespace jw {

namespace writing {

namespace {

constexpr std::size_t kPageWidth = 96;
// column of the comments in the shipped lessons
constexpr std::size_t kCommentColumn = 44;

}  // namespace

void Lines::section(const std::string& title) {
    std::string line = "# ---- " + title + ' ';
    line.resize(std::max(line.size(), kPageWidth), '-');
    text_ += '\n' + line + '\n';
}

void Lines::table(const std::string& header) { text_ += '\n' + header + '\n'; }

void Lines::key(const std::string& name, const std::string& value, const std::string& comment) {
    std::string line = name + " = " + value;
    if (!comment.empty()) {
        line.resize(std::max(line.size() + 2, kCommentColumn), ' ');
        line += "# " + comment;
    }
    text_ += line + '\n';
}

void Lines::key(const std::string& name, double value, const std::string& comment) {
    key(name, number_text(value), comment);
}

void Lines::key(const std::string& name, const Vec3& value, const std::string& comment) {
    key(name, vector_text(value), comment);
}

void Lines::text(const std::string& name, const Text& text) {
    key(name, string_text(text.own()));
    translations(name, text, string_text);
}

void Lines::words(const std::string& name, const Text& text) {
    key(name, words_text(text.own()));
    translations(name, text, words_text);
}

void Lines::translations(
    const std::string& name, const Text& text, std::string (*written)(const std::string&)) {
    for (const auto& [tag, translated] : text.translations()) { key(tag + '.' + name, written(translated)); }
}

void Lines::texts(const std::string& name, const std::vector<Text>& texts) {
    std::map<std::string, std::vector<std::string>> lists;
    std::vector<std::string> own;
    for (const Text& text : texts) {
        own.push_back(text.own());
        for (const auto& [tag, translated] : text.translations()) { lists[tag]; }
    }
    key(name, list_of_texts(own));
    for (auto& [tag, list] : lists) {
        for (const Text& text : texts) {
            const auto found = text.translations().find(tag);
            list.push_back(found != text.translations().end() ? found->second : text.own());
        }
        key(tag + '.' + name, list_of_texts(list));
    }
}

void Lines::angle(const std::string& name, double radians_of, const std::string& per) {
    const AngleTexts typed = typed_angles({&radians_of, 1});
    key(name + '_' + typed.unit + per, typed.values[0]);
}

void Lines::angles(const std::string& name, std::span<const double> radians_of, const std::string& per) {
    const AngleTexts typed = typed_angles(radians_of);
    const std::string in_radians = list_text(radians_of);
    const std::string text = list_text(typed.values);
    // the author probably typed the shorter of the two
    const bool shorter = in_radians.size() < text.size();
    key(name + '_' + (shorter ? "rad" : typed.unit) + per, shorter ? in_radians : text);
}

Written::Written(const Lesson& whole) : lesson(&whole) {
    const auto joint_is_in = [&](int joint) {
        return joint < 0 ||
               std::ranges::find(whole.order, Addition{Addition::Kind::joint, joint}) != whole.order.end();
    };
    for (const Addition& addition : whole.order) {
        const bool is_driver = addition.kind == Addition::Kind::driver;
        const auto index = static_cast<std::size_t>(addition.index);
        if (!is_driver || joint_is_in(whole.mechanism.drivers[index].joint)) { order.push_back(addition); }
    }
}

bool Written::has(const Addition& addition) const {
    return std::ranges::find(order, addition) != order.end();
}

const std::string& Written::name_of(const Addition& addition) const {
    const auto index = static_cast<std::size_t>(addition.index);
    return addition.kind == Addition::Kind::joint ? lesson->mechanism.joints[index].name
                                                  : lesson->mechanism.drivers[index].name;
}

const std::string& Written::body(int index) const {
    return lesson->mechanism.bodies[static_cast<std::size_t>(index)].name;
}

std::string list_of_texts(const std::vector<std::string>& texts) {
    std::string list;
    for (const std::string& text : texts) { list += (list.empty() ? "" : ", ") + string_text(text); }
    return "[" + list + "]";
}

std::string Written::pair(int body_i, int body_j) const {
    return '[' + string_text(body(body_i)) + ", " + string_text(body(body_j)) + ']';
}

}  // namespace writing

std::string lesson_text(const Lesson& lesson) {
    const writing::Written written(lesson);
    writing::Lines lines;
    writing::write_head(written, lines);
    writing::write_bodies(lesson, lines);
    writing::write_precision(lesson.precision, lines);
    writing::write_joints(written, lines);
    writing::write_drivers(written, lines);
    writing::write_dynamics(written, lines);
    writing::write_motion(lesson, lines);
    writing::write_camera(lesson, lines);
    writing::write_steps(lesson, lines);
    writing::write_questions(written, lines);
    writing::write_claims(written, lines);
    return lines.take();
}

}  // namespace jw
