#include "tests/app/host/picture_values.hpp"

#include <sstream>

#include "core/numerics/variants.hpp"

namespace jw::test {

namespace {

using render::Vector3d;

struct Values {
    std::ostringstream out;

    Values() { out << std::hexfloat; }
    void add(double x) { out << x << ' '; }
    void add(const Vector3d& v) { out << v.x() << ' ' << v.y() << ' ' << v.z() << ' '; }
    void add(const render::Pose& pose) {
        for (int k = 0; k < 3; ++k) { add(Vector3d(pose.A.col(k))); }
        add(pose.r);
    }
    template <class... T>
    void line(const T&... values) {
        (add(values), ...);
        out << '\n';
    }
};

void add(Values& values, const render::Geometry& geometry) {
    std::visit(
        Overloaded{
            [&](const render::Box& s) { values.line(s.pose, s.half_size); },
            [&](const render::Sphere& s) { values.line(s.centre, s.radius); },
            [&](const render::Cylinder& s) { values.line(s.from, s.to, s.radius); },
            [&](const render::Rod& s) { values.line(s.from, s.to, s.radius); },
            [&](const render::Tube& s) { values.line(s.from, s.to, s.outer_radius, s.inner_radius); },
            [&](const render::Ring& s) { values.line(s.centre, s.axis, s.radius, s.wire_radius); },
            [&](const render::Screw& s) { values.line(s.from, s.to, s.side, s.radius, s.pitch); },
            [&](const render::Nut& s) { values.line(s.from, s.to, s.side, s.corner_radius, s.hole_radius); },
        },
        geometry);
}

}  // namespace

std::string values_of(const Picture& picture) {
    Values values;
    for (const render::Shape& shape : picture.scene.shapes) {
        add(values, shape.geometry);
        values.out << shape.id << shape.highlighted << '\n';
    }
    for (const render::Arrow& a : picture.scene.arrows) { values.line(a.from, a.to, a.radius); }
    for (const render::Triad& t : picture.scene.triads) { values.line(t.pose, t.length); }
    for (const render::Polyline& p : picture.scene.polylines) {
        for (const Vector3d& v : p.points) { values.add(v); }
        values.out << '\n';
    }
    for (const Annotation& a : picture.annotations) {
        values.line(a.at, a.towards);
        values.out << a.text << '\n';
    }
    return values.out.str();
}

}  // namespace jw::test
