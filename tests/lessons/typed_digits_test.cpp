#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <numbers>

#include <Eigen/Geometry>

#include "core/kinematics/motion_tracker.hpp"
#include "core/poses/position.hpp"
#include "core/poses/rank.hpp"
#include "tests/lessons/support.hpp"
#include "tests/support/random_mechanisms.hpp"

/// Overconstrained linkages as they are typed: with a few digits.
namespace jw {

using test::lesson_of;
using test::Random;

namespace {

/// A number as it is printed with so many digits, significant ones or decimals, without zeros at the end.
std::string typed(double x, int digits, bool decimals) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), decimals ? "%.*f" : "%.*g", digits, x);
    std::string out = text.data();
    if (decimals) {
        while (out.ends_with('0')) { out.pop_back(); }
        if (out.ends_with('.')) { out += '0'; }
    }
    return out;
}

std::string typed(const Vec3& v, int digits, bool decimals) {
    return '[' + typed(v.x(), digits, decimals) + ", " + typed(v.y(), digits, decimals) + ", " +
           typed(v.z(), digits, decimals) + ']';
}

/// Four hinges in a loop: links a, b, a, b with twists alpha, beta, alpha, beta, sin(alpha) b = sin(beta) a.
/// @source Bennett, A new mechanism, Engineering 76 (1903)
struct Bennett {
    double alpha;
    double beta;
    double a;
    double theta;  ///< angle of the first hinge at the start

    double ratio() const { return std::sin(0.5 * (beta + alpha)) / std::sin(0.5 * (beta - alpha)); }
    /// Angle of the second hinge, continuous for theta within (0, 2 pi).
    double next(double at) const {
        return 2.0 * std::atan2(ratio() * std::cos(0.5 * at), std::sin(0.5 * at));
    }
};

Bennett random_bennett(Random& random) {
    const double alpha = 0.9 + 0.4 * random.number();
    const double beta = alpha + 0.9 + 0.3 * random.number();
    return {alpha, beta, 1.2 + 0.6 * random.number(), 1.6 + random.number()};
}

/// How an author types numbers.
struct Style {
    int digits = 6;
    bool decimals = false;  ///< so many decimals, else significant digits
    bool local = false;     ///< points and axes in the frames of the bodies, else in that of the ground
    std::string head;       ///< what else stands in the lesson
    double off = 0.0;       ///< by which a point is beside its axis [m]

    std::string number(double x) const { return typed(x, digits, decimals); }
    std::string vector(const Vec3& v) const { return typed(v, digits, decimals); }
};

struct Hinge {
    Eigen::Isometry3d before;  ///< frame at the end of the link before, z along the axis
    Eigen::Isometry3d after;   ///< the same, turned by the hinge's angle: frame of the link behind
    Vec3 at;                   ///< a point of the axis
};

std::array<Hinge, 4> hinges_of(const Bennett& b, Random& random) {
    const double phi = b.next(b.theta);
    const double pi = std::numbers::pi;
    const std::array<double, 4> angles{b.theta, phi, 2.0 * pi - b.theta, 2.0 * pi - phi};
    const double length = b.a * std::sin(b.beta) / std::sin(b.alpha);
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
    frame.linear() = rotation_matrix(random.unit_p());
    frame.translation() = random.vector();
    std::array<Hinge, 4> hinges;
    for (std::size_t k = 0; k < 4; ++k) {
        hinges[k].at = frame.translation() + 0.3 * random.number() * frame.linear().col(2);
        hinges[k].before = frame;
        frame.rotate(Eigen::AngleAxisd(angles[k], Vec3::UnitZ()));
        hinges[k].after = frame;
        frame.translate(Vec3(k % 2 == 0 ? b.a : length, 0.0, 0.0));
        frame.rotate(Eigen::AngleAxisd(k % 2 == 0 ? b.alpha : b.beta, Vec3::UnitX()));
    }
    return hinges;
}

