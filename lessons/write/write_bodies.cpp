#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "lessons/fields/member_keys.hpp"
#include "lessons/format/scene_keys.hpp"
#include "lessons/typed/typed.hpp"
#include "lessons/write/writing.hpp"

namespace jw::writing {

namespace {

std::string axes_text(const Mat3& axes) {
    return Inline()
        .add("x", Vec3(axes.col(0)))
        .add("y", Vec3(axes.col(1)))
        .add("z", Vec3(axes.col(2)))
        .text();
}

struct ShapeText {
    std::string operator()(const Box& box) const {
        Inline keys;
        write_members(format::kSizeOfBox, box, keys);
        if (box.axes != Mat3::Identity()) { keys.add("axes", axes_text(box.axes)); }
        return Inline().add("box", keys.text()).text();
    }
    std::string operator()(const Sphere& sphere) const { return bound("sphere", format::kSphere, sphere); }
    std::string operator()(const Cylinder& bar) const {
        return bound("cylinder", format::kBar<Cylinder>, bar);
    }
    std::string operator()(const Rod& bar) const { return bound("rod", format::kBar<Rod>, bar); }

    template <class Keys, class Form>
    static std::string bound(const char* name, const Keys& described, const Form& form) {
        Inline keys;
        write_members(described, form, keys);
        return Inline().add(name, keys.text()).text();
    }
};

void write_orientation(const Vec4& p, Lines& lines) {
    if (p == Vec4::Unit(0)) { return; }
    if (const auto typed = typed_rotation(p)) {
        const Inline keys = Inline().add("axis", typed->axis).add("angle_deg", typed->angle_deg);
        lines.key("rotation", keys.text());
        return;
    }
    lines.key("p", list_text({p.data(), 4}), about_rotation(p));
}

using Mass = std::optional<MassProperties>;

void write_body(const Body& body, const Look& look, const Mass& mass, bool is_ground, Lines& lines) {
    lines.table("[[body]]");
    lines.key("name", string_text(body.name));
    if (body.fixed && !is_ground) { lines.key("fixed", "true"); }
    if (!body.r.isZero(0.0)) { lines.key("position", body.r, "m"); }
    write_orientation(body.p, lines);
    if (!body.r_dot.isZero(0.0)) { lines.key("velocity", body.r_dot, "m/s"); }
    if (!body.omega_local.isZero(0.0)) {
        lines.angles("omega_local", {body.omega_local.data(), 3}, "_per_s");
    }
    if (mass) { write_mass(*mass, lines); }
    if (look.colour) { lines.key("colour", string_text(colour_text(*look.colour))); }
    write_shapes(look.shapes, lines);
}

/// True for the ground that every lesson has by default.
bool is_plain(const Body& ground, const Look& look) {
    return ground.r.isZero(0.0) && ground.p == Vec4::Unit(0) && ground.r_dot.isZero(0.0) &&
           ground.omega_local.isZero(0.0) && look.shapes.empty() && !look.colour;
}

}  // namespace

std::string colour_text(const Colour& colour) {
    const auto byte = [](double x) {
        return static_cast<unsigned>(std::lround(255.0 * std::clamp(x, 0.0, 1.0)));
    };
    const unsigned rgb = byte(colour.red) << 16U | byte(colour.green) << 8U | byte(colour.blue);
    const auto found = std::ranges::find(kNamedColours, rgb, &NamedColour::rgb);
    if (found != kNamedColours.end()) { return std::string(found->name); }
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%06x", rgb);
    return text.data();
}

void write_shapes(const std::vector<Shape>& shapes, Lines& lines) {
    if (shapes.empty()) { return; }
    if (shapes.size() == 1) {
        lines.key("shape", std::visit(ShapeText{}, shapes[0]));
        return;
    }
    std::string list = "[\n";
    for (const Shape& shape : shapes) { list += "  " + std::visit(ShapeText{}, shape) + ",\n"; }
    lines.key("shape", list + ']');
}

void write_bodies(const Lesson& lesson, Lines& lines) {
    const std::vector<Body>& bodies = lesson.mechanism.bodies;
    lines.section("bodies: where their frames are at the start; shapes in these frames [m]");
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const Mass mass = lesson.dynamics ? lesson.dynamics->loads.masses[b] : Mass();
        if (b == 0 && !mass && is_plain(bodies[b], lesson.looks[b])) { continue; }
        write_body(bodies[b], lesson.looks[b], mass, b == 0, lines);
    }
}

}  // namespace jw::writing
