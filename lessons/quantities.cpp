#include <algorithm>
#include <array>

#include "lessons/quantities.hpp"

namespace jw::reading {

namespace {

constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};
constexpr std::array<std::string_view, 4> kParameters{"e0", "e1", "e2", "e3"};

template <std::size_t N>
int index_in(const std::array<std::string_view, N>& words, std::string_view word) {
    const auto found = std::ranges::find(words, word);
    return found == words.end() ? -1 : static_cast<int>(found - words.begin());
}

std::vector<std::string> split_at_dots(std::string_view text) {
    std::vector<std::string> parts;
    while (true) {
        const std::size_t dot = text.find('.');
        parts.emplace_back(text.substr(0, dot));
        if (dot == std::string_view::npos) { return parts; }
        text.remove_prefix(dot + 1);
    }
}

void refuse(
    Fields& fields, const Located<std::string>& text, const std::string& owner, const std::string& of) {
    fields.problems().add(
        text.span, in_quotes(text.value) + " is no quantity of " + owner + "; expected one of " + of);
}

std::optional<MeasuredQuantity> of_joint(
    Fields& fields, const Located<std::string>& text, const std::string& word, int index,
    const Joint& joint) {
    MeasureQuantity quantity{ThetaMeasure{}, joint.body_i, joint.body_j, index};
    std::string possible;
    const auto offers = [&](const char* name, bool is_there) {
        if (is_there) { possible += (possible.empty() ? "" : ", ") + std::string(name); }
        return is_there && word == name;
    };
    if (offers("angle", joint.type->has_angle())) {
        if (joint.type->artificial == 0) { quantity.measure = angle_of(joint); }
        return MeasuredQuantity{quantity, Unit::radian};
    }
    if (offers("displacement", joint.type->has_displacement())) {
        quantity.measure = displacement_of(joint);
        return MeasuredQuantity{quantity, Unit::metre};
    }
    if (offers("distance", joint.type->uses(Role::length))) {
        quantity.measure = SquaredDistanceMeasure{joint.geometry.P_i_local, joint.geometry.P_j_local};
        return MeasuredQuantity{quantity, Unit::metre};
    }
    const std::string owner = "joint " + in_quotes(joint.name) + " of type " + std::string(joint.type->name);
    refuse(fields, text, owner, possible.empty() ? "those of bodies, like crank.x" : possible);
    return std::nullopt;
}

std::optional<MeasuredQuantity> of_body(
    Fields& fields, const Located<std::string>& text, const std::vector<std::string>& parts, int body) {
    const int last = index_in(kAxes, parts.back());
    const bool is_point = parts.size() == 3 && parts[1] == "point" && last >= 0;
    const auto point = is_point ? fields.vector("point") : std::nullopt;
    if (is_point) {
        fields.require("point", "the point in the body's frame, three numbers in m");
        return MeasuredQuantity{PointQuantity{body, point ? point->value : Vec3::Zero(), last}, Unit::metre};
    }
    if (parts.size() == 2 && last >= 0) {
        return MeasuredQuantity{MeasureQuantity{CoordinateMeasure{last}, 0, body, -1}, Unit::metre};
    }
    const int parameter = index_in(kParameters, parts[1]);
    if (parts.size() == 2 && parameter >= 0) {
        return MeasuredQuantity{MeasureQuantity{CoordinateMeasure{3 + parameter}, 0, body, -1}, Unit::none};
    }
    if (parts.size() == 3 && last >= 0 && (parts[1] == "omega" || parts[1] == "omega_local")) {
        return MeasuredQuantity{
            AngularVelocityQuantity{body, parts[1] == "omega_local", last}, Unit::radian_per_second};
    }
    refuse(
        fields, text, "body " + in_quotes(parts[0]),
        "x, y, z, e0, e1, e2, e3, point.x (with the key 'point'), omega.x, omega_local.x");
    return std::nullopt;
}

}  // namespace

std::optional<MeasuredQuantity> read_quantity(
    Fields& fields, const Located<std::string>& text, const Reading& reading) {
    const std::vector<std::string> parts = split_at_dots(text.value);
    const auto found = reading.names.find(parts[0]);
    if (parts.size() < 2 || found == reading.names.end() || found->second.kind == Named::Kind::driver) {
        std::vector<std::string> names;
        for (const auto& [name, named] : reading.names) {
            if (named.kind != Named::Kind::driver) { names.push_back(name); }
        }
        fields.problems().add(
            text.span,
            in_quotes(text.value) + " is no quantity; expected NAME.WHAT with NAME one of " +
                comma_list(names),
            found == reading.names.end() ? did_you_mean(parts[0], names) : "for example " + parts[0] + ".x");
        return std::nullopt;
    }
    const Named& named = found->second;
    if (!named.sound) { return std::nullopt; }
    if (named.kind == Named::Kind::body) { return of_body(fields, text, parts, named.index); }
    const auto index = static_cast<std::size_t>(named.index);
    const std::string word = text.value.substr(parts[0].size() + 1);
    return of_joint(fields, text, word, named.index, reading.lesson.mechanism.joints[index]);
}

}  // namespace jw::reading
