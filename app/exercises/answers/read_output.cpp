#include "app/exercises/answers/read_output.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string_view>

#include <nlohmann/json.hpp>

#include "app/session/wording/messages.hpp"

namespace jw {

namespace {

using ReadJson = nlohmann::json;

constexpr std::size_t kMostRows = 1000;
constexpr const char* kExpected = R"({"answers": [...]})";
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

bool is_word_sign(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '+' ||
           c == '-' || c == '.';
}

/// True for "NaN", "-inf", "Infinity", "1e999".
bool is_not_finite(std::string word) {
    const bool is_number = word.find_first_of("0123456789") != std::string::npos;
    if (is_number) { return std::isinf(std::strtod(word.c_str(), nullptr)); }
    if (word.starts_with('-') || word.starts_with('+')) { word.erase(0, 1); }
    for (char& c : word) { c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
    constexpr std::array<std::string_view, 3> kWords{"nan", "inf", "infinity"};
    return std::ranges::find(kWords, word) != kWords.end();
}

std::size_t end_of_string(std::string_view text, std::size_t at) {
    for (++at; at < text.size() && text[at] != '"'; ++at) { at += text[at] == '\\' ? 1 : 0; }
    return std::min(at + 1, text.size());
}

/// Replaces NaN and infinity by null, since JSON has no words for them.
std::string with_nulls(const std::string& text) {
    std::string json;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at;
        while (end < text.size() && is_word_sign(text[end])) { ++end; }
        if (end > at) {
            const std::string word = text.substr(at, end - at);
            json += is_not_finite(word) ? "null" : word;
        } else {
            end = text[at] == '"' ? end_of_string(text, at) : at + 1;
            json += text.substr(at, end - at);
        }
        at = end;
    }
    return json;
}

bool is_entry(const ReadJson& json) { return json.is_number() || json.is_null(); }
double entry_of(const ReadJson& json) { return json.is_null() ? kNoNumber : json.get<double>(); }

MatrixX answer_in(const ReadJson& json) {
    if (is_entry(json)) { return MatrixX::Constant(1, 1, entry_of(json)); }
    if (!json.is_array() || json.empty() || json.size() > kMostRows) { return {}; }
    const bool nested = json.front().is_array();
    const std::size_t columns = nested ? json.front().size() : 1;
    if (columns == 0 || columns > kMostRows) { return {}; }
    MatrixX m(static_cast<Eigen::Index>(json.size()), static_cast<Eigen::Index>(columns));
    for (std::size_t r = 0; r < json.size(); ++r) {
        const ReadJson& row = json[r];
        if (nested && (!row.is_array() || row.size() != columns)) { return {}; }
        for (std::size_t c = 0; c < columns; ++c) {
            const ReadJson& entry = nested ? row[c] : row;
            if (!is_entry(entry)) { return {}; }
            m(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) = entry_of(entry);
        }
    }
    return m;
}

}  // namespace

ProgramOutput read_program_output(const std::string& text) {
    const ReadJson json = ReadJson::parse(with_nulls(text), nullptr, false);
    if (json.is_discarded()) { return {{}, tr("The output is not JSON; expected {0}.", kExpected)}; }
    if (!json.is_object() || !json.contains("answers") || !json["answers"].is_array()) {
        return {{}, tr("The output has no list \"answers\"; expected {0}.", kExpected)};
    }
    ProgramOutput output;
    for (const ReadJson& answer : json["answers"]) { output.answers.push_back(answer_in(answer)); }
    return output;
}

}  // namespace jw
