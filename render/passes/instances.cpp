#include "render/passes/instances.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <Eigen/Geometry>

namespace jw::render {

namespace {

// Rounded edges catch the light and separate faces; more rounding makes a body look like soap.
constexpr double kEdgeRounding = 0.14;  // of the smaller half extent
// Outlines in pixels: bodies have a fine line that separates equal colours, the highlighted body a strong
// line, and vectors a light rim that separates them from the bodies that they cross.
constexpr float kFineEdge = 0.9F;
constexpr float kStrongEdge = 2.8F;
constexpr float kLightRim = 1.3F;
constexpr float kHalo = 3.6F;
constexpr double kThicker = 1.5;  // a highlighted vector is recognised not only by its colour
constexpr float kEdgeDarkening = 0.62F;

constexpr double kThreadDepth = 0.5;     // of the pitch
constexpr double kDeepestThread = 0.22;  // of the radius
constexpr double kMostTurns = 400.0;     // finer threads are smaller than a pixel
constexpr double kDashPeriod = 1.7;      // dash and gap, in dashes
constexpr double kMostDashes = 2000.0;

/// Right-handed frame with z along `axis` and x as near to `side` as possible.
Pose frame_along(const Vector3d& origin, const Vector3d& axis, const Vector3d& side) {
    Pose pose;
    pose.r = origin;
    const Vector3d z = axis.normalized();
    Vector3d x = side - z * z.dot(side);
    // if the side lies along the axis (1e-9: only rounding is left of it), any perpendicular is used
    if (x.norm() < 1e-9 * std::max(side.norm(), 1e-9)) { x = z.unitOrthogonal(); }
    x.normalize();
    pose.A.col(0) = x;
    pose.A.col(1) = z.cross(x);
    pose.A.col(2) = z;
    return pose;
}

Pose frame_along(const Vector3d& origin, const Vector3d& axis) {
    return frame_along(origin, axis, axis.unitOrthogonal());
}

struct Look {
    Colour colour;
    float edge_width;
    Colour edge_colour;
    int id;
};

/// Adds instances with the same appearance to one group of lists.
class Builder {
public:
    Builder(InstanceLists& lists, const Look& look, const PixelAt& pixel_at)
        : lists_(lists), look_(look), pixel_at_(pixel_at) {}

    void add(MeshKind kind, const Pose& pose, const Vector3d& size, double inner, double rounding) {
        Instance instance;
        instance.pose << pose.A.cast<float>(), pose.r.cast<float>();
        instance.size << size.cast<float>(), static_cast<float>(inner);
        instance.rounding = static_cast<float>(rounding);
        instance.edge_width = look_.edge_width;
        instance.id = static_cast<float>(look_.id);
        instance.colour = look_.colour;
        instance.edge_colour = look_.edge_colour;
        lists_[mesh_number(kind, detail_of(kind, pose, size, rounding))].push_back(instance);
    }

    void operator()(const Box& box) {
        const double rounding = kEdgeRounding * box.half_size.minCoeff();
        add(MeshKind::box, box.pose, box.half_size - Vector3d::Constant(rounding), 0.0, rounding);
    }

    void operator()(const Sphere& sphere) {
        add(MeshKind::rod, Pose{Matrix3d::Identity(), sphere.centre}, Vector3d::Zero(), 0.0, sphere.radius);
    }

    void operator()(const Cylinder& bar) {
        const Vector3d axis = bar.to - bar.from;
        const double length = axis.norm();
        if (length <= 0.0) { return; }
        const double rounding = kEdgeRounding * std::min(bar.radius, 0.5 * length);
        const double core = bar.radius - rounding;
        add(MeshKind::round_bar, frame_along(bar.from + axis * (rounding / length), axis),
            {core, core, length - 2.0 * rounding}, 0.0, rounding);
    }

    void operator()(const Rod& rod) {
        const Vector3d axis = rod.to - rod.from;
        if (axis.norm() <= 0.0) { return (*this)(Sphere{rod.from, rod.radius}); }
        add(MeshKind::rod, frame_along(rod.from, axis), {0.0, 0.0, axis.norm()}, 0.0, rod.radius);
    }

    void operator()(const Tube& tube) {
        hollow(
            MeshKind::tube, tube.from, tube.to, tube.outer_radius, tube.inner_radius,
            (tube.to - tube.from).unitOrthogonal());
    }

