#include "lessons/explanations/explanations.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>

#include "lessons/diagnostics/read_text.hpp"
#include "lessons/explanations/explanation_texts.hpp"
#include "lessons/files/course.hpp"
#include "lessons/lesson/enum_words.hpp"
#include "lessons/read/reader.hpp"

namespace jw {

namespace {

using Setting = Explanation::Setting;

constexpr std::array kSettings{
    EnumWord<Setting>{Setting::whole, "whole"},   EnumWord<Setting>{Setting::head, "head"},
    EnumWord<Setting>{Setting::behind, "behind"}, EnumWord<Setting>{Setting::masses, "masses"},
    EnumWord<Setting>{Setting::course, "course"}, EnumWord<Setting>{Setting::path, "path"}};

struct Texts {
    std::vector<Explanation> pages;
    std::map<Code, std::string> titles;
    std::map<std::string, std::string> parts;  ///< of the lesson that examples continue
};

/// Splits a text into named parts: "=== CODE TITLE" begins a page, "=== NAME" a part of its own, "--- NAME" a
/// part of a page.
class TextReader {
public:
    void take(const std::string& line) {
        if (line.starts_with("=== ")) {
            begin(line.substr(4));
        } else if (line.starts_with("--- ")) {
            into_ = part_of_page(line.substr(4));
        } else if (into_ != nullptr && !(line.empty() && into_->empty())) {
            *into_ += line + '\n';
        }
    }

    Texts result() {
        for (Explanation& page : texts_.pages) {
            for (std::string* text : {&page.cause, &page.cure, &page.wrong, &page.right}) {
                while (text->ends_with("\n\n")) { text->pop_back(); }
            }
        }
        std::ranges::sort(texts_.pages, {}, &Explanation::code);
        return std::move(texts_);
    }

private:
    void begin(const std::string& name) {
        const std::size_t blank = name.find(' ');
        const auto code = read_code(name.substr(0, blank));
        into_ = code ? nullptr : &texts_.parts[name];
        if (!code) { return; }
        code_ = *code;
        texts_.titles[code_] = name.substr(blank + 1);
    }

    std::string* part_of_page(const std::string& name) {
        if (texts_.pages.empty() || texts_.pages.back().code != code_) {
            texts_.pages.emplace_back().code = code_;
        }
        Explanation& page = texts_.pages.back();
        if (name == "cause") { return &page.cause; }
        if (name == "cure") { return &page.cure; }
        if (name == "right") { return &page.right; }
        const std::size_t colon = name.find(": ");
        if (colon != std::string::npos) {
            const auto setting = value_of(kSettings, name.substr(colon + 2));
            if (!setting) { throw std::logic_error("no setting of an example: " + name); }
            page.setting = *setting;
        }
        if (name.substr(0, colon) != "wrong") { throw std::logic_error("no part of a page: " + name); }
        return &page.wrong;
    }

    Texts texts_;
    Code code_{};
    std::string* into_ = nullptr;
};

const Texts& texts() {
    static const Texts kTexts = [] {
        TextReader reader;
        std::istringstream lines(kExplanationTexts);
        for (std::string line; std::getline(lines, line);) { reader.take(line); }
        return reader.result();
    }();
    return kTexts;
}

}  // namespace

const std::vector<Explanation>& explanations() { return texts().pages; }

const std::string& title_of(Code code) { return texts().titles.at(code); }

const Explanation* explanation_of(Code code) {
    const std::vector<Explanation>& pages = explanations();
    const auto found = std::ranges::find(pages, code, &Explanation::code);
    return found != pages.end() ? &*found : nullptr;
}

std::string text_of_example(Setting setting, const std::string& example) {
    const std::map<std::string, std::string>& parts = texts().parts;
    const auto part = [&](const char* name) { return parts.at(name); };
    if (setting == Setting::head) { return example + part("bodies") + part("joints"); }
    if (setting != Setting::behind && setting != Setting::masses) { return example; }
    return part("head") + part(setting == Setting::masses ? "masses" : "bodies") + part("joints") + example;
}

std::vector<Diagnostic> read_example(Setting setting, const std::string& example, const std::string& folder) {
    const std::string text = text_of_example(setting, example);
    if (setting == Setting::course) { return read_course(text, std::string(kCourseFile)).diagnostics; }
    if (setting == Setting::path) {
        const std::filesystem::path path(text.substr(0, text.find('\n')));
        return read_lesson_file(std::filesystem::path(folder) / path).diagnostics;
    }
    ReadResult read = read_lesson(text, "lesson.toml");
    // what `jointwise check` adds
    std::ranges::move(missing_translations("lesson.toml", read.texts), std::back_inserter(read.diagnostics));
    return std::move(read.diagnostics);
}

}  // namespace jw
