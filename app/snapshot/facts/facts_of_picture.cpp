#include <array>
#include <cstdio>
#include <map>

#include "app/snapshot/facts/fact_list.hpp"
#include "app/snapshot/layers_picture.hpp"
#include "core/numerics/variants.hpp"

namespace jw::snapshot {

namespace {

/// "#d55e00", with two more digits if it is transparent.
std::string colour_text(const render::Colour& colour) {
    const auto byte = [](float part) { return static_cast<unsigned>(std::lround(255.0F * part)) & 0xFFU; };
    std::array<char, 16> text{};
    std::snprintf(
        text.data(), text.size(), colour.a < 1.0F ? "#%02x%02x%02x%02x" : "#%02x%02x%02x", byte(colour.r),
        byte(colour.g), byte(colour.b), byte(colour.a));
    return text.data();
}

void add_pose(const render::Pose& pose, const std::string& name, FactList& facts) {
    facts.vector(Weight::pose, name + " · at", pose.r, "m");
    facts.vector(Weight::pose, name + " · x axis", pose.A.col(0), "");
    facts.vector(Weight::pose, name + " · y axis", pose.A.col(1), "");
}

/// Adds facts about a geometry, and the name of its kind.
void add_geometry(const render::Geometry& geometry, const std::string& name, FactList& facts) {
    const auto kind = [&](const char* word) { facts.text(Weight::count, name, word); };
    const auto length = [&](const char* what, double value) {
        facts.number(Weight::pose, name + " · " + what, value, "m");
    };
    const auto vector = [&](const char* what, const Vec3& v, const char* unit) {
        facts.vector(Weight::pose, name + " · " + what, v, unit);
    };
    const auto along = [&](const char* word, const auto& shape) {
        kind(word);
        vector("from", shape.from, "m");
        vector("to", shape.to, "m");
        // how it is turned about its axis
        if constexpr (requires { shape.side; }) { vector("side", shape.side, ""); }
        if constexpr (requires { shape.radius; }) { length("radius", shape.radius); }
    };
    std::visit(
        Overloaded{
            [&](const render::Box& box) {
                kind("box");
                add_pose(box.pose, name, facts);
                vector("size", 2.0 * box.half_size, "m");
            },
            [&](const render::Sphere& sphere) {
                kind("sphere");
                vector("at", sphere.centre, "m");
                length("radius", sphere.radius);
            },
            [&](const render::Cylinder& bar) { along("cylinder", bar); },
            [&](const render::Rod& rod) { along("rod", rod); },
            [&](const render::Tube& tube) {
                along("tube", tube);
                length("outer radius", tube.outer_radius);
                length("inner radius", tube.inner_radius);
            },
            [&](const render::Ring& ring) {
                kind("ring");
                vector("at", ring.centre, "m");
                vector("axis", ring.axis, "");
                length("radius", ring.radius);
                length("radius of the wire", ring.wire_radius);
            },
            [&](const render::Screw& screw) {
                along("screw", screw);
                length("pitch", screw.pitch);
            },
            [&](const render::Nut& nut) {
                along("nut", nut);
                length("radius of the corners", nut.corner_radius);
                length("radius of the hole", nut.hole_radius);
            }},
        geometry);
}

/// Names parts after what they belong to, and counts those of each name.
class PartNames {
public:
    explicit PartNames(const Mechanism& mechanism) : mechanism_(mechanism) {}
    std::string next(const char* kind, int id) {
        const std::string owner = name_of_part(id, mechanism_);
        return owner + " · " + kind + " " + std::to_string(++counts_[owner + kind]);
    }

private:
    const Mechanism& mechanism_;
    std::map<std::string, int> counts_;
};

void add_look(const render::Colour& colour, bool highlighted, const std::string& name, FactList& facts) {
    facts.text(Weight::text, name + " · colour", colour_text(colour));
    if (highlighted) { facts.text(Weight::text, name + " · highlighted", "yes"); }
}

void add_line(const render::Polyline& line, const std::string& name, FactList& facts) {
    facts.count(Weight::count, name + " · points", static_cast<int>(line.points.size()));
    add_look(line.colour, false, name, facts);
    if (line.points.empty()) { return; }
    Vec3 mean = Vec3::Zero();
    for (const Vec3& point : line.points) { mean += point / static_cast<double>(line.points.size()); }
    facts.vector(Weight::detail, name + " · from", line.points.front(), "m");
    facts.vector(Weight::detail, name + " · to", line.points.back(), "m");
    facts.vector(Weight::detail, name + " · middle", mean, "m");
}

}  // namespace

std::vector<Fact> facts_of(const render::Camera& camera) {
    FactList facts;
    facts.vector(Weight::detail, "camera · eye", camera.eye, "m");
    facts.vector(Weight::detail, "camera · target", camera.target, "m");
    facts.vector(Weight::detail, "camera · up", camera.up, "");
    facts.number(Weight::detail, "camera · field of view", camera.field_of_view, "rad");
    return facts.take();
}

std::vector<Fact> facts_of(const Picture& picture, const Mechanism& mechanism) {
    FactList facts;
    PartNames names(mechanism);
    for (const render::Shape& shape : picture.scene.shapes) {
        const std::string name = names.next("shape", shape.id);
        add_geometry(shape.geometry, name, facts);
        add_look(shape.colour, shape.highlighted, name, facts);
    }
    for (const render::Arrow& arrow : picture.scene.arrows) {
        const std::string name = names.next("arrow", arrow.id);
        facts.vector(Weight::detail, name + " · from", arrow.from, "m");
        facts.vector(Weight::detail, name + " · to", arrow.to, "m");
        facts.number(Weight::detail, name + " · radius", arrow.radius, "m");
        add_look(arrow.colour, arrow.highlighted, name, facts);
    }
    for (const render::Triad& triad : picture.scene.triads) {
        const std::string name = names.next("axes", triad.id);
        add_pose(triad.pose, name, facts);
        facts.number(Weight::detail, name + " · length", triad.length, "m");
    }
    for (const render::Polyline& line : picture.scene.polylines) {
        add_line(line, names.next("line", line.id), facts);
    }
    for (const Annotation& annotation : picture.annotations) {
        facts.text(Weight::text, "name " + annotation.text, annotation.text);
        facts.vector(Weight::detail, "name " + annotation.text + " · at", annotation.at, "m");
    }
    return facts.take();
}

}  // namespace jw::snapshot