    void operator()(const Ring& ring) {
        add(MeshKind::ring, frame_along(ring.centre, ring.axis), {ring.radius, ring.radius, 1.0}, 0.0,
            ring.wire_radius);
    }

    void operator()(const Nut& nut) {
        hollow(MeshKind::nut, nut.from, nut.to, nut.corner_radius, nut.hole_radius, nut.side);
    }

    void operator()(const Screw& screw) {
        const Vector3d axis = screw.to - screw.from;
        const double length = axis.norm();
        const double pitch = std::abs(screw.pitch);
        const double depth = std::min(kThreadDepth * pitch, kDeepestThread * screw.radius);
        (*this)(Cylinder{screw.from, screw.to, screw.radius - depth});
        // the ridge reaches one pitch further than the number of its turns
        const double turns = pitch > 0.0 ? std::min(std::floor(length / pitch) - 1.0, kMostTurns) : 0.0;
        const double margin = 0.5 * (length - (turns + 1.0) * pitch);
        const MeshKind kind = screw.pitch > 0.0 ? MeshKind::right_thread : MeshKind::left_thread;
        for (double turn = 0.0; turn < turns; turn += 1.0) {
            const Vector3d origin = screw.from + axis * ((margin + turn * pitch) / length);
            add(kind, frame_along(origin, axis, screw.side), {screw.radius, screw.radius, pitch},
                screw.radius - depth, 0.0);
        }
    }

    /// Shaft and head; a vector that is shorter than a head is only a head, reduced in size.
    void arrow(const Vector3d& from, const Vector3d& to, double radius) {
        const Vector3d along = to - from;
        const double length = along.norm();
        if (length <= 0.0) { return; }
        const double head_radius = std::min(2.5 * radius, length / static_cast<double>(kConeLength));
        const double head_length = static_cast<double>(kConeLength) * head_radius;
        const Vector3d base = to - along * (head_length / length);
        add(MeshKind::cone, frame_along(base, along), Vector3d::Constant(0.94 * head_radius), 0.0,
            0.06 * head_radius);
        // the shaft ends a little inside the head
        const double shaft = length - 0.95 * head_length;
        if (shaft > 0.05 * head_length) {
            add(MeshKind::shaft, frame_along(from, along), {radius, radius, shaft}, 0.0, 0.0);
        }
    }

private:
    /// Detail of a mesh, decided by the nearer end of round shapes. A box is round only at its edges.
    Detail detail_of(MeshKind kind, const Pose& pose, const Vector3d& size, double rounding) const {
        if (!pixel_at_) { return Detail::high; }
        const double radius = kind == MeshKind::box ? rounding / kEdgeRounding : size.x() + rounding;
        const Vector3d far_end = pose.r + size.z() * pose.A.col(2);
        return std::max(detail_for(radius / pixel_at_(pose.r)), detail_for(radius / pixel_at_(far_end)));
    }

    void hollow(
        MeshKind kind, const Vector3d& from, const Vector3d& to, double outer, double inner,
        const Vector3d& side) {
        const Vector3d axis = to - from;
        const double length = axis.norm();
        if (length <= 0.0) { return; }
        const double rounding = kEdgeRounding * std::min(outer - inner, length);
        add(kind, frame_along(from + axis * (rounding / length), axis, side),
            {outer - rounding, outer - rounding, length - 2.0 * rounding}, inner + rounding, rounding);
    }

