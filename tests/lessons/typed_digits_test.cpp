#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "core/kinematics/motion_tracker.hpp"
#include "core/poses/position.hpp"
#include "tests/lessons/support.hpp"
#include "tests/lessons/typed_lesson.hpp"

/// Overconstrained linkages as they are typed: with a few digits.
namespace jw {

using test::Bennett;
using test::lesson_of;
using test::Random;
using test::random_bennett;
using test::rank_of_joints;
using test::Style;

namespace {

std::string lesson_text(const Bennett& bennett, Random& random, const Style& style) {
    return test::lesson_text(test::bennett_loop(bennett, random), style);
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
    const Style style = GENERATE(Style{}, Style{.decimals = true}, Style{.local = true});
    for (unsigned seed = 1; seed <= 4; ++seed) {
        CAPTURE(digits, style.decimals, style.local, seed);
        Random random(seed);
        const Bennett bennett = random_bennett(random);
        Style with_digits = style;
        with_digits.digits = digits;
        const Lesson lesson = lesson_of(lesson_text(bennett, random, with_digits));
        const State start = assembled(lesson.mechanism);
        CHECK(rank_of_joints(lesson.mechanism, start).rank == 17);
        // numbers of size 1 are wrong by half a unit of the last digit, the angle by some tens of these
        CHECK(error_over_a_turn(bennett, lesson.mechanism, start) < 50.0 * std::pow(10.0, -digits));
    }
}

TEST_CASE("Poses that were typed with five digits or more decide no rank", "[lessons][typed]") {
    // points and axes are given in the frames of bodies and in that of the ground: poses decide if they fit
    const int digits = GENERATE(5, 6, 8);
    const std::string_view pose = GENERATE("p", "rotation", "axes");
    int warned = 0;
    for (unsigned seed = 1; seed <= 3; ++seed) {
        CAPTURE(digits, pose, seed);
        Random random(seed);
        const Bennett bennett = random_bennett(random);
        // an angle without its last zero would claim fewer digits
        const Style style{.digits = 15, .mixed = true, .pose_digits = digits, .pose = pose, .zeros = true};
        const ReadResult read = read_lesson(lesson_text(bennett, random, style), "test.toml");
        REQUIRE(read.lesson);
        const Lesson& lesson = *read.lesson;
        for (const Diagnostic& warning : read.diagnostics) {
            ++warned;
            // "poses of bodies", or a key "of body" that decides alone
            CHECK(warning.hint.find(" of bod") != std::string::npos);
        }
        REQUIRE(lesson.mechanism.typed);
        CHECK(lesson.mechanism.typed->is_told);
        CHECK(lesson.mechanism.typed->share > 1e-3);
        const State start = assembled(lesson.mechanism);
        CHECK(rank_of_joints(lesson.mechanism, start).rank == 17);
        // as for points and axes
        CHECK(error_over_a_turn(bennett, lesson.mechanism, start) < 50.0 * std::pow(10.0, -digits));
    }
    // a rank that is right as typed needs no warning
    CHECK(warned > 0);
}

TEST_CASE("Axes of bodies tell the same whatever length they are typed with", "[lessons][typed]") {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        CAPTURE(seed);
        const auto typed_with = [&](double length) {
            Random random(seed);
            const Bennett bennett = random_bennett(random);
            const Style style{
                .digits = 15, .mixed = true, .pose_digits = 6, .pose = "axes", .axes_length = length};
            return lesson_of(lesson_text(bennett, random, style)).mechanism.typed;
        };
        const auto unit = typed_with(1.0);
        const auto longer = typed_with(1000.0);
        REQUIRE(unit);
        REQUIRE(longer);
        CHECK(longer->is_told);
        // the same digits; directions of unit length are used without being rounded once more
        CHECK(longer->share == Approx(unit->share).epsilon(1e-4));
    }
}

TEST_CASE("Sides computed from poses do not affect the rank", "[lessons][typed]") {
    // all that is typed of the slides is in the frames of bodies: the third closes to the digits of p only;
    // sides follow the poses to first order, the digits of the axes take the rest
    for (unsigned seed = 1; seed <= 3; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Mat3 plane = rotation_matrix(random.unit_p());
        const Style style{.digits = 8, .pose_digits = 6};
        const std::array<std::string, 3> names{"ground", "b1", "b2"};
        std::array<Eigen::Isometry3d, 3> frames;
        frames.fill(Eigen::Isometry3d::Identity());
        std::string text = "format = 1\ntitle = \"t\"\n";
        for (std::size_t b = 1; b < 3; ++b) {
            frames[b].linear() = rotation_matrix(random.unit_p());
            frames[b].translation() = random.vector();
            text += "[[body]]\nname = \"" + names[b] + "\"\n" + test::pose_text(frames[b], style);
        }
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            const double angle = 0.3 + 1.1 * static_cast<double>(i);
            const Vec3 axis = plane * Vec3(std::cos(angle), std::sin(angle), 0.0);
            const Vec3 at = random.vector();
            text += "[[joint]]\nname = \"slide" + names[i] + "\"\ntype = \"prismatic\"\nbodies = [\"" +
                    names[i] + "\", \"" + names[j] +
                    "\"]\npoint_i = " + style.vector(frames[i].inverse() * at) +
                    "\npoint_j = " + style.vector(frames[j].inverse() * at) +
                    "\naxis_i = " + style.vector(frames[i].linear().transpose() * axis) +
                    "\naxis_j = " + style.vector(frames[j].linear().transpose() * axis) + '\n';
        }
        const Mechanism meant = lesson_of(text).mechanism;
        REQUIRE(meant.typed);
        CHECK(meant.typed->is_told);
        CHECK(rank_of_joints(meant, assembled(meant)).rank == 11);
    }
}

