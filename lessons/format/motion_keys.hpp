#pragma once

#include "core/integrate/methods.hpp"
#include "lessons/format/key.hpp"
#include "lessons/lesson/enum_words.hpp"
#include "lessons/lesson/lesson.hpp"
#include "lessons/typed/typed.hpp"

/// Keys of drivers, motions, dynamics and loads.
namespace jw::format {

/// Largest number of coefficients of a polynomial.
inline constexpr int kMostCoefficients = 50;
/// Largest number of intervals of a motion.
inline constexpr int kMostIntervals = 100000;

/// Largest number of times of a table.
inline constexpr int kMostTimes = 1000;

/// Keys of a function of time. @param harmonic, step, table  tables of its terms
constexpr std::array<Key, 5> function_of_time(
    std::string_view harmonic, std::string_view step, std::string_view table) {
    return {
        counted("polynomial", KeyKind::numbers, "coefficients c0, c1, c2, ... of t^k", 1, kMostCoefficients),
        in_table("harmonics", KeyKind::tables, "sines of time", harmonic),
        in_table("step", KeyKind::tables, "smooth steps from one value to another", step),
        in_table("table", KeyKind::table, "values at given times", table),
        Key{"formula", KeyKind::formula, "formula of the time t (docs/mathematics.md)"}};
}

inline std::vector<std::string> driven_quantities() {
    return {"angle", "displacement", "distance", "coordinate"};
}

inline constexpr std::array kDriver = joined(
    std::array{
        required({"name", KeyKind::text, "name by which the lesson refers to it"}),
        required(
            {.name = "quantity",
             .kind = KeyKind::text,
             .about = "what is prescribed, or its name, such as \"hinge.angle\"",
             .words = driven_quantities,
             .pattern = "\\."}),
        Key{"joint", KeyKind::text, "joint whose angle or displacement it is"},
        counted("bodies", KeyKind::texts, "two bodies whose points have the distance", 2, 2),
        Key{"at", KeyKind::vector, "point of the first body, global at the start pose", "m"},
        Key{"to", KeyKind::vector, "point of the second body, global at the start pose", "m"},
        Key{"point_i", KeyKind::vector, "point in the frame of the first body", "m"},
        Key{"point_j", KeyKind::vector, "point in the frame of the second body", "m"},
        Key{"body", KeyKind::text, "body whose coordinate it is"},
        one_of("coordinate", "coordinate of the body", words_in<kCoordinates>),
        Key{"from_start", KeyKind::flag, "adds the value at the start pose"},
        Key{"text", KeyKind::words, "the author's words in its step"}},
    function_of_time("harmonic_of_driver", "smooth_step_of_driver", "values_of_driver"),
    std::array{
        spelled(
            counted(
                "polynomial", KeyKind::numbers, "coefficients c0, c1, c2, ... of t^k of an angle", 1,
                kMostCoefficients),
            Spelling::angle),
        spelled(
            {"formula", KeyKind::formula, "formula of the time t of an angle; sines are of radians"},
            Spelling::angle)});

/// @param unit  of the values; empty where another key decides it
constexpr std::array<Key, 4> harmonic(std::string_view unit) {
    return {
        Key{"amplitude", KeyKind::number, "size of the swing", unit},
        Key{"frequency_hz", KeyKind::number, "oscillations per second"},
        Key{"omega_rad_per_s", KeyKind::number, "instead of the frequency: 2 pi times it"},
        spelled({"phase", KeyKind::number, "angle of the sine at t = 0"}, Spelling::angle)};
}
constexpr std::array<Key, 4> smooth_step(std::string_view unit) {
    return {
        Key{"from", KeyKind::number, "value before; default 0", unit},
        Key{"to", KeyKind::number, "value afterwards", unit},
        Key{"start_s", KeyKind::number, "time at which it starts; default 0"},
        required({"end_s", KeyKind::number, "time at which it ends"})};
}
constexpr std::array<Key, 3> values_at_times(std::string_view unit) {
    return {
        required(
            counted(
                "times_s", KeyKind::numbers, "increasing times, from the start to the end", 2, kMostTimes),
            "the times of the values, in s"),
        Key{"values", KeyKind::numbers, "one value for each time", unit},
        one_of("interpolation", "what lies between; default smooth", words_in<kInterpolations>)};
}
inline constexpr std::array kHarmonic = harmonic("");
inline constexpr std::array kSmoothStep = smooth_step("");
inline constexpr std::array kValues = values_at_times("");

/// Values of a driver are lengths or angles.
inline constexpr std::array kHarmonicOfDriver = joined(
    harmonic("m"),
    std::array{spelled({"amplitude", KeyKind::number, "size of the swing of an angle"}, Spelling::angle)});
inline constexpr std::array kSmoothStepOfDriver = joined(
    smooth_step("m"), std::array{
                          spelled({"from", KeyKind::number, "angle before; default 0"}, Spelling::angle),
                          spelled({"to", KeyKind::number, "angle afterwards"}, Spelling::angle)});
inline constexpr std::array kValuesOfDriver = joined(
    values_at_times("m"),
    std::array{spelled({"values", KeyKind::numbers, "one angle for each time"}, Spelling::angle)});

inline constexpr std::array kMotion{
    Key{"from_s", KeyKind::number, "time at which the mechanism is assembled; default 0"},
    required({"to_s", KeyKind::number, "time at which it ends"}, "the time at which the motion ends"),
    Key{"duration_s", KeyKind::positive, "how long it takes on the screen"},
    counted("steps", KeyKind::whole_number, "equal intervals that are solved", 1, kMostIntervals)};

inline constexpr std::array kGravity{
    MemberKey<Loads>{{"gravity", KeyKind::vector, "global; default none", "m/s²"}, &Loads::gravity}};
inline constexpr std::array kDuration{MemberKey<DynamicsPlan>{
    required({"duration", KeyKind::positive, "how long it moves", "s"}, "how long it moves, in s"),
    &DynamicsPlan::duration}};
inline constexpr std::array kAccuracy{
    MemberKey<SimulationSettings>{
        {"tolerance", KeyKind::positive, "of methods whose steps follow the error"},
        &SimulationSettings::tolerance},
    MemberKey<SimulationSettings>{
        {"step", KeyKind::positive, "of methods with equal steps", "s"}, &SimulationSettings::step}};
inline constexpr std::array kDynamics = joined(
    keys_in(kGravity), keys_in(kDuration),
    std::array{
        one_of("method", "method of integration", words_in<kMethods>),
        one_of("treatment", "how the constraints are kept", words_in<kTreatments>)},
    keys_in(kAccuracy),
    std::array{
        in_table("point", KeyKind::table, "point whose path is plotted", "point"),
        Key{"point_at_end", KeyKind::vector, "the point at the end, from a trusted computation", "m"}});

inline constexpr std::array kPoint{
    required({"body", KeyKind::text, "body that it belongs to"}),
    Key{"at", KeyKind::vector, "global at the start pose", "m"},
    Key{"point", KeyKind::vector, "in the frame of the body", "m"}};

/// Keys of a force or a torque; the description `direction` also tells the unit.
constexpr auto load(std::string_view what, std::string_view direction, std::string_view unit) {
    return joined(
        std::array{
            required({"body", KeyKind::text, "body that it acts on"}),
            Key{what, KeyKind::vector, "three numbers; times the function of time if there is one", unit},
            Key{"direction", KeyKind::direction, direction},
            one_of("frame", "whose directions these are; 'local' turns with the body", words_in<kFrames>)},
        function_of_time("harmonic", "smooth_step", "values"));
}
inline constexpr std::array kForce = joined(
    load("force", "instead: its direction, beside a function of time in N", "N"),
    std::array{
        Key{"at", KeyKind::vector, "point, global at the start pose", "m"},
        Key{"point", KeyKind::vector, "point in the frame of the body", "m"},
        Key{"law", KeyKind::formula,
            "formula in N that is added, of t and of quantities such as \\text{hinge.angle}"}});
inline constexpr std::array kTorque = joined(
    load("torque", "instead: its direction, beside a function of time in N m", "N m"),
    std::array{
        Key{"against", KeyKind::text, "body that the opposite torque acts on"},
        Key{"law", KeyKind::formula,
            "formula in N m that is added, of t and of quantities such as \\text{hinge.angle}"}});

inline constexpr std::array kSpring{
    counted("bodies", KeyKind::texts, "names of two bodies", 2, 2),
    Key{"at", KeyKind::vector, "point of the first body, global at the start pose", "m"},
    Key{"to", KeyKind::vector, "point of the second body, global at the start pose", "m"},
    Key{"point_i", KeyKind::vector, "point in the frame of the first body", "m"},
    Key{"point_j", KeyKind::vector, "point in the frame of the second body", "m"},
    Key{"joint", KeyKind::text, "instead of bodies and points: joint along whose axis it acts"},
    Key{"stiffness", KeyKind::not_negative, "k", "N/m"},
    Key{"damping", KeyKind::not_negative, "c", "N s/m"},
    Key{"friction", KeyKind::not_negative, "dry friction against the motion", "N"},
    Key{"friction_speed", KeyKind::positive, "rate up to which the friction grows", "m/s"},
    Key{"law", KeyKind::formula, "formula in N that is added, of d in m, \\dot{d} in m/s and t"},
    Key{"free_length", KeyKind::not_negative, "length without force; default that at the start", "m"},
    Key{"free_displacement", KeyKind::number, "of a joint, likewise", "m"}};

inline constexpr std::array kRotationalSpring{
    required({"joint", KeyKind::text, "joint that has an angle"}),
    Key{"stiffness", KeyKind::not_negative, "k", "N m/rad"},
    Key{"damping", KeyKind::not_negative, "c", "N m s/rad"},
    Key{"friction", KeyKind::not_negative, "dry friction against the motion", "N m"},
    spelled(
        {"friction_speed", KeyKind::positive, "rate up to which the friction grows"},
        Spelling::angular_velocity),
    Key{"law", KeyKind::formula,
        "formula in N m that is added, of \\theta in rad, \\dot{\\theta} in rad/s and t"},
    spelled(
        {"free_angle", KeyKind::number, "angle without torque; default that at the start"}, Spelling::angle)};

inline constexpr std::array kConstantsOfBushing{
    MemberKey<Bushing>{{"stiffness", KeyKind::vector, "along its x, y and z", "N/m"}, &Bushing::stiffness},
    MemberKey<Bushing>{{"damping", KeyKind::vector, "along its x, y and z", "N s/m"}, &Bushing::damping},
    MemberKey<Bushing>{
        {"rotational_stiffness", KeyKind::vector, "about its x, y and z", "N m/rad"},
        &Bushing::rotational_stiffness},
    MemberKey<Bushing>{
        {"rotational_damping", KeyKind::vector, "about its x, y and z", "N m s/rad"},
        &Bushing::rotational_damping}};
inline constexpr std::array kBushing = joined(
    std::array{
        required(
            counted("bodies", KeyKind::texts, "names of two bodies, the first is i, the second j", 2, 2)),
        Key{"at", KeyKind::vector, "its point, global at the start pose", "m"},
        Key{"point_i", KeyKind::vector, "point in the frame of the first body", "m"},
        Key{"point_j", KeyKind::vector, "point in the frame of the second body", "m"},
        Key{"axis", KeyKind::direction, "its z axis, global at the start pose; default the global one"},
        Key{"axis_i", KeyKind::direction, "z axis in the frame of the first body"},
        Key{"axis_j", KeyKind::direction, "z axis in the frame of the second body"},
        Key{"side", KeyKind::direction, "its x axis, global, perpendicular to the axis"},
        Key{"side_i", KeyKind::direction, "x axis in the frame of the first body"},
        Key{"side_j", KeyKind::direction, "x axis in the frame of the second body"}},
    keys_in(kConstantsOfBushing));

inline constexpr std::array kMotionTables{
    KeyTable{"driver", kDriver},
    KeyTable{"harmonic_of_driver", kHarmonicOfDriver},
    KeyTable{"smooth_step_of_driver", kSmoothStepOfDriver},
    KeyTable{"values_of_driver", kValuesOfDriver},
    KeyTable{"harmonic", kHarmonic},
    KeyTable{"smooth_step", kSmoothStep},
    KeyTable{"values", kValues},
    KeyTable{"motion", kMotion},
    KeyTable{"dynamics", kDynamics},
    KeyTable{"point", kPoint},
    KeyTable{"force", kForce},
    KeyTable{"torque", kTorque},
    KeyTable{"spring", kSpring},
    KeyTable{"rotational_spring", kRotationalSpring},
    KeyTable{"bushing", kBushing}};

}  // namespace jw::format
