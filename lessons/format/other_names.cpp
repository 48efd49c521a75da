#include "lessons/format/other_names.hpp"

#include <algorithm>
#include <array>

namespace jw {

namespace {

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

}  // namespace jw
