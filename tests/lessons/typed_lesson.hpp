#pragma once

#include <array>
#include <cstdio>
#include <string>
#include <string_view>

#include "core/equations/assembler.hpp"
#include "core/poses/large_rank.hpp"
#include "core/poses/typed/loose_motion.hpp"
#include "tests/support/overconstrained_linkages.hpp"

/// Lessons of overconstrained linkages, with numbers as somebody types them.
namespace jw::test {

/// How an author types numbers.
struct Style {
    int digits = 6;
    bool decimals = false;        ///< `digits` are decimals, else significant digits
    bool local = false;           ///< points and axes in the frames of the bodies, else in that of the ground
    bool mixed = false;           ///< every other hinge in these frames
    int pose_digits = 0;          ///< digits of poses, if they differ from those of joints
    std::string_view pose = "p";  ///< how bodies are turned: p, rotation or axes
    double axes_length = 1.0;     ///< of the axes of bodies, which mean directions
    std::string head = {};        ///< other text at the head of the lesson
    double off = 0.0;             ///< distance of a point from its axis [m]
    bool zeros = false;           ///< numbers keep the zeros at their end
    std::string body = {};        ///< other keys of each body
    std::string base = "ground";  ///< the link between the last hinge and the first

    std::string number(double x) const {
        std::array<char, 40> text{};
        std::snprintf(text.data(), text.size(), decimals ? "%.*f" : zeros ? "%#.*g" : "%.*g", digits, x);
        std::string out = text.data();
        if (decimals && !zeros) {
            while (out.ends_with('0')) { out.pop_back(); }
            if (out.ends_with('.')) { out += '0'; }
        }
        return out;
    }
    std::string vector(const Vec3& v) const {
        return '[' + number(v.x()) + ", " + number(v.y()) + ", " + number(v.z()) + ']';
    }
};

/// Keys for the pose of a body.
inline std::string pose_text(const Eigen::Isometry3d& frame, Style style) {
    if (style.pose_digits > 0) { style.digits = style.pose_digits; }
    const Mat3 A = frame.linear();
    const std::string position = "position = " + style.vector(frame.translation());
    if (style.pose == "axes") {
        return position + "\naxes = { x = " + style.vector(style.axes_length * A.col(0)) +
               ", y = " + style.vector(style.axes_length * A.col(1)) + " }\n";
    }
    if (style.pose == "rotation") {
        const Eigen::AngleAxisd turn(A);
        return position + "\nrotation = { axis = " + style.vector(turn.axis()) +
               ", angle_deg = " + style.number(turn.angle() * 180.0 / detail::kPi) + " }\n";
    }
    const Eigen::Quaterniond q(A);
    return position + "\np = [" + style.number(q.w()) + ", " + style.number(q.x()) + ", " +
           style.number(q.y()) + ", " + style.number(q.z()) + "]\n";
}

/// Chain of bodies c1, c2..., connected by hinges anywhere. @param to body that hangs from the last one, or
/// none
inline std::string chain_text(
    const std::string& from, const std::string& to, int count, Random& random, const Style& style) {
    std::string text;
    const auto name_of = [&](int k) { return k == 0 ? from : k > count ? to : "c" + std::to_string(k); };
    for (int k = 1; k <= count; ++k) { text += "[[body]]\nname = \"" + name_of(k) + "\"\n"; }
    for (int k = 0; k < count + (to.empty() ? 0 : 1); ++k) {
        text += "[[joint]]\ntype = \"revolute\"\nname = \"chain" + std::to_string(k) + "\"\nbodies = [\"" +
                name_of(k) + "\", \"" + name_of(k + 1) + "\"]\nat = " + style.vector(random.vector()) +
                "\naxis = " + style.vector(random.direction()) + "\n";
    }
    return text;
}

/// A lesson with a loop whose first hinge is driven: bodies b1, b2..., joints h0, h1...
inline std::string lesson_text(const HingeLoop& loop, const Style& style) {
    const std::size_t count = loop.hinges.size();
    const auto name_of = [&](std::size_t body) {
        return body % count == 0 ? style.base : "b" + std::to_string(body);
    };
    std::string text = "format = 1\ntitle = \"t\"\n" + style.head;
    // frame of each body: that of the hinge before its link, or that of the ground
    std::vector<Eigen::Isometry3d> frames(count + 1, Eigen::Isometry3d::Identity());
    for (std::size_t k = 1; k < count; ++k) {
        text += "[[body]]\nname = \"" + name_of(k) + "\"\n" + style.body;
        if (!style.local && !style.mixed) { continue; }
        frames[k] = loop.hinges[k - 1].frame;
        text += pose_text(frames[k], style);
    }
    for (std::size_t k = 0; k < count; ++k) {
        const Vec3 axis = loop.hinges[k].frame.linear().col(2);
        Vec3 at = loop.hinges[k].at;
        if (k == 2) { at += style.off * perpendicular_to(axis); }
        text += "[[joint]]\nname = \"h" + std::to_string(k) + "\"\ntype = \"revolute\"\nbodies = [\"" +
                name_of(k) + "\", \"" + name_of(k + 1) + "\"]\n";
        if (style.local || (style.mixed && k % 2 == 1)) {
            const Eigen::Isometry3d to_i = frames[k].inverse();
            const Eigen::Isometry3d to_j = frames[k + 1].inverse();
            text += "point_i = " + style.vector(to_i * at) + "\npoint_j = " + style.vector(to_j * at) +
                    "\naxis_i = " + style.vector(to_i.linear() * axis) +
                    "\naxis_j = " + style.vector(to_j.linear() * axis) + "\n";
        } else {
            text += "at = " + style.vector(at) + "\naxis = " + style.vector(axis) + "\n";
        }
    }
    return text +
           "[[driver]]\nname = \"motor\"\njoint = \"h0\"\nquantity = \"angle\"\n"
           "polynomial_deg = [0, " +
           std::to_string(loop.turn_deg) + "]\n";
}

/// Rank of the joints alone at the assembled start, as all parts of the program report it.
inline RankReport rank_of_joints(const Mechanism& mechanism, State state) {
    System system(mechanism, joints_of(mechanism));
    system.choose_rows(state);
    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(state, 0.0);
    return analyse_rank_of_any_size(system, assembler.sparse_jacobian(), assembler.phi(), false);
}

}  // namespace jw::test