TEST_CASE("A fixed body that was typed with five digits or more decides no rank", "[lessons][typed]") {
    const int digits = GENERATE(5, 7);
    for (unsigned seed = 1; seed <= 4; ++seed) {
        CAPTURE(digits, seed);
        Random random(seed);
        const Bennett bennett = random_bennett(random);
        const test::HingeLoop loop = test::bennett_loop(bennett, random);
        std::string text = test::lesson_text(loop, {.digits = 15, .local = true, .zeros = true});
        // the last hinge is on a post of its own, at its origin
        const auto replace = [&](const std::string& key, const std::string& end, const std::string& by) {
            const std::size_t at = text.find(key, text.find("name = \"h3\""));
            text.replace(at, text.find(end, at) - at, by);
        };
        replace("\"ground\"", "]", "\"post\"");
        replace("point_j", "\n", "point_j = [0, 0, 0]");
        replace("axis_j", "\n", "axis_j = [0, 0, 1]");
        Eigen::Isometry3d frame = loop.hinges[3].frame;
        frame.translation() = loop.hinges[3].at;
        const std::string post = "[[body]]\nname = \"post\"\nfixed = true\n" +
                                 test::pose_text(frame, {.pose_digits = digits, .zeros = true});
        text.insert(text.find("[[joint]]"), post);
        const Mechanism meant = lesson_of(text).mechanism;
        REQUIRE(meant.typed);
        CHECK(meant.typed->is_told);
        CHECK(meant.typed->rank_as_typed == 18);
        const State start = assembled(meant);
        CHECK(rank_of_joints(meant, start).rank == 17);
        CHECK(error_over_a_turn(bennett, meant, start) < 50.0 * std::pow(10.0, -digits));
    }
}

TEST_CASE(
    "Numbers of the mechanism that was meant are within half a unit of the typed ones", "[lessons][typed]") {
    constexpr int kDecimals = 6;
    for (unsigned seed = 1; seed <= 6; ++seed) {
        CAPTURE(seed);
        const auto read = [&](const std::string& head) {
            Random random(seed);
            const Bennett bennett = random_bennett(random);
            // a number without its last zeros would claim fewer digits
            return lesson_of(lesson_text(
                bennett, random, {.digits = kDecimals, .decimals = true, .head = head, .zeros = true}));
        };
        const Mechanism meant = read("").mechanism;
        const Mechanism as_typed = read("[precision]\nexact = true\n").mechanism;
        REQUIRE(meant.typed);
        CHECK(meant.typed->is_told);
        // bodies stand in the frame of the ground: numbers of joints are those of the file
        double change = 0.0;
        for (std::size_t k = 0; k < meant.joints.size(); ++k) {
            const JointGeometry& a = meant.joints[k].geometry;
            const JointGeometry& b = as_typed.joints[k].geometry;
            change = std::max(
                {change, (a.P_i_local - b.P_i_local).cwiseAbs().maxCoeff(),
                 (a.s_i_local - b.s_i_local).cwiseAbs().maxCoeff()});
        }
        const double half_unit = 0.5 * std::pow(10.0, -kDecimals);
        CHECK(meant.typed->share <= 1.0);
        // rounding of unit vectors; a change along an axis does not change it
        CHECK(change <= 1.001 * meant.typed->share * half_unit);
        CHECK(change > 0.3 * meant.typed->share * half_unit);

        // the misfit, at poses of the motion that was found by another method
        System system(meant, everything(meant));
        MotionTracker tracker(system, assembled(meant), 0.0);
        double largest = 0.0;
        for (int k = 1; k <= 40; ++k) {
            REQUIRE(tracker.advance_to(k / 40.0));
            const System typed_system(as_typed, joints_of(as_typed));
            Assembler<OmegaLocal> assembler(typed_system);
            assembler.assemble_phi_and_jacobian(tracker.frame().state, 0.0);
            largest = std::max(largest, assembler.phi().cwiseAbs().maxCoeff());
        }
        CHECK(meant.typed->misfit < 2.0 * largest);
        CHECK(meant.typed->misfit > 0.02 * largest);
    }
}

