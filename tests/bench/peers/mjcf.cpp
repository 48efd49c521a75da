#include "tests/bench/peers/mjcf.hpp"

#include <cstdio>
#include <sstream>

namespace jw::peers {
namespace {

std::string text(const Vec3& v) {
    char out[100];
    std::snprintf(out, sizeof out, "\"%.17g %.17g %.17g\"", v.x(), v.y(), v.z());
    return out;
}

/// Unit vector along the axis of a letter.
Vec3 along(char letter) { return Vec3::Unit(letter - 'x'); }

void write_joint(std::ostream& out, const PeerScene& scene, const PeerJoint& joint, std::string_view hinges) {
    const Vec3 point = joint.kind == Kind::free ? Vec3::Zero() : from_centre(scene, joint.child, joint.point);
    const std::string pos = " pos=" + text(point);
    const std::string one = pos + " axis=" + text(joint.axis_parent) + "/>";
    const auto write_along = [&](const char* type, std::string_view axes) {
        for (const char axis : axes) {
            out << "<joint type='" << type << "'" << pos << " axis=" << text(along(axis)) << "/>";
        }
    };
    switch (joint.kind) {
        case Kind::revolute: out << "<joint type='hinge'" << one; break;
        case Kind::prismatic: out << "<joint type='slide'" << one; break;
        case Kind::cylindrical: out << "<joint type='slide'" << one << "<joint type='hinge'" << one; break;
        case Kind::universal:
            out << "<joint type='hinge'" << one << "<joint type='hinge'" << pos
                << " axis=" << text(joint.axis_child) << "/>";
            break;
        case Kind::spherical:
            if (hinges.empty()) { out << "<joint type='ball'" << pos << "/>"; }
            write_along("hinge", hinges);
            break;
        case Kind::fixed: break;
        case Kind::free:
            if (hinges.empty()) { out << "<freejoint/>"; }
            if (!hinges.empty()) { write_along("slide", "xyz"); }
            write_along("hinge", hinges);
            break;
    }
}

void write_sites(std::ostream& out, const PeerScene& scene, int body) {
    for (std::size_t k = 0; k < scene.springs.size(); ++k) {
        const PeerSpring& s = scene.springs[k];
        if (s.body_i == body) { out << "<site name='i" << k << "' pos=" << text(s.P_i) << "/>"; }
        if (s.body_j == body) { out << "<site name='j" << k << "' pos=" << text(s.P_j) << "/>"; }
    }
}

void write_children(std::ostream& out, const PeerScene& scene, int parent, std::string_view hinges) {
    for (const PeerJoint& joint : scene.tree) {
        if (joint.parent != parent) { continue; }
        const PeerBody& body = scene.bodies[static_cast<std::size_t>(joint.child)];
        const Mat3& J = body.J;
        out << "<body name='" << name_of(joint.child) << "' pos=" << text(from_centre(scene, parent, body.r))
            << "><inertial pos='0 0 0' mass='" << body.mass << "' fullinertia='" << J(0, 0) << ' ' << J(1, 1)
            << ' ' << J(2, 2) << ' ' << J(0, 1) << ' ' << J(0, 2) << ' ' << J(1, 2) << "'/>";
        write_joint(out, scene, joint, hinges);
        write_sites(out, scene, joint.child);
        write_children(out, scene, joint.child, hinges);
        out << "</body>\n";
    }
}

void write_connect(std::ostream& out, const PeerScene& scene, const PeerJoint& joint, const Vec3& point) {
    out << "<connect body1='" << name_of(joint.parent) << "' body2='" << name_of(joint.child)
        << "' anchor=" << text(from_centre(scene, joint.parent, point)) << "/>\n";
}

}  // namespace

std::string name_of(int body) { return body == 0 ? "world" : "b" + std::to_string(body); }

std::string mjcf(const PeerScene& scene, std::string_view hinges) {
    std::ostringstream out;
    out.precision(17);
    out << "<mujoco><compiler angle='radian'/><option gravity=" << text(scene.gravity)
        << " tolerance='1e-14' iterations='100'><flag contact='disable'/></option>\n<size njmax='"
        << 50 + 6 * scene.loops.size() << "' nconmax='0'/>\n<worldbody>";
    write_sites(out, scene, 0);
    write_children(out, scene, 0, hinges);
    out << "</worldbody>\n<equality>";
    for (const PeerLoop& loop : scene.loops) {
        write_connect(out, scene, loop.joint, loop.joint.point);
        // two points hold an axis
        if (!loop.point_is_enough) {
            write_connect(out, scene, loop.joint, loop.joint.point + loop.joint.axis_parent);
        }
    }
    out << "</equality>\n<tendon>";
    for (std::size_t k = 0; k < scene.springs.size(); ++k) {
        const PeerSpring& s = scene.springs[k];
        out << "<spatial stiffness='" << s.stiffness << "' damping='" << s.damping << "' springlength='"
            << s.free_length << "'><site site='i" << k << "'/><site site='j" << k << "'/></spatial>\n";
    }
    out << "</tendon></mujoco>\n";
    return out.str();
}

std::vector<double> rates_of(const PeerScene& scene, const PeerJoint& joint, std::string_view hinges) {
    const PeerBody& child = scene.bodies[static_cast<std::size_t>(joint.child)];
    const PeerBody& parent = scene.bodies[static_cast<std::size_t>(joint.parent)];
    const Vec3 omega = child.omega - parent.omega;
    const Vec3 v =
        velocity_at(scene, joint.child, joint.point) - velocity_at(scene, joint.parent, joint.point);
    switch (joint.kind) {
        case Kind::revolute: return {joint.axis_parent.dot(omega)};
        case Kind::prismatic: return {joint.axis_parent.dot(v)};
        case Kind::cylindrical: return {joint.axis_parent.dot(v), joint.axis_parent.dot(omega)};
        case Kind::universal: return {joint.axis_parent.dot(omega), joint.axis_child.dot(omega)};
        case Kind::fixed: return {};
        case Kind::spherical:
        case Kind::free: break;
    }
    std::vector<double> rates;
    if (joint.kind == Kind::free) { rates = {child.v.x(), child.v.y(), child.v.z()}; }
    for (const char axis : hinges.empty() ? "xyz" : hinges) { rates.push_back(along(axis).dot(omega)); }
    return rates;
}

}  // namespace jw::peers
