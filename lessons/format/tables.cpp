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

/// "point in its frame [m]", "value before [m]; default 0".
std::string described(const Key& key) {
    std::string about(key.about);
    const std::string unit = key.unit.empty() ? "" : " [" + std::string(key.unit) + ']';
    return about.insert(std::min(about.find_first_of(";:"), about.size()), unit);
}

/// What stands behind the name of a key, and the unit that it tells.
struct Ending {
    std::string_view text;
    std::string_view unit;
};
constexpr std::array kAngle{Ending{"_deg", "deg"}, Ending{"_rad", "rad"}};
constexpr std::array kAngularVelocity{Ending{"_deg_per_s", "deg/s"}, Ending{"_rad_per_s", "rad/s"}};
constexpr std::array kAny{Ending{"_deg", "deg"},           Ending{"_rad", "rad"},
                          Ending{"_deg_per_s", "deg/s"},   Ending{"_rad_per_s", "rad/s"},
                          Ending{"_deg_per_s2", "deg/s²"}, Ending{"_rad_per_s2", "rad/s²"}};

/// Unit of a key's numbers where it is spelled one way only: beside its name, or in it.
std::string unit_of(const Key& key) {
    constexpr std::array in_name{Ending{"_rad_per_s", "rad/s"}, Ending{"_hz", "Hz"}, Ending{"_s", "s"}};
    if (!key.unit.empty()) { return std::string(key.unit); }
    const auto ending =
        std::ranges::find_if(in_name, [&](const Ending& one) { return key.name.ends_with(one.text); });
    return ending != in_name.end() ? std::string(ending->unit) : "";
}

std::span<const Ending> endings_of(Spelling spelling) {
    switch (spelling) {
        case Spelling::plain: break;
        case Spelling::angle: return kAngle;
        case Spelling::angular_velocity: return kAngularVelocity;
        case Spelling::any: return kAny;
    }
    return {};
}

/// True for keys that may stand without an ending.
bool is_plain(const Key& key) { return key.spelling == Spelling::plain || key.spelling == Spelling::any; }

}  // namespace

std::span<const KeyTable> key_tables() { return kAll; }

const KeyTable& key_table(std::string_view name) {
    const auto found = std::ranges::find(kAll, name, &KeyTable::name);
    if (found == kAll.end()) {
        throw std::logic_error("no table " + std::string(name) + " in lessons/format");
    }
    return *found;
}

const Key* find_key(const KeyTable& table, std::string_view name) {
    const auto is_spelling_of = [name](const Key& key) {
        if (!name.starts_with(key.name)) { return false; }
        const std::string_view ending = name.substr(key.name.size());
        return ending.empty() ? is_plain(key)
                              : std::ranges::find(endings_of(key.spelling), ending, &Ending::text) !=
                                    endings_of(key.spelling).end();
    };
    const auto found = std::ranges::find_if(table.keys, is_spelling_of);
    return found != table.keys.end() ? &*found : nullptr;
}

std::vector<SpelledKey> spelled_keys(const KeyTable& table) {
    std::vector<SpelledKey> out;
    for (const Key& key : table.keys) {
        const std::string about = described(key);
        const char* in_si = key.spelling == Spelling::any ? ", in SI units" : "";
        if (is_plain(key)) { out.push_back({std::string(key.name), about + in_si, unit_of(key), &key}); }
        for (const Ending& ending : endings_of(key.spelling)) {
            out.push_back({std::string(key.name).append(ending.text), about, std::string(ending.unit), &key});
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
        // what is no key is the name or the number of an entry
        const Key* key = find_key(*table, name);
        if (key != nullptr && !key->table.empty()) { table = &key_table(key->table); }
        path.remove_prefix(end + 1);
    }
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