TEST_CASE("A single number with too few digits is named, with its place", "[lessons][typed]") {
    constexpr std::size_t kNumbers = 24;  // of four points and four axes
    int named = 0;
    for (unsigned seed = 1; seed <= kNumbers; ++seed) {
        Random random(seed);
        const Bennett bennett = random_bennett(random);
        std::string text = lesson_text(bennett, random, {.digits = 10, .zeros = true});
        // one of them loses four digits
        std::size_t from = 0;
        for (std::size_t k = 0; k < seed; ++k) { from = text.find('.', from + 1); }
        from = text.find_last_of("[ ", from) + 1;
        const std::size_t to = text.find_first_of(",]", from);
        std::array<char, 40> typed{};
        std::snprintf(typed.data(), typed.size(), "%#.6g", std::strtod(text.c_str() + from, nullptr));
        text.replace(from, to - from, typed.data());

        const ReadResult read = read_lesson(text, "test.toml");
        CAPTURE(seed, typed.data(), read.report());
        // if the number hardly matters, the others decide, and they fit
        REQUIRE(read.diagnostics.size() <= 1);
        if (read.diagnostics.empty()) { continue; }
        const Diagnostic& warning = read.diagnostics.front();
        ++named;
        CHECK(warning.hint.find(std::string("give ") + typed.data() + " in '") == 0);
        CHECK(
            warning.span.line == std::count(text.begin(), text.begin() + static_cast<long>(from), '\n') + 1);
        CHECK(warning.span.length == static_cast<int>(std::string(typed.data()).size()));
    }
    CHECK(named > 20);
}

TEST_CASE("A loop that no rounding explains keeps the rank of its numbers", "[lessons][typed]") {
    const int digits = GENERATE(5, 6, 8);
    const bool mixed = GENERATE(false, true);
    for (unsigned seed = 1; seed <= 6; ++seed) {
        CAPTURE(digits, mixed, seed);
        Random random(seed);
        const Bennett bennett = random_bennett(random);
        const Style style{
            .digits = digits, .decimals = true, .mixed = mixed, .off = 500.0 * std::pow(10.0, -digits)};
        const Lesson lesson = lesson_of(lesson_text(bennett, random, style));
        CHECK_FALSE(lesson.mechanism.typed);
        // at a start that is not assembled the residual may hide it
        if (mixed) { continue; }
        CHECK(rank_of_joints(lesson.mechanism, start_state(lesson.mechanism)).rank == 18);
    }
}

TEST_CASE("[precision] says from which digit on numbers are rounded, or that none is", "[lessons][typed]") {
    const auto rank = [](int digits, const std::string& head) {
        Random random(3);
        const Bennett bennett = random_bennett(random);
        const Lesson lesson =
            lesson_of(lesson_text(bennett, random, {.digits = digits, .decimals = true, .head = head}));
        return rank_of_joints(lesson.mechanism, start_state(lesson.mechanism)).rank;
    };
    CHECK(rank(6, "") == 17);
    CHECK(rank(6, "[precision]\nexact = true\n") == 18);
    CHECK(rank(6, "[precision]\ndigits = 9\n") == 18);
    CHECK(rank(4, "") == 18);
    CHECK(rank(4, "[precision]\ndigits = 4\n") == 17);
}

}  // namespace jw
