#include <algorithm>

#include "lessons/read/reading.hpp"

namespace jw::reading {

namespace {

constexpr std::size_t kLongestName = 80;

/// Fault of a name; empty if there is none.
std::string fault_of(const std::string& name) {
    if (name.find_first_not_of(' ') == std::string::npos) {
        return name.empty() ? "is empty" : "has nothing but blanks";
    }
    if (name.front() == ' ' || name.back() == ' ') { return "begins or ends with a blank"; }
    if (name.size() > kLongestName) { return "is too long"; }
    return name.find_first_of(".\"'\n\r\t") != std::string::npos ? "has a dot, a quote or a line break" : "";
}

}  // namespace

const char* word_for(Named::Kind kind) {
    switch (kind) {
        case Named::Kind::body: return "body";
        case Named::Kind::joint: return "joint";
        case Named::Kind::driver: return "driver";
    }
    return "";
}

std::string Reading::declare(Fields& fields, Named::Kind kind, int index) {
    const std::string word = word_for(kind);
    const auto name = fields.text("name");
    fields.require("name", "a name by which the lesson refers to it");
    if (!name) { return {}; }
    if (const std::string fault = fault_of(name->value); !fault.empty()) {
        problems->add(
            Code::faulty_name, name->span,
            "the name " + in_quotes(name->value) + ' ' + fault +
                "; expected 1 to 80 characters without dots and quotes");
        return {};
    }
    fields.call(word + ' ' + in_quotes(name->value));
    if (kind != Named::Kind::body && (name->value == "bodies" || name->value == "motion")) {
        problems->add(
            Code::taken_name, name->span,
            in_quotes(name->value) + " is the name of a step; expected another name for the " + word);
    }
    const auto [there, is_new] = names.try_emplace(name->value, Named{kind, index, name->span, true});
    if (!is_new) {
        problems->add(
            Code::taken_name, name->span,
            "the name " + in_quotes(name->value) + " is taken by the " + word_for(there->second.kind) +
                " in line " + std::to_string(there->second.span.line) + "; expected a name of its own");
    }
    return name->value;
}

void Reading::distrust(const std::string& name) {
    const auto found = names.find(name);
    if (found != names.end()) { found->second.sound = false; }
}

const Named* Reading::find(const Located<std::string>& name, const Kinds& kinds) const {
    const auto is_wanted = [&](const Named& n) { return std::ranges::find(kinds, n.kind) != kinds.end(); };
    const auto found = names.find(name.value);
    if (found != names.end() && is_wanted(found->second)) { return &found->second; }

    std::string wanted;
    for (const Named::Kind kind : kinds) {
        wanted += (wanted.empty() ? "" : " or ") + std::string(word_for(kind));
    }
    // in the order of the file, as the author knows them
    std::vector<std::pair<int, std::string>> by_line;
    for (const auto& [other, named] : names) {
        if (is_wanted(named)) { by_line.emplace_back(named.span.line, other); }
    }
    std::ranges::sort(by_line);
    std::vector<std::string> candidates;
    for (auto& [line, other] : by_line) { candidates.push_back(std::move(other)); }
    const std::string expected =
        candidates.empty() ? "; there is none in this lesson" : "; expected one of " + comma_list(candidates);
    const std::string message = found == names.end() ? "unknown " + wanted + ' ' + in_quotes(name.value)
                                                     : in_quotes(name.value) + " is a " +
                                                           word_for(found->second.kind) + ", not a " + wanted;
    problems->add(Code::unknown_name, name.span, message + expected, did_you_mean(name.value, candidates));
    return nullptr;
}

const Named* Reading::body(const Located<std::string>& name) const { return find(name, {Named::Kind::body}); }

const Named* Reading::joint(const Located<std::string>& name) const {
    return find(name, {Named::Kind::joint});
}

const Named* Reading::addition(const Located<std::string>& name) const {
    return find(name, {Named::Kind::joint, Named::Kind::driver});
}

int Reading::place_of(const Named& addition) const {
    return static_cast<int>(std::ranges::find(lesson.order, addition.addition()) - lesson.order.begin());
}

bool Reading::moves(int body, const SourceSpan& span) const {
    if (!body_at(body).fixed) { return true; }
    report(
        Code::fixed_body, span,
        "body " + in_quotes(body_at(body).name) + " is fixed; expected one that moves");
    return false;
}

}  // namespace jw::reading
