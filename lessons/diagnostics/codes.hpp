#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Codes of diagnostics: one for each cause that an author can do something about.
namespace jw {

/// Causes, with the numbers of their codes. `jointwise explain` has a page about each, with its title
/// (lessons/explanations).
enum class Code {
    // the file
    file_unreadable = 101,
    file_empty,
    character,
    no_toml,
    other_format,
    format_not_first,
    // keys and types
    unknown_key = 201,
    missing_key,
    wrong_type,
    wrong_count,
    out_of_range,
    exclusive_keys,
    lonely_key,
    unknown_word,
    too_much,
    language_tag,
    no_translation,
    // names
    unknown_name = 301,
    faulty_name,
    taken_name,
    named_twice,
    driver_before_joint,
    unknown_equation,
    unknown_quantity,
    old_name,
    // geometry
    zero_direction = 401,
    not_perpendicular,
    left_handed,
    not_unit,
    points_coincide,
    same_body,
    fixed_body,
    nothing_moves,
    moving_ground,
    camera_along_up,
    loose_body,
    typed_digits,
    start_value,
    // drivers and time
    no_such_freedom = 501,
    cannot_be_driven,
    beyond_all_values,
    ends_before_start,
    no_motion,
    rate_at_rest,
    table_times,
    // dynamics
    needs_dynamics = 601,
    no_mass,
    impossible_inertia,
    driven_origin,
    idle_mass,
    unfit_treatment,
    // claims, questions and formulas
    unreadable_formula = 701,
    formula_without_value,
    only_formulas,
    not_added_yet,
    // the course
    course_name = 801,
    course_twice,
    course_needs,
    course_no_lesson,
    // exercises
    exercise_kind = 851,
    exercise_answer,
    exercise_scene,
    exercise_edit,
    exercise_variant,
};

/// Codes from `first` to `last` and what they are about.
struct CodeGroup {
    Code first;
    Code last;
    std::string_view topic;
};
inline constexpr std::array kCodeGroups{
    CodeGroup{Code::file_unreadable, Code::format_not_first, "The file"},
    CodeGroup{Code::unknown_key, Code::no_translation, "Keys and types"},
    CodeGroup{Code::unknown_name, Code::old_name, "Names"},
    CodeGroup{Code::zero_direction, Code::start_value, "Geometry"},
    CodeGroup{Code::no_such_freedom, Code::table_times, "Drivers and time"},
    CodeGroup{Code::needs_dynamics, Code::unfit_treatment, "Dynamics"},
    CodeGroup{Code::unreadable_formula, Code::not_added_yet, "Claims, questions and formulas"},
    CodeGroup{Code::course_name, Code::course_no_lesson, "The course"},
    CodeGroup{Code::exercise_kind, Code::exercise_variant, "Exercises"}};

/// All codes, in the order of their numbers.
std::vector<Code> all_codes();
/// "JW203": at the end of messages and on the command line.
std::string to_string(Code code);
/// "JW203", "jw203" or "203"; empty if there is no such code.
std::optional<Code> read_code(std::string_view text);
/// Topic of a code: "The file", "Keys and types".
inline std::string_view group_of(Code code) {
    return std::ranges::find_if(kCodeGroups, [&](const CodeGroup& group) { return code <= group.last; })
        ->topic;
}

}  // namespace jw
