#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

/// Codes of diagnostics: one for each cause that an author can do something about.
namespace jw {

/// Causes, in the order of their codes. `jointwise explain` has a page about each.
enum class Code {
    // the file
    file_unreadable,
    file_empty,
    character,
    no_toml,
    other_format,
    format_not_first,
    // keys and types
    unknown_key,
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
    unknown_name,
    faulty_name,
    taken_name,
    named_twice,
    driver_before_joint,
    unknown_equation,
    unknown_quantity,
    old_name,
    // geometry
    zero_direction,
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
    // drivers and time
    no_such_freedom,
    cannot_be_driven,
    beyond_all_values,
    ends_before_start,
    no_motion,
    rate_at_rest,
    table_times,
    // dynamics
    needs_dynamics,
    no_mass,
    impossible_inertia,
    driven_origin,
    idle_mass,
    unfit_treatment,
    // claims, questions and formulas
    unreadable_formula,
    formula_without_value,
    only_formulas,
    not_added_yet,
    // the course
    course_name,
    course_twice,
    course_needs,
    course_no_lesson,
    // exercises
    exercise_kind,
    exercise_answer,
    exercise_scene,
    exercise_edit,
    exercise_variant,
};

/// A code with its printed name and its title, the same everywhere.
struct CodeEntry {
    Code code;
    std::string_view printed;  ///< at the end of messages and on the command line
    std::string_view title;
};

/// All codes, by the enumerators, in the order of the printed numbers.
inline constexpr std::array kCodes{
    CodeEntry{Code::file_unreadable, "JW101", "The file cannot be read"},
    CodeEntry{Code::file_empty, "JW102", "The file is empty"},
    CodeEntry{Code::character, "JW103", "A character that is not allowed"},
    CodeEntry{Code::no_toml, "JW104", "The file is not TOML"},
    CodeEntry{Code::other_format, "JW105", "The file has the format of another version"},
    CodeEntry{Code::format_not_first, "JW106", "The format is not the first key"},

    CodeEntry{Code::unknown_key, "JW201", "A key is not known"},
    CodeEntry{Code::missing_key, "JW202", "A key is missing"},
    CodeEntry{Code::wrong_type, "JW203", "A value has the wrong type"},
    CodeEntry{Code::wrong_count, "JW204", "A list has the wrong number of entries"},
    CodeEntry{Code::out_of_range, "JW205", "A number is out of range"},
    CodeEntry{Code::exclusive_keys, "JW206", "Two keys say the same thing"},
    CodeEntry{Code::lonely_key, "JW207", "A key needs another one beside it"},
    CodeEntry{Code::unknown_word, "JW208", "A word is not one of those allowed"},
    CodeEntry{Code::too_much, "JW209", "More than the program takes"},
    CodeEntry{Code::language_tag, "JW210", "A language tag is malformed"},
    CodeEntry{Code::no_translation, "JW211", "Some texts are not translated"},

    CodeEntry{Code::unknown_name, "JW301", "A name stands for nothing of that kind"},
    CodeEntry{Code::faulty_name, "JW302", "A name cannot be used"},
    CodeEntry{Code::taken_name, "JW303", "A name is taken"},
    CodeEntry{Code::named_twice, "JW304", "Something is named twice"},
    CodeEntry{Code::driver_before_joint, "JW305", "A driver comes before its joint"},
    CodeEntry{Code::unknown_equation, "JW306", "A joint has no such equation"},
    CodeEntry{Code::unknown_quantity, "JW307", "The name of a quantity is not known"},
    CodeEntry{Code::old_name, "JW308", "A quantity has a new name"},

    CodeEntry{Code::zero_direction, "JW401", "A direction has no length"},
    CodeEntry{Code::not_perpendicular, "JW402", "Vectors are not perpendicular"},
    CodeEntry{Code::left_handed, "JW403", "The axes of a frame are left-handed"},
    CodeEntry{Code::not_unit, "JW404", "Euler parameters are not of length 1"},
    CodeEntry{Code::points_coincide, "JW405", "Two points coincide"},
    CodeEntry{Code::same_body, "JW406", "Both bodies are the same one"},
    CodeEntry{Code::fixed_body, "JW407", "A body that must move is fixed"},
    CodeEntry{Code::nothing_moves, "JW408", "No body moves"},
    CodeEntry{Code::moving_ground, "JW409", "The ground does not move"},
    CodeEntry{Code::camera_along_up, "JW410", "The camera looks along 'up'"},
    CodeEntry{Code::loose_body, "JW411", "Nothing constrains a body"},
    CodeEntry{Code::typed_digits, "JW412", "The last digits of numbers decide the rank"},

    CodeEntry{Code::no_such_freedom, "JW501", "A joint has no such freedom"},
    CodeEntry{Code::cannot_be_driven, "JW502", "No driver can prescribe this"},
    CodeEntry{Code::beyond_all_values, "JW503", "A function of time reaches an impossible value"},
    CodeEntry{Code::ends_before_start, "JW504", "The end comes before the start"},
    CodeEntry{Code::no_motion, "JW505", "There is no motion at that time"},
    CodeEntry{Code::rate_at_rest, "JW506", "A rate is claimed where nothing moves"},
    CodeEntry{Code::table_times, "JW507", "The times of a table do not fit"},

    CodeEntry{Code::needs_dynamics, "JW601", "Masses and forces need [dynamics]"},
    CodeEntry{Code::no_mass, "JW602", "A body has no mass"},
    CodeEntry{Code::impossible_inertia, "JW603", "No body has such an inertia"},
    CodeEntry{Code::driven_origin, "JW604", "The driven origin is not the centre of mass"},
    CodeEntry{Code::idle_mass, "JW605", "A mass has no effect"},
    CodeEntry{Code::unfit_treatment, "JW606", "A treatment does not fit the method"},

    CodeEntry{Code::unreadable_formula, "JW701", "A formula cannot be read"},
    CodeEntry{Code::formula_without_value, "JW702", "A formula has no value"},
    CodeEntry{Code::only_formulas, "JW703", "Only a formula can hold in any state"},
    CodeEntry{Code::not_added_yet, "JW704", "A joint has not been added by then"},

    CodeEntry{Code::course_name, "JW801", "A course names no folder or file"},
    CodeEntry{Code::course_twice, "JW802", "A course has something twice"},
    CodeEntry{Code::course_needs, "JW803", "A chapter needs one that does not come before"},
    CodeEntry{Code::course_no_lesson, "JW804", "The file is a course, not a lesson"},

    CodeEntry{Code::exercise_kind, "JW851", "The kind of an exercise is not clear"},
    CodeEntry{Code::exercise_answer, "JW852", "The answer of an exercise does not fit"},
    CodeEntry{Code::exercise_scene, "JW853", "The scene of an exercise does not fit"},
    CodeEntry{Code::exercise_edit, "JW854", "An edit of an exercise cannot be made"},
    CodeEntry{Code::exercise_variant, "JW855", "The variants of an exercise do not fit"},
};

constexpr const CodeEntry& entry_of(Code code) { return kCodes[static_cast<std::size_t>(code)]; }

/// "JW203", "jw203" or "203"; empty if there is no such code.
std::optional<Code> read_code(std::string_view text);

}  // namespace jw