/// A lesson with the linkage laid anywhere, driven over a turn.
std::string lesson_text(const Bennett& b, Random& random, const Style& style) {
    const std::array<Hinge, 4> hinges = hinges_of(b, random);
    const std::array<const char*, 5> names{"ground", "one", "two", "three", "ground"};
    std::string text = "format = 1\ntitle = \"t\"\n" + style.head;
    // frame of each body: that of the hinge before its link, or that of the ground
    std::array<Eigen::Isometry3d, 5> frames;
    frames.fill(Eigen::Isometry3d::Identity());
    for (std::size_t k = 1; k <= 3; ++k) {
        text += "[[body]]\nname = \"" + std::string(names[k]) + "\"\n";
        if (!style.local) { continue; }
        frames[k] = hinges[k - 1].after;
        const Eigen::Quaterniond q(frames[k].linear());
        text += "position = " + style.vector(frames[k].translation()) + "\np = [" + style.number(q.w()) +
                ", " + style.number(q.x()) + ", " + style.number(q.y()) + ", " + style.number(q.z()) + "]\n";
    }
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec3 axis = hinges[k].before.linear().col(2);
        Vec3 at = hinges[k].at;
        if (k == 2) { at += style.off * perpendicular_to(axis); }
        text += "[[joint]]\nname = \"h" + std::to_string(k) + "\"\ntype = \"revolute\"\nbodies = [\"" +
                names[k] + "\", \"" + names[k + 1] + "\"]\n";
        if (style.local) {
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
           "polynomial_deg = [0, 360]\n";
}

/// Largest half unit of the last decimals of each vector that follows `key`.
std::vector<double> half_units(const std::string& text, const std::string& key) {
    std::vector<double> all;
    for (std::size_t at = text.find(key); at != std::string::npos; at = text.find(key, at + 1)) {
        double largest = 0.0;
        std::size_t decimals = 0;
        bool is_behind_point = false;
        for (std::size_t k = at + key.size(); text[k - 1] != ']'; ++k) {
            if (text[k] == '.') { is_behind_point = true; }
            if (std::isdigit(static_cast<unsigned char>(text[k])) != 0) {
                decimals += is_behind_point ? 1U : 0U;
            } else if (text[k] == ',' || text[k] == ']') {
                largest = std::max(largest, 0.5 * std::pow(10.0, -static_cast<double>(decimals)));
                decimals = 0;
                is_behind_point = false;
            }
        }
        all.push_back(largest);
    }
    return all;
}

RankReport rank_of_joints(const Mechanism& mechanism, const State& state) {
    Selection joints = everything(mechanism);
    joints.drivers.clear();
    System system(mechanism, joints);
    system.choose_rows(state);
    Assembler<OmegaLocal> assembler(system);
    assembler.assemble_phi_and_jacobian(state, 0.0);
    return analyse_rank(system, assembler.jacobian(), assembler.phi());
}

State assembled(const Mechanism& mechanism) {
    State state = start_state(mechanism);
    REQUIRE(solve_position<OmegaLocal>(System(mechanism, everything(mechanism)), state, 0.0).ok());
    return state;
}

/// Largest error of the second hinge's angle over a turn of the first.
double error_over_a_turn(const Bennett& b, const Mechanism& mechanism, const State& start) {
    System system(mechanism, everything(mechanism));
    MotionTracker tracker(system, start, 0.0);
    const double first = relative_angle(mechanism.joints[1], start);
    double error = 0.0;
    for (int k = 1; k <= 60; ++k) {
        const double t = k / 60.0;
        REQUIRE(tracker.advance_to(t));
        const MotionFrame& frame = tracker.frame();
        CHECK(frame.velocity_verdict.unique);
        CHECK(frame.velocity_verdict.consistent);
        CHECK_FALSE(frame.change_point);
        const double theta = b.theta + 2.0 * std::numbers::pi * t;
        const double turned = b.next(b.theta) - b.next(theta);
        const double found = relative_angle(mechanism.joints[1], frame.state) - first;
        error = std::max(error, std::abs(std::remainder(found + turned, 2.0 * std::numbers::pi)));
        if (k % 20 == 0) { CHECK(rank_of_joints(mechanism, frame.state).rank == 17); }
    }
    return error;
}

}  // namespace

TEST_CASE("A Bennett linkage typed with five digits or more turns like the exact one", "[lessons][typed]") {
    const int digits = GENERATE(range(5, 13));
    const Style style = GENERATE(
        Style{6, false, false, {}, 0.0}, Style{6, true, false, {}, 0.0}, Style{6, false, true, {}, 0.0});
    for (unsigned seed = 1; seed <= 4; ++seed) {
        CAPTURE(digits, style.decimals, style.local, seed);
        Random random(seed);
        const Bennett bennett = random_bennett(random);
        Style with_digits = style;
        with_digits.digits = digits;
        const Lesson lesson = lesson_of(lesson_text(bennett, random, with_digits));
        const State start = assembled(lesson.mechanism);
        CHECK(rank_of_joints(lesson.mechanism, start).rank == 17);
        // numbers of size 1, wrong by half a unit: the angle by some tens of these
        CHECK(error_over_a_turn(bennett, lesson.mechanism, start) < 50.0 * std::pow(10.0, -digits));
    }
}

