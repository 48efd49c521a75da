#include <stdexcept>

#include "lessons/format/claim_keys.hpp"
#include "lessons/format/exercise_keys.hpp"
#include "lessons/format/motion_keys.hpp"
#include "lessons/format/scene_keys.hpp"

/// All tables of a lesson, how their keys are spelled, and the units of their numbers.
namespace jw {

namespace {

constexpr std::array kAll =
    joined(format::kSceneTables, format::kMotionTables, format::kClaimTables, format::kExerciseTables);

/// Description of a key with its unit: "point in its frame [m]", "value before [m]; default 0".
std::string described(const Key& key) {
    std::string about(key.about);
    const std::string unit = key.unit.empty() ? "" : " [" + std::string(key.unit) + ']';
    return about.insert(std::min(about.find_first_of(";:"), about.size()), unit);
}

constexpr std::array kPlain{UnitEnding{"", ""}};
constexpr std::array kAngle{UnitEnding{"_deg", "deg"}, UnitEnding{"_rad", "rad"}};
constexpr std::array kAngularVelocity{UnitEnding{"_deg_per_s", "deg/s"}, UnitEnding{"_rad_per_s", "rad/s"}};
constexpr std::array kAny{
    UnitEnding{"", ""},
    UnitEnding{"_deg", "deg"},
    UnitEnding{"_rad", "rad"},
    UnitEnding{"_deg_per_s", "deg/s"},
    UnitEnding{"_rad_per_s", "rad/s"},
    UnitEnding{"_deg_per_s2", "deg/s²"},
    UnitEnding{"_rad_per_s2", "rad/s²"}};

/// Unit of a key without endings for units: its `unit`, or the unit at the end of its name.
std::string unit_of(const Key& key) {
    constexpr std::array in_name{
        UnitEnding{"_rad_per_s", "rad/s"}, UnitEnding{"_hz", "Hz"}, UnitEnding{"_s", "s"}};
    if (!key.unit.empty()) { return std::string(key.unit); }
    const auto ending =
        std::ranges::find_if(in_name, [&](const UnitEnding& one) { return key.name.ends_with(one.text); });
    return ending != in_name.end() ? std::string(ending->unit) : "";
}

constexpr std::array kOtherNames{
    // of bodies
    OtherName{"r", "position"}, OtherName{"pos", "position"}, OtherName{"origin", "position"},
    OtherName{"quaternion", "p"}, OtherName{"euler_parameters", "p"}, OtherName{"orientation", "p"},
    OtherName{"m", "mass"}, OtherName{"J", "inertia"}, OtherName{"I", "inertia"}, OtherName{"com", "centre"},
    OtherName{"centre_of_mass", "centre"}, OtherName{"r_dot", "velocity"}, OtherName{"omega", "omega_global"},
    // of joints
    OtherName{"body_i", "bodies"}, OtherName{"body_j", "bodies"}, OtherName{"body_i", "body"},
    OtherName{"body_j", "against"}, OtherName{"parent", "bodies"}, OtherName{"child", "bodies"},
    OtherName{"connects", "bodies"}, OtherName{"P_i", "point_i"}, OtherName{"P_j", "point_j"},
    OtherName{"s_i", "axis_i"}, OtherName{"s_j", "axis_j"}, OtherName{"u_i", "side_i"},
    OtherName{"u_j", "side_j"}, OtherName{"h_i", "side_i"}, OtherName{"h_j", "side_j"},
    OtherName{"L", "length"}, OtherName{"anchor", "at"}, OtherName{"kind", "type"},
    OtherName{"lead", "pitch"},
    // of drivers, springs and motions
    OtherName{"rate", "polynomial"}, OtherName{"speed", "polynomial"}, OtherName{"expression", "formula"},
    OtherName{"expr", "formula"}, OtherName{"k", "stiffness"}, OtherName{"c", "damping"},
    OtherName{"rest_length", "free_length"}, OtherName{"l_0", "free_length"}, OtherName{"l0", "free_length"},
    OtherName{"g", "gravity"}, OtherName{"end", "duration"}, OtherName{"t_end", "duration"},
    OtherName{"end", "to_s"}, OtherName{"t_end", "to_s"}};

}  // namespace

std::span<const KeyTable> key_tables() { return kAll; }

const KeyTable& key_table(std::string_view name) {
    const auto found = std::ranges::find(kAll, name, &KeyTable::name);
    if (found == kAll.end()) {
        throw std::logic_error("no table " + std::string(name) + " in lessons/format");
    }
    return *found;
}

std::span<const UnitEnding> endings_of(Spelling spelling) {
    switch (spelling) {
        case Spelling::plain: return kPlain;
        case Spelling::angle: return kAngle;
        case Spelling::angular_velocity: return kAngularVelocity;
        case Spelling::any: return kAny;
    }
    return {};
}

const Key* find_key(const KeyTable& table, std::string_view name) {
    const auto is_spelling_of = [name](const Key& key) {
        const auto ends = [&](const UnitEnding& ending) {
            return name.substr(key.name.size()) == ending.text;
        };
        return name.starts_with(key.name) && std::ranges::any_of(endings_of(key.spelling), ends);
    };
    const auto found = std::ranges::find_if(table.keys, is_spelling_of);
    return found != table.keys.end() ? &*found : nullptr;
}

std::vector<SpelledKey> spelled_keys(const KeyTable& table) {
    std::vector<SpelledKey> out;
    for (const Key& key : table.keys) {
        const std::string about = described(key);
        for (const UnitEnding& ending : endings_of(key.spelling)) {
            const bool is_in_si = key.spelling == Spelling::any && ending.text.empty();
            out.push_back(
                {std::string(key.name).append(ending.text), is_in_si ? about + ", in SI units" : about,
                 ending.unit.empty() ? unit_of(key) : std::string(ending.unit), &key});
        }
    }
    return out;
}

std::string unit_of_key(std::string_view path) {
    const KeyTable* table = &kAll.front();
    while (true) {
        const std::size_t end = path.find('.');
        const std::string_view name = path.substr(0, end);
        if (end == std::string_view::npos) {
            const std::vector<SpelledKey> keys = spelled_keys(*table);
            const auto key = std::ranges::find(keys, name, &SpelledKey::name);
            return key != keys.end() ? key->unit : "";
        }
        // a part that is not a key is the name or the number of an entry
        const Key* key = find_key(*table, name);
        if (key != nullptr && !key->table.empty()) { table = &key_table(key->table); }
        path.remove_prefix(end + 1);
    }
}

std::span<const OtherName> other_names() { return kOtherNames; }

std::string key_meant_by(std::string_view tried, std::span<const std::string> keys) {
    for (const OtherName& name : kOtherNames) {
        if (name.tried != tried) { continue; }
        const auto key = std::ranges::find_if(keys, [&](const std::string& known) {
            return known == name.meant || known.starts_with(std::string(name.meant) + "_deg");
        });
        if (key != keys.end()) { return *key; }
    }
    return {};
}

namespace format {

std::vector<std::string> words_of_roles() {
    std::vector<std::string> roles;
    for (const JointType& type : kJointTypes) {
        for (const Role role : type.roles) {
            const std::string word(word_of(role));
            if (std::ranges::find(roles, word) == roles.end()) { roles.push_back(word); }
        }
    }
    return roles;
}

}  // namespace format

}  // namespace jw
