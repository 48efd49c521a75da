#include <algorithm>
#include <array>

#include "app/session/try/experiment_text.hpp"
#include "app/session/wording/numbers.hpp"
#include "core/quantity/quantity.hpp"
#include "lessons/formula/steps_of_formula.hpp"
#include "lessons/lesson/enum_words.hpp"
#include "lessons/typed/exact_text.hpp"
#include "lessons/typed/typed.hpp"

namespace jw::experiment_text {

namespace {

constexpr const char* kAngleRow = "angle_row";
constexpr const char* kFormula = "formula";

std::vector<std::string> keys() {
    std::vector<std::string> all;
    for (const auto& key : kVectors) { all.emplace_back(key.name); }
    for (const auto& key : kNumbers) { all.emplace_back(key.name); }
    for (const auto& key : kOptional) { all.emplace_back(key.name); }
    all.emplace_back(kAngleRow);
    all.emplace_back(kFormula);
    return all;
}

const Joint& joint_of(const Lesson& lesson, int index) { return lesson.mechanism.joints.at(at(index)); }

SetGeometry joint_named(Words& words, const Lesson& lesson) {
    const auto index = static_cast<int>(words.name(names_of_joints(lesson), "joint"));
    return {index, joint_of(lesson, index).geometry};
}

bool side_of(Words& words) {
    static const std::vector<std::string> sides{"i", "j"};
    return words.name(sides, "side") == 1;
}

ScalarFormula read_formula(Words& words, const JointType& type) {
    if (!type.has_formula()) { throw Unreadable("a " + std::string(type.name) + " joint has no formula"); }
    try {
        return formula::constraint_formula(words.text("the formula"));
    } catch (const formula::NotEvaluated& failed) {
        throw Unreadable(failed.problem().message, failed.problem().hint);
    }
}

void read_member(Words& words, const JointType& type, JointGeometry& g) {
    const std::vector<std::string> all = keys();
    const std::string key = all[words.name(all, "part of a joint")];
    for (const auto& k : kVectors) {
        if (key == k.name) { g.*k.member = words.vector(key); }
    }
    for (const auto& k : kNumbers) {
        if (key != k.name) { continue; }
        g.*k.member = words.number(key);
        if (k.member == &JointGeometry::ratio) { g.radii = {}; }
    }
    for (const auto& k : kOptional) {
        if (key != k.name) { continue; }
        g.*k.member = words.take("none") ? std::nullopt : std::optional<double>(words.number(key));
    }
    if (key == kAngleRow) {
        g.screw_angle_form = kAngleRows[words.name(words_of(kAngleRows), "angle row")].value;
    }
    if (key == kFormula) { g.formula = read_formula(words, type); }
}

/// The members in which `g` differs from `before`, as words.
std::string differences(const JointGeometry& before, const JointGeometry& g) {
    std::string text;
    const auto add = [&](const char* key, const std::string& value) {
        text += " " + std::string(key) + " " + value;
    };
    for (const auto& k : kVectors) {
        if (before.*k.member != g.*k.member) { add(k.name, numbers_text(g.*k.member)); }
    }
    for (const auto& k : kNumbers) {
        if (before.*k.member != g.*k.member) { add(k.name, writing::number_text(g.*k.member)); }
    }
    for (const auto& k : kOptional) {
        const std::optional<double>& value = g.*k.member;
        if (before.*k.member != value) { add(k.name, value ? writing::number_text(*value) : "none"); }
    }
    if (before.screw_angle_form != g.screw_angle_form) {
        add(kAngleRow, word_of(kAngleRows, g.screw_angle_form));
    }
    if (before.formula != g.formula) { add(kFormula, "\"" + g.formula.source + "\""); }
    return text;
}

const Driver& driver_of(const Lesson& lesson, int index) { return lesson.mechanism.drivers.at(at(index)); }

/// True if degrees follow. Takes the unit, which angles must have and lengths may have.
/// @param per  "" or "/s"
bool degrees_follow(Words& words, Unit unit, const std::string& per) {
    if (unit != Unit::radian) {
        words.take(unit == Unit::metre ? "m" + per : "1" + per);
        return false;
    }
    if (words.take("deg" + per) || words.take("°" + per)) { return true; }
    if (words.take("rad" + per)) { return false; }
    throw Unreadable("the unit is missing; expected deg" + per + " or rad" + per);
}

double value(Words& words, Unit unit, const std::string& per, const std::string& what) {
    const double number = words.number(what);
    return degrees_follow(words, unit, per) ? radians(number) : number;
}

bool is_number(std::string_view word) { return word.find_first_of("+-.0123456789") == 0; }

/// Numbers up to the next word that is not a number, all in one unit.
std::vector<double> values(Words& words, Unit unit, const std::string& what) {
    std::vector<double> all;
    do { all.push_back(words.number(what)); } while (is_number(words.peek()));
    if (degrees_follow(words, unit, "")) { std::ranges::transform(all, all.begin(), radians); }
    return all;
}

TimeFunction::Harmonic read_harmonic(Words& words, Unit unit) {
    TimeFunction::Harmonic h;
    h.amplitude = value(words, unit, "", "the amplitude");
    if (words.take("omega")) { h.omega = value(words, Unit::radian, "/s", "omega"); }
    if (words.take("phase")) { h.phase = value(words, Unit::radian, "", "the phase"); }
    return h;
}

TimeFunction::SmoothStep read_step(Words& words, Unit unit) {
    TimeFunction::SmoothStep step;
    if (words.take("from")) { step.from = value(words, unit, "", "the value before"); }
    if (words.take("to")) { step.to = value(words, unit, "", "the value after"); }
    if (words.take("between")) {
        step.start = words.number("a time [s]");
        step.end = words.number("a time [s]");
        words.take("s");
    }
    if (step.end <= step.start) { throw Unreadable("the step ends before it begins"); }
    return step;
}

/// "smooth at 0 0.5 1 s values 0 30 60 deg"
TimeTable read_table(Words& words, Unit unit) {
    static const std::vector<std::string> ways = words_of(kInterpolations);
    const TimeTable::Interpolation interpolation =
        kInterpolations[words.name(ways, "interpolation of a table")].value;
    if (!words.take("at")) { throw Unreadable("expected 'at' and the times of the table"); }
    std::vector<double> times;
    do { times.push_back(words.number("a time [s]")); } while (is_number(words.peek()));
    words.take("s");
    if (!words.take("values")) { throw Unreadable("expected 'values' after the times of the table"); }
    std::vector<double> of_times = values(words, unit, "a value");
    try {
        return table_through(std::move(times), std::move(of_times), interpolation);
    } catch (const std::invalid_argument& e) { throw Unreadable(e.what()); }
}

/// A formula in quotes, followed by its unit: "30 \sin(2 t)" deg.
TimeFormula read_formula(Words& words, Unit unit) {
    TimeFormula out;
    try {
        out.formula = formula::scalar_formula(words.text("the formula"), formula::time_only());
    } catch (const formula::NotEvaluated& failed) {
        throw Unreadable(failed.problem().message, failed.problem().hint);
    }
    if (degrees_follow(words, unit, "")) { out.unit = radians(1.0); }
    return out;
}

double& coefficient(TimeFunction& function, std::size_t power) {
    if (function.polynomial.size() <= power) {
        function.polynomial.resize(std::max<std::size_t>(2, power + 1));
    }
    return function.polynomial[power];
}

void read_clause(Words& words, Unit unit, TimeFunction& function) {
    static const std::vector<std::string> clauses{"start",    "rate", "function", "polynomial",
                                                  "harmonic", "step", "table",    "formula"};
    switch (words.name(clauses, "part of a driver's function")) {
        case 0: coefficient(function, 0) = value(words, unit, "", "the start"); break;
        case 1: coefficient(function, 1) = value(words, unit, "/s", "the rate"); break;
        case 2: function = {}; break;
        case 3: function.polynomial = values(words, unit, "a coefficient"); break;
        case 4: function.harmonics.push_back(read_harmonic(words, unit)); break;
        case 5: function.steps.push_back(read_step(words, unit)); break;
        case 6: function.table = read_table(words, unit); break;
        default: function.formula = read_formula(words, unit); break;
    }
}

/// "30 90 deg"
std::string values_text(const std::vector<double>& numbers, Unit unit, const std::string& per = {}) {
    std::vector<double> shown = numbers;
    std::string behind = unit == Unit::metre ? " m" + per : "";
    if (unit == Unit::radian) {
        const writing::AngleTexts typed = writing::typed_angles(numbers);
        behind = " " + typed.unit + per;
        shown = typed.values;
    }
    return joined(shown, " ", writing::number_text) + behind;
}

std::string whole_text(const TimeFunction& f, Unit unit) {
    std::string text = " function";
    if (!f.polynomial.empty()) { text += " polynomial " + values_text(f.polynomial, unit); }
    for (const TimeFunction::Harmonic& h : f.harmonics) {
        text += " harmonic " + values_text({h.amplitude}, unit) + " omega " +
                values_text({h.omega}, Unit::radian, "/s") + " phase " + values_text({h.phase}, Unit::radian);
    }
    for (const TimeFunction::SmoothStep& s : f.steps) {
        text += " step from " + values_text({s.from}, unit) + " to " + values_text({s.to}, unit) +
                " between " + writing::number_text(s.start) + " " + writing::number_text(s.end) + " s";
    }
    if (f.table) {
        text += std::string(" table ") + word_of(kInterpolations, f.table->interpolation) + " at";
        for (const double t : f.table->times) { text += " " + writing::number_text(t); }
        text += " s values " + values_text(f.table->values, unit);
    }
    if (f.formula) {
        text += " formula \"" + f.formula->formula.source + "\"";
        if (unit == Unit::radian) { text += f.formula->unit == 1.0 ? " rad" : " deg"; }
        if (unit == Unit::metre) { text += " m"; }
    }
    return text;
}

}  // namespace

std::string numbers_text(const Vec3& v) { return joined(v, " ", writing::number_text); }

SetGeometry read_axis(Words& words, const Lesson& lesson) {
    SetGeometry experiment = joint_named(words, lesson);
    const bool in_body_j = side_of(words);
    const Vec3 direction = words.vector("a direction");
    if (direction.norm() < 1e-9) { throw Unreadable("the axis has length 0; expected a direction"); }
    experiment.geometry = with_axis(experiment.geometry, in_body_j, direction);
    return experiment;
}

SetGeometry read_point(Words& words, const Lesson& lesson) {
    SetGeometry experiment = joint_named(words, lesson);
    Vec3 JointGeometry::*const point = side_of(words) ? &JointGeometry::P_j_local : &JointGeometry::P_i_local;
    experiment.geometry.*point = words.vector("a coordinate [m]");
    return experiment;
}

SetGeometry read_length(Words& words, const Lesson& lesson) {
    SetGeometry experiment = joint_named(words, lesson);
    const Joint& joint = joint_of(lesson, experiment.joint);
    if (!joint.type->uses(Role::length)) {
        throw Unreadable("a " + std::string(joint.type->name) + " joint has no length");
    }
    experiment.geometry.length = words.number("a length [m]");
    words.take("m");
    if (experiment.geometry.length <= 0.0) { throw Unreadable("a length must be above 0"); }
    return experiment;
}

SetGeometry read_geometry(Words& words, const Lesson& lesson) {
    SetGeometry experiment = joint_named(words, lesson);
    const JointType& type = *joint_of(lesson, experiment.joint).type;
    while (!words.done()) { read_member(words, type, experiment.geometry); }
    return experiment;
}

std::string text_of(const SetGeometry& experiment, const Lesson& lesson) {
    const Joint& joint = joint_of(lesson, experiment.joint);
    const std::string name = quoted_name(joint.name, names_of_joints(lesson));
    const JointGeometry& g = experiment.geometry;
    for (const bool in_body_j : {false, true}) {
        const std::string side = in_body_j ? " j " : " i ";
        const Vec3& s = in_body_j ? g.s_j_local : g.s_i_local;
        if (s != (in_body_j ? joint.geometry.s_j_local : joint.geometry.s_i_local) && s.norm() > 0.0 &&
            with_axis(joint.geometry, in_body_j, s) == g) {
            return "axis " + name + side + numbers_text(s);
        }
        JointGeometry moved = joint.geometry;
        (in_body_j ? moved.P_j_local : moved.P_i_local) = in_body_j ? g.P_j_local : g.P_i_local;
        if (moved == g && moved != joint.geometry) {
            return "point " + name + side + numbers_text(in_body_j ? g.P_j_local : g.P_i_local);
        }
    }
    return "geometry " + name + differences(joint.geometry, g);
}

SetDriver read_driver(Words& words, const Lesson& lesson) {
    const auto index = static_cast<int>(words.name(names_of_drivers(lesson), "driver"));
    const Driver& driver = driver_of(lesson, index);
    SetDriver experiment{index, driver.function};
    do { read_clause(words, unit_of(driver.measure), experiment.function); } while (!words.done());
    return experiment;
}

std::string text_of(const SetDriver& experiment, const Lesson& lesson) {
    const Driver& driver = driver_of(lesson, experiment.driver);
    const Unit unit = unit_of(driver.measure);
    const std::string head = "driver " + quoted_name(driver.name, names_of_drivers(lesson));
    TimeFunction wanted = experiment.function;
    TimeFunction shifted = driver.function;
    if (wanted.polynomial.size() >= 2) {
        const double start = wanted.polynomial[0];
        const double rate = wanted.polynomial[1];
        coefficient(shifted, 0) = start;
        coefficient(shifted, 1) = rate;
        if (shifted == wanted) {
            return head + " start " + values_text({start}, unit) + " rate " + values_text({rate}, unit, "/s");
        }
    }
    return head + whole_text(wanted, unit);
}

}  // namespace jw::experiment_text
