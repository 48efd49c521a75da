#include "lessons/write/writer.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <map>
#include <system_error>
#include <utility>

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
    key(name, list_text(own, string_text));
    for (auto& [tag, list] : lists) {
        for (const Text& text : texts) {
            const auto found = text.translations().find(tag);
            list.push_back(found != text.translations().end() ? found->second : text.own());
        }
        key(tag + '.' + name, list_text(list, string_text));
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

const std::string& Written::body(int index) const { return lesson->mechanism.bodies[jw::at(index)].name; }

std::string Written::pair(int body_i, int body_j) const {
    return '[' + string_text(body(body_i)) + ", " + string_text(body(body_j)) + ']';
}

}  // namespace writing

namespace {

namespace fs = std::filesystem;

// number of drafts that killed programs may have left behind; more are not an accident
constexpr int kMostDrafts = 100;

/// Opens a new file beside `target`. @param name  becomes its path
std::FILE* open_draft(const fs::path& target, std::string& name) {
    std::FILE* file = nullptr;
    errno = EEXIST;
    for (int k = 1; file == nullptr && errno == EEXIST && k <= kMostDrafts; ++k) {
        name = target.string() + ".part-" + std::to_string(k);
        // "x": always a new file, and never through a link that somebody left there
        file = std::fopen(name.c_str(), "wbx");
    }
    return file;
}

/// Writes the text to a file under another name, which is then renamed. @return why not, if it fails
std::string problem_of_writing(const std::string& text, const fs::path& target) {
    std::string draft;
    std::FILE* const file = open_draft(target, draft);
    if (file == nullptr) { return std::generic_category().message(errno); }
    bool good = std::fwrite(text.data(), 1, text.size(), file) == text.size();
    int error = errno;
    const auto check = [&](int failed) {
        if (failed != 0 && std::exchange(good, false)) { error = errno; }
    };
    // a full disk may be reported only here
    check(std::fclose(file));
    std::error_code ignored;
    // the permissions of the lesson stay unchanged
    const fs::file_status before = fs::status(target, ignored);
    if (fs::exists(before)) { fs::permissions(draft, before.permissions(), ignored); }
    if (good) { check(std::rename(draft.c_str(), target.c_str())); }
    if (good) { return {}; }
    std::remove(draft.c_str());
    return std::generic_category().message(error);
}

}  // namespace

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

bool write_lesson_file(const fs::path& path, const std::string& text, std::string& error) {
    const auto fail = [&](const std::string& why, const std::string& expected) {
        error = "cannot write '" + path.string() + "': " + why + "; expected " + expected;
        return false;
    };
    std::error_code ignored;
    if (path.filename().empty() || fs::is_directory(path, ignored)) {
        return fail("this is a folder", "the name of a lesson file (.toml)");
    }
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, ignored)) {
        return fail("there is no folder '" + folder.string() + "'", "a folder that is there");
    }
    // through links, so that a lesson kept elsewhere stays there
    const fs::path target = fs::is_symlink(path, ignored) ? fs::weakly_canonical(path, ignored) : path;
    const std::string why = problem_of_writing(text, target);
    return why.empty() || fail(why, "a folder with room in which files may be written");
}

}  // namespace jw