TEST_CASE(
    "Numbers of the mechanism that was meant are within half a unit of the typed ones", "[lessons][typed]") {
    constexpr int kDecimals = 6;
    for (unsigned seed = 1; seed <= 6; ++seed) {
        CAPTURE(seed);
        const auto text = [&](const std::string& head) {
            Random random(seed);
            const Bennett bennett = random_bennett(random);
            return lesson_text(bennett, random, {kDecimals, true, false, head, 0.0});
        };
        const Mechanism meant = lesson_of(text("")).mechanism;
        const Mechanism as_typed = lesson_of(text("[precision]\nexact = true\n")).mechanism;
        REQUIRE(meant.typed);
        CHECK(meant.typed->is_told);
        CHECK(meant.typed->share <= 1.0);
        const std::vector<double> points = half_units(text(""), "at = [");
        const std::vector<double> axes = half_units(text(""), "axis = [");
        // bodies stand in the frame of the ground: numbers of joints are those of the file
        double largest_share = 0.0;
        for (std::size_t k = 0; k < meant.joints.size(); ++k) {
            const JointGeometry& a = meant.joints[k].geometry;
            const JointGeometry& b = as_typed.joints[k].geometry;
            largest_share = std::max(
                {largest_share, (a.P_i_local - b.P_i_local).cwiseAbs().maxCoeff() / points[k],
                 (a.s_i_local - b.s_i_local).cwiseAbs().maxCoeff() / axes[k]});
        }
        // an axis keeps its length: its numbers have changed by more than the part across it
        CHECK(largest_share <= 1.001 * meant.typed->share);
        CHECK(largest_share > 0.3 * meant.typed->share);

        // the misfit, at poses of the motion that was found by another way
        System system(meant, everything(meant));
        MotionTracker tracker(system, assembled(meant), 0.0);
        double largest = 0.0;
        for (int k = 1; k <= 40; ++k) {
            REQUIRE(tracker.advance_to(k / 40.0));
            Selection joints = everything(as_typed);
            joints.drivers.clear();
            const System typed_system(as_typed, joints);
            Assembler<OmegaLocal> assembler(typed_system);
            assembler.assemble_phi_and_jacobian(tracker.frame().state, 0.0);
            largest = std::max(largest, assembler.phi().cwiseAbs().maxCoeff());
        }
        CHECK(meant.typed->misfit < 2.0 * largest);
        CHECK(meant.typed->misfit > 0.02 * largest);
    }
}

TEST_CASE("A loop that no rounding explains keeps the rank of its numbers", "[lessons][typed]") {
    const int digits = GENERATE(5, 6, 8);
    for (unsigned seed = 1; seed <= 6; ++seed) {
        CAPTURE(digits, seed);
        Random random(seed);
        const Bennett bennett = random_bennett(random);
        const Style style{digits, true, false, {}, 500.0 * std::pow(10.0, -digits)};
        const Lesson lesson = lesson_of(lesson_text(bennett, random, style));
        CHECK_FALSE(lesson.mechanism.typed);
        CHECK(rank_of_joints(lesson.mechanism, start_state(lesson.mechanism)).rank == 18);
    }
}

TEST_CASE("[precision] says from which digit on numbers are rounded, or that none is", "[lessons][typed]") {
    const auto rank = [](int digits, const std::string& head) {
        Random random(3);
        const Bennett bennett = random_bennett(random);
        const Lesson lesson = lesson_of(lesson_text(bennett, random, {digits, true, false, head, 0.0}));
        return rank_of_joints(lesson.mechanism, start_state(lesson.mechanism)).rank;
    };
    CHECK(rank(6, "") == 17);
    CHECK(rank(6, "[precision]\nexact = true\n") == 18);
    CHECK(rank(6, "[precision]\ndigits = 9\n") == 18);
    CHECK(rank(4, "") == 18);
    CHECK(rank(4, "[precision]\ndigits = 4\n") == 17);
}

}  // namespace jw
