#include "core/integrate/methods.hpp"
#include "core/motion/tolerances.hpp"
#include "lessons/enum_words.hpp"
#include "lessons/schema/keys.hpp"
#include "lessons/typed.hpp"

/// Keys of drivers, motions, dynamics and loads.
namespace jw {

namespace {

// coefficients of a polynomial
constexpr int kMostTyped = 50;

template <class Names>
std::vector<std::string> names_in(const Names& entries) {
    std::vector<std::string> names;
    for (const auto& entry : entries) { names.emplace_back(entry.name); }
    return names;
}

/// Keys of a function of time. @param of  "harmonic" and "smooth_step", or those of a driver
void add_function(std::vector<Key>& keys, const std::string& of = {}) {
    keys.push_back(
        counted_key("polynomial", KeyKind::numbers, "coefficients c0, c1, c2, ... of t^k", 1, kMostTyped));
    keys.push_back(table_key("harmonics", KeyKind::tables, "sines of time", "harmonic" + of));
    keys.push_back(
        table_key("step", KeyKind::tables, "smooth steps from one value to another", "smooth_step" + of));
}

KeyTable driver_keys() {
    Key quantity{"quantity", KeyKind::text, "what is prescribed, or its name as \"hinge.angle\"", true};
    quantity.words = {"angle", "displacement", "distance", "coordinate"};
    quantity.pattern = "\\.";
    KeyTable driver{
        "driver",
        {required({"name", KeyKind::text, "name by which the lesson refers to it"}),
         quantity,
         {"joint", KeyKind::text, "joint whose angle or displacement it is"},
         counted_key("bodies", KeyKind::texts, "two bodies whose points have the distance", 2, 2),
         {"at", KeyKind::vector, "point of the first body, global at the start pose [m]"},
         {"to", KeyKind::vector, "point of the second body, global at the start pose [m]"},
         {"point_i", KeyKind::vector, "point in the frame of the first body [m]"},
         {"point_j", KeyKind::vector, "point in the frame of the second body [m]"},
         {"body", KeyKind::text, "body whose coordinate it is"},
         word_key("coordinate", "coordinate of the body", strings(kCoordinates)),
         {"from_start", KeyKind::flag, "adds the value at the start pose"},
         {"text", KeyKind::words, "the author's words in its step"}}};
    add_function(driver.keys, "_of_driver");
    for (const char* unit : {"_deg", "_rad"}) {
        driver.keys.push_back(counted_key(
            std::string("polynomial") + unit, KeyKind::numbers,
            "coefficients c0, c1, c2, ... of t^k of an angle", 1, kMostTyped));
    }
    return driver;
}

/// @param of  "_of_driver" if values may be angles
void add_function_tables(std::vector<KeyTable>& tables, const std::string& of) {
    KeyTable harmonic{
        "harmonic" + of,
        {{"amplitude", KeyKind::number, "size of the swing"},
         {"frequency_hz", KeyKind::number, "oscillations per second"},
         {"omega_rad_per_s", KeyKind::number, "instead of the frequency: 2 pi times it"}}};
    add_angle(harmonic.keys, "phase", KeyKind::number, "angle of the sine at t = 0");
    KeyTable step{
        "smooth_step" + of,
        {{"from", KeyKind::number, "value before; default 0"},
         {"to", KeyKind::number, "value afterwards"},
         {"start_s", KeyKind::number, "time at which it starts; default 0"},
         required({"end_s", KeyKind::number, "time at which it ends"})}};
    if (!of.empty()) {
        add_angle(harmonic.keys, "amplitude", KeyKind::number, "size of the swing of an angle");
        add_angle(step.keys, "from", KeyKind::number, "angle before; default 0");
        add_angle(step.keys, "to", KeyKind::number, "angle afterwards");
    }
    tables.push_back(std::move(harmonic));
    tables.push_back(std::move(step));
}

void add_plans(std::vector<KeyTable>& tables) {
    constexpr int most_steps = 100000;
    tables.push_back(
        {"motion",
         {{"from_s", KeyKind::number, "time at which everything is put together; default 0"},
          required({"to_s", KeyKind::number, "time at which it ends"}),
          {"duration_s", KeyKind::positive, "how long it takes on the screen"},
          counted_key("steps", KeyKind::whole_number, "equal intervals that are solved", 1, most_steps)}});
    tables.push_back(
        {"dynamics",
         {required({"duration", KeyKind::positive, "how long it moves [s]"}),
          {"gravity", KeyKind::vector, "global [m/s^2]; default none"},
          word_key("method", "method of integration", names_in(kMethods)),
          word_key("treatment", "how the constraints are kept", names_in(kTreatments)),
          {"tolerance", KeyKind::positive, "of methods whose steps follow the error"},
          {"step", KeyKind::positive, "of methods with equal steps [s]"},
          table_key("point", KeyKind::table, "point whose path is plotted", "point"),
          {"point_at_end", KeyKind::vector, "where a trusted computation finds it at the end [m]"}}});
    tables.push_back(
        {"point",
         {required({"body", KeyKind::text, "body that it belongs to"}),
          {"at", KeyKind::vector, "global at the start pose [m]"},
          {"point", KeyKind::vector, "in the frame of the body [m]"}}});
}

/// @param what  "force" or "torque"
KeyTable load_keys(const std::string& what, const std::string& unit) {
    KeyTable load{
        what,
        {required({"body", KeyKind::text, "body that it acts on"}),
         {what, KeyKind::vector, "three numbers [" + unit + "], times the function of time if there is one"},
         {"direction", KeyKind::direction, "instead: its direction, beside a function of time in " + unit},
         word_key("frame", "whose directions these are; 'local' turns with the body", words_of(kFrames))}};
    add_function(load.keys);
    return load;
}

void add_loads(std::vector<KeyTable>& tables) {
    tables.push_back(load_keys("force", "N"));
    tables.back().keys.push_back({"at", KeyKind::vector, "point, global at the start pose [m]"});
    tables.back().keys.push_back({"point", KeyKind::vector, "point in the frame of the body [m]"});
    tables.push_back(load_keys("torque", "N m"));
    const Key stiffness{"stiffness", KeyKind::not_negative, "k [N/m or N m/rad]"};
    const Key damping{"damping", KeyKind::not_negative, "c [N s/m or N m s/rad]"};
    tables.push_back(
        {"spring",
         {required(counted_key("bodies", KeyKind::texts, "names of two bodies", 2, 2)),
          {"at", KeyKind::vector, "point of the first body, global at the start pose [m]"},
          {"to", KeyKind::vector, "point of the second body, global at the start pose [m]"},
          {"point_i", KeyKind::vector, "point in the frame of the first body [m]"},
          {"point_j", KeyKind::vector, "point in the frame of the second body [m]"},
          stiffness,
          damping,
          {"free_length", KeyKind::not_negative, "length without force [m]; default that at the start"}}});
    KeyTable about_axis{
        "rotational_spring",
        {required({"joint", KeyKind::text, "joint that has an angle"}), stiffness, damping}};
    add_angle(
        about_axis.keys, "free_angle", KeyKind::number, "angle without torque; default that at the start");
    tables.push_back(std::move(about_axis));
}

}  // namespace

void add_motion_tables(std::vector<KeyTable>& tables) {
    tables.push_back(driver_keys());
    add_function_tables(tables, "_of_driver");
    add_function_tables(tables, "");
    add_plans(tables);
    add_loads(tables);
}

}  // namespace jw