    InstanceLists& lists_;
    Look look_;
    const PixelAt& pixel_at_;
};

/// Calls `piece(from, to)` for every dash of the path, which begins and ends with half a dash. A dash around
/// a corner comes in two pieces.
template <class Piece>
void for_each_dash(std::span<const Vector3d> path, double dash_length, const Piece& piece) {
    double total = 0.0;
    for (std::size_t n = 1; n < path.size(); ++n) { total += (path[n] - path[n - 1]).norm(); }
    const double period =
        total / std::clamp(std::round(total / (kDashPeriod * dash_length)), 1.0, kMostDashes);
    const double half = 0.5 * period / kDashPeriod;
    double start = 0.0;  // arc length at the beginning of this segment
    for (std::size_t n = 1; n < path.size(); ++n) {
        const Vector3d& from = path[n - 1];
        const Vector3d& to = path[n];
        const double length = (to - from).norm();
        if (length <= 0.0) { continue; }
        for (double dash = std::floor((start + half) / period); dash * period - half < start + length;
             dash += 1.0) {
            const double first = std::max(dash * period - half - start, 0.0) / length;
            const double last = std::min((dash * period + half - start) / length, 1.0);
            if (last > first) { piece(from + (to - from) * first, from + (to - from) * last); }
        }
        start += length;
    }
}

InstanceLists& list_for(
    DrawLists& lists, InstanceLists& otherwise, float alpha, bool see_through, bool highlighted = false) {
    if (alpha < 1.0F) { return lists.ghosts; }
    if (!see_through) { return otherwise; }
    return highlighted ? lists.emphasised : lists.see_through;
}

/// Look with an amber halo: amber is bright on paper and in the dark, so it is the same in both tones.
Look halo(const Colour& colour, int id) {
    return {colour, kHalo, with_alpha(palette::kHighlight, colour.a), id};
}

Look look_of(const Shape& shape, Tone tone) {
    // a shape that is visible through bodies is a symbol, not a body
    const Colour colour = shape.see_through ? toned(shape.colour, tone) : shape.colour;
    if (shape.highlighted && shape.see_through) { return halo(colour, shape.id); }
    if (shape.highlighted) { return {colour, kStrongEdge, toned(palette::kInk, tone), shape.id}; }
    const Colour dark = with_alpha(mix(colour, palette::kInk, kEdgeDarkening), colour.a);
    return {colour, kFineEdge, dark, shape.id};
}

void add_shape(DrawLists& lists, const Shape& shape, Tone tone, const PixelAt& pixel_at) {
    InstanceLists& list = list_for(lists, lists.bodies, shape.colour.a, shape.see_through, shape.highlighted);
    std::visit(Builder(list, look_of(shape, tone), pixel_at), shape.geometry);
}

Look look_of(const Arrow& arrow, Tone tone) {
    const Colour colour = toned(arrow.colour, tone);
    if (arrow.highlighted) { return halo(colour, arrow.id); }
    return {colour, kLightRim, with_alpha(toned(palette::kPaper, tone), colour.a), arrow.id};
}

void add_arrow(DrawLists& lists, const Arrow& arrow, double dash_length, Tone tone, const PixelAt& pixel_at) {
    InstanceLists& list =
        list_for(lists, lists.annotations, arrow.colour.a, arrow.see_through, arrow.highlighted);
    Builder builder(list, look_of(arrow, tone), pixel_at);
    const double radius = (arrow.highlighted ? kThicker : 1.0) * arrow.radius;
    const double length = (arrow.to - arrow.from).norm();
    const double head = std::min(2.5 * radius * static_cast<double>(kConeLength), length);
    if (!arrow.dashed || length <= 2.0 * head) { return builder.arrow(arrow.from, arrow.to, radius); }
    const Vector3d neck = arrow.to - (arrow.to - arrow.from) * (head / length);
    builder.arrow(neck, arrow.to, radius);
    const std::array shaft{arrow.from, neck};
    for_each_dash(
        shaft, std::max(dash_length, 4.0 * arrow.radius), [&](const Vector3d& from, const Vector3d& to) {
            builder(Cylinder{from, to, radius});
        });
}

void add_triad(DrawLists& lists, const Triad& triad, Tone tone, const PixelAt& pixel_at) {
    InstanceLists& list = list_for(lists, lists.annotations, triad.alpha, triad.see_through);
    const auto ink = [&](const Colour& colour) { return with_alpha(toned(colour, tone), triad.alpha); };
    const Colour rim = ink(palette::kPaper);
    for (int axis = 0; axis < 3; ++axis) {
        const Colour colour = ink(palette::kAxes[static_cast<std::size_t>(axis)]);
        Builder builder(list, {colour, kLightRim, rim, triad.id}, pixel_at);
        builder.arrow(triad.pose.r, triad.pose.r + triad.length * triad.pose.A.col(axis), triad.radius);
    }
    Builder hub(list, {ink(palette::kInkSoft), kLightRim, rim, triad.id}, pixel_at);
    hub(Sphere{triad.pose.r, 1.7 * triad.radius});
}

void add_polyline(DrawLists& lists, const Polyline& line, double dash_length, Tone tone) {
    std::vector<LineSegment>& list = line.see_through ? lists.see_through_lines : lists.lines;
    const Colour colour = toned(line.colour, tone);
    const auto piece = [&](const Vector3d& from, const Vector3d& to) {
        list.push_back(
            {from.cast<float>(), to.cast<float>(), static_cast<float>(line.width), colour,
             static_cast<float>(line.id)});
    };
    std::vector<Vector3d> path = line.points;
    if (line.closed && !path.empty()) { path.push_back(path.front()); }
    if (line.dashed) { return for_each_dash(path, dash_length, piece); }
    for (std::size_t n = 1; n < path.size(); ++n) { piece(path[n - 1], path[n]); }
}

using Boxes = std::array<Eigen::AlignedBox3f, kMeshKinds>;

/// Box around the core of each mesh; a mesh with less detail is not larger.
const Boxes& core_boxes() {
    static const Boxes boxes = [] {
        Boxes made;
        for (std::size_t kind = 0; kind < kMeshKinds; ++kind) {
            for (const MeshVertex& vertex : make_mesh(static_cast<MeshKind>(kind)).vertices) {
                made[kind].extend(vertex.core.head<3>().eval());
            }
        }
        return made;
    }();
    return boxes;
}

void include(Bounds& bounds, const Instance& instance, const Eigen::AlignedBox3f& core) {
    const Eigen::Matrix<double, 3, 4> pose = instance.pose.cast<double>();
    // the inner radius is not larger than the outer one
    const Vector3d size = instance.size.head<3>().cast<double>();
    for (const auto corner :
         {Eigen::AlignedBox3f::BottomLeftFloor, Eigen::AlignedBox3f::BottomRightFloor,
          Eigen::AlignedBox3f::TopLeftFloor, Eigen::AlignedBox3f::TopRightFloor,
          Eigen::AlignedBox3f::BottomLeftCeil, Eigen::AlignedBox3f::BottomRightCeil,
          Eigen::AlignedBox3f::TopLeftCeil, Eigen::AlignedBox3f::TopRightCeil}) {
        const Vector3d local = core.corner(corner).cast<double>().cwiseProduct(size);
        bounds.include(pose.leftCols<3>() * local + pose.col(3), static_cast<double>(instance.rounding));
    }
}

template <class Do>
void for_each_solid(const DrawLists& lists, const Do& run) {
    for (const InstanceLists* const solids :
         {&lists.bodies, &lists.annotations, &lists.see_through, &lists.emphasised, &lists.ghosts}) {
        for (std::size_t number = 0; number < kMeshes; ++number) {
            for (const Instance& instance : (*solids)[number]) { run(number, instance); }
        }
    }
}

template <class Do>
void for_each_line(const DrawLists& lists, const Do& run) {
    for (const std::vector<LineSegment>* const lines : {&lists.lines, &lists.see_through_lines}) {
        for (const LineSegment& line : *lines) { run(line); }
    }
}

}  // namespace

DrawLists draw_lists_of(const Scene& scene, double dash_length, Tone tone, const PixelAt& pixel_at) {
    DrawLists lists;
    for (const Shape& shape : scene.shapes) { add_shape(lists, shape, tone, pixel_at); }
    for (const Arrow& arrow : scene.arrows) { add_arrow(lists, arrow, dash_length, tone, pixel_at); }
    for (const Triad& triad : scene.triads) { add_triad(lists, triad, tone, pixel_at); }
    for (const Polyline& line : scene.polylines) { add_polyline(lists, line, dash_length, tone); }
    return lists;
}

Bounds bounds_of(const DrawLists& lists) {
    Bounds bounds;
    for_each_solid(lists, [&](std::size_t number, const Instance& instance) {
        include(bounds, instance, core_boxes()[number / kDetails]);
    });
    for_each_line(lists, [&](const LineSegment& line) {
        bounds.include(line.from.cast<double>());
        bounds.include(line.to.cast<double>());
    });
    return bounds;
}

float border_of(const DrawLists& lists) {
    float most = 0.0F;
    for_each_solid(
        lists, [&](std::size_t, const Instance& instance) { most = std::max(most, instance.edge_width); });
    for_each_line(lists, [&](const LineSegment& line) { most = std::max(most, 0.5F * line.width); });
    return most;
}

}  // namespace jw::render
