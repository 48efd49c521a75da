#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/session/output/json.hpp"
#include "lessons/lesson/enum_words.hpp"

/// Fields of a primitive (`for_each_field`) as JSON, for inspections and proofs.
namespace jw {

inline Json field(double value) { return number(value); }
inline Json field(bool value) { return value; }
inline Json field(const Vec3& value) { return json_of(value); }
inline Json field(ScrewAngleForm form) { return word_of(kAngleRows, form); }
inline Json field(WheelLine line) { return std::string(name_of(line)); }
inline Json field(const std::vector<std::array<double, 2>>& pairs) {
    Json all = Json::array();
    for (const auto& [of_cosine, of_sine] : pairs) { all.push_back({number(of_cosine), number(of_sine)}); }
    return all;
}

}  // namespace jw
