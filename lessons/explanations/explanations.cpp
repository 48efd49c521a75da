#include "lessons/explanations/explanations.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>

#include "lessons/explanations/explanation_texts.hpp"
#include "lessons/files/course.hpp"
#include "lessons/lesson/enum_words.hpp"
#include "lessons/lesson/translations.hpp"
#include "lessons/read/reader.hpp"

namespace jw {

namespace {

using Setting = Explanation::Setting;

constexpr std::array kSettings{
    EnumWord<Setting>{Setting::whole, "whole"},   EnumWord<Setting>{Setting::head, "head"},
    EnumWord<Setting>{Setting::behind, "behind"}, EnumWord<Setting>{Setting::masses, "masses"},
    EnumWord<Setting>{Setting::course, "course"}, EnumWord<Setting>{Setting::path, "path"}};

/// Prefixes of the codes of each topic; the course and the exercises share the eight hundreds.
constexpr std::array<std::pair<std::string_view, std::string_view>, 9> kGroups{
    {{"JW1", "The file"},
     {"JW2", "Keys and types"},
     {"JW3", "Names"},
     {"JW4", "Geometry"},
     {"JW5", "Drivers and time"},
     {"JW6", "Dynamics"},
     {"JW7", "Claims, questions and formulas"},
     {"JW80", "The course"},
     {"JW85", "Exercises"}}};

struct Texts {
    std::vector<Explanation> pages;
    std::map<std::string, std::string> parts;  ///< of the lesson that examples continue
};

/// Splits a text into named parts: "=== NAME" begins a page or a part of its own, "--- NAME" a part of a
/// page.
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
        const auto code = read_code(name);
        into_ = code ? nullptr : &texts_.parts[name];
        if (!code) { return; }
        texts_.pages.emplace_back();
        texts_.pages.back().code = *code;
    }

    std::string* part_of_page(const std::string& name) {
        Explanation& page = texts_.pages.at(texts_.pages.size() - 1);
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

const Explanation* explanation_of(Code code) {
    const std::vector<Explanation>& pages = explanations();
    const auto found = std::ranges::find(pages, code, &Explanation::code);
    return found != pages.end() ? &*found : nullptr;
}

std::string text_of_example(Setting setting, const std::string& example) {
    const std::map<std::string, std::string>& parts = texts().parts;
    const auto part = [&](const char* name) { return parts.at(name); };
    switch (setting) {
        case Setting::head: return example + part("bodies") + part("joints");
        case Setting::behind: return part("head") + part("bodies") + part("joints") + example;
        case Setting::masses: return part("head") + part("masses") + part("joints") + example;
        case Setting::whole:
        case Setting::course:
        case Setting::path: break;
    }
    return example;
}

std::vector<Diagnostic> read_example(Setting setting, const std::string& example, const std::string& folder) {
    const std::string text = text_of_example(setting, example);
    switch (setting) {
        case Setting::course: return read_course(text, std::string(kCourseFile)).diagnostics;
        case Setting::path: {
            const std::filesystem::path path(text.substr(0, text.find('\n')));
            return read_lesson_file(std::filesystem::path(folder) / path).diagnostics;
        }
        case Setting::whole:
        case Setting::head:
        case Setting::behind:
        case Setting::masses: break;
    }
    ReadResult read = read_lesson(text, "lesson.toml");
    // what `jointwise check` adds
    std::ranges::move(missing_translations("lesson.toml", read.texts), std::back_inserter(read.diagnostics));
    return std::move(read.diagnostics);
}

std::string_view group_of(Code code) {
    const std::string_view printed = entry_of(code).printed;
    const auto* const found =
        std::ranges::find_if(kGroups, [&](const auto& group) { return printed.starts_with(group.first); });
    return found != kGroups.end() ? found->second : std::string_view();
}

}  // namespace jw
