#include <array>
#include <cstdio>
#include <map>

#include "app/snapshot/fact_list.hpp"
#include "app/snapshot/scene_names.hpp"
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

/// Adds facts about a geometry, and returns what it is called.
class GeometryFacts {
public:
    GeometryFacts(std::string name, FactList& facts) : name_(std::move(name)), facts_(facts) {}

    void add(const render::Geometry& geometry) const {
        std::visit(
            Overloaded{
                [&](const render::Box& box) {
                    kind("box");
                    add_pose(box.pose, name_, facts_);
                    facts_.vector(Weight::pose, name_ + " · size", 2.0 * box.half_size, "m");
                },
                [&](const render::Sphere& sphere) {
                    kind("sphere");
                    facts_.vector(Weight::pose, name_ + " · at", sphere.centre, "m");
                    length("radius", sphere.radius);
                },
                [&](const render::Cylinder& bar) {
                    kind("cylinder");
                    ends(bar.from, bar.to);
                    length("radius", bar.radius);
                },
                [&](const render::Rod& rod) {
                    kind("rod");
                    ends(rod.from, rod.to);
                    length("radius", rod.radius);
                },
                [&](const render::Tube& tube) {
                    kind("tube");
                    ends(tube.from, tube.to);
                    length("outer radius", tube.outer_radius);
                    length("inner radius", tube.inner_radius);
                },
                [&](const render::Ring& ring) {
                    kind("ring");
                    facts_.vector(Weight::pose, name_ + " · at", ring.centre, "m");
                    facts_.vector(Weight::pose, name_ + " · axis", ring.axis, "");
                    length("radius", ring.radius);
                    length("radius of the wire", ring.wire_radius);
                },
                [&](const render::Screw& screw) {
                    turned("screw", screw);
                    length("radius", screw.radius);
                    length("pitch", screw.pitch);
                },
                [&](const render::Nut& nut) {
                    turned("nut", nut);
                    length("radius of the corners", nut.corner_radius);
                    length("radius of the hole", nut.hole_radius);
                }},
            geometry);
    }

private:
    void kind(const char* word) const { facts_.text(Weight::count, name_, word); }
    void length(const char* what, double value) const {
        facts_.number(Weight::pose, name_ + " · " + what, value, "m");
    }
    /// Adds a shape that shows how it is turned about its axis.
    void turned(const char* word, const auto& shape) const {
        kind(word);
        ends(shape.from, shape.to);
        facts_.vector(Weight::pose, name_ + " · side", shape.side, "");
    }
    void ends(const Vec3& from, const Vec3& to) const {
        facts_.vector(Weight::pose, name_ + " · from", from, "m");
        facts_.vector(Weight::pose, name_ + " · to", to, "m");
    }

    std::string name_;
    FactList& facts_;
};

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
        GeometryFacts(name, facts).add(shape.geometry);
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
