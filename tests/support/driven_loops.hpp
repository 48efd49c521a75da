#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "tests/support/random_mechanisms.hpp"
#include "tests/support/scene_builder.hpp"

/// Loops with one driven crank, anywhere in space, in any size and as near to folding as asked for, with the
/// branch that they stay on in closed form.
namespace jw::test {

struct DrivenLoop {
    Mechanism mechanism;
    int body = 0;                          ///< of the point that is compared
    Vec3 point_local = Vec3::Zero();       ///< [m]
    std::function<Vec3(double)> expected;  ///< that point at time t [s]; one turn takes 1 s
    double size = 1.0;                     ///< [m]
    double margin = 0.0;                   ///< least distance from folding, in sizes
    std::string name;
};

/// Frame and size in which a loop is built: x, y, z are unit and perpendicular.
struct Place {
    Vec3 origin = Vec3::Zero();
    Mat3 axes = Mat3::Identity();
    double size = 1.0;

    Vec3 at(double x, double y, double z = 0.0) const { return origin + size * (axes * Vec3(x, y, z)); }
    Vec3 along(double x, double y, double z) const { return axes * Vec3(x, y, z); }
};

inline Place random_place(Random& random) {
    Place place;
    place.size = std::pow(10.0, random.number(-3.0, 3.0));
    place.origin = place.size * random.vector(3.0);
    place.axes = rotation_matrix(random.unit_p());
    return place;
}

inline void drive(Mechanism& mechanism, int joint, double start, double sense) {
    const Joint& driven = mechanism.joints[at(joint)];
    TimeFunction function;
    function.polynomial = {start, sense * 2.0 * std::numbers::pi};
    mechanism.drivers.push_back({"motor", joint, driven.body_i, driven.body_j, angle_of(driven), function});
}

/// Solution of a cos φ + b sin φ = c that `side` chooses, along which φ is continuous as long as it exists.
inline double angle_that_meets(double a, double b, double c, double side) {
    const double square = a * a + b * b;
    return std::atan2(b, a) + side * std::atan2(std::sqrt(std::max(square - c * c, 0.0)), c);
}

/// Crank a, coupler b, rocker c on a ground d, in a plane.
struct FourBarLinks {
    double a;
    double b;
    double c;
    double d;
};

/// @param start angle of the crank [rad] @param sense of its turn @param side on which the rocker stands
inline DrivenLoop four_bar_of(
    const Place& place, const FourBarLinks& links, double margin, double start, double sense, double side) {
    const auto [a, b, c, d] = links;
    const auto meeting = [place, a = a, b = b, c = c, d = d, start, sense, side](double t) {
        const double theta = start + sense * 2.0 * std::numbers::pi * t;
        const double x = a * std::cos(theta) - d;
        const double y = a * std::sin(theta);
        const double phi = angle_that_meets(x, y, (x * x + y * y + c * c - b * b) / (2.0 * c), side);
        return place.at(d + c * std::cos(phi), c * std::sin(phi));
    };
    SceneBuilder scene;
    const Vec3 A = place.at(a * std::cos(start), a * std::sin(start));
    const Vec3 z = place.along(0, 0, 1);
    const int crank = scene.add_body("crank", place.at(0.3 * a, 0.2));
    const int coupler = scene.add_body("coupler", 0.5 * (A + meeting(0.0)));
    const int rocker = scene.add_body("rocker", place.at(d, 0.1));
    Joint& driven = scene.add_joint("revolute", 0, crank, place.at(0, 0), z);
    scene.measure_angle(driven, place.along(1, 0, 0), A - place.at(0, 0));
    scene.add_joint("revolute", crank, coupler, A, z);
    scene.add_joint("revolute", coupler, rocker, meeting(0.0), z);
    scene.add_joint("revolute", 0, rocker, place.at(d, 0), z);
    drive(scene.mechanism, 0, start, sense);
    return {scene.mechanism, coupler,   scene.local_point(coupler, meeting(0.0)), meeting, place.size,
            margin,          "four-bar"};
}

/// Links 1 - e, 2, 1, 2: the crank, in line with the ground, comes within e of folding.
inline DrivenLoop crank_near_folding(double e) {
    return four_bar_of({}, {1.0 - e, 2.0, 1.0, 2.0}, e, 1.0, 1.0, 1.0);
}

/// Random number whose logarithm is uniform.
inline double log_uniform(Random& random, double from, double to) {
    return std::exp(random.number(std::log(from), std::log(to)));
}

/// Any four-bar: near folding where b + c exceeds d + a, or |b - c| falls below d - a, by `margin` only.
inline DrivenLoop driven_four_bar(Random& random, double margin) {
    const Place place = random_place(random);
    const double d = random.number(1.5, 2.5);
    const double c = random.number(0.8, 1.4) * d / 2.0;
    const bool is_outer = random.number() > 0.0;
    // the crank turns fully if it is the shortest and a + the longest < the sum of the others
    double a = 0.0;
    double b = 0.0;
    if (is_outer) {
        b = random.number(0.9, 1.1) * d;
        a = b + c - d - margin;
    } else {
        b = c + random.number(0.3, 0.9) * (d - 0.2);
        a = d - (b - c) - margin;
    }
    // parameters that fold elsewhere as well are drawn again
    if (a < 0.1 || d + a > b + c || std::abs(b - c) > d - a ||
        (is_outer ? d - a - std::abs(b - c) : b + c - d - a) < 0.05) {
        return driven_four_bar(random, margin);
    }
    const double start = random.number(0.0, 2.0 * std::numbers::pi);
    const double sense = random.number() > 0.0 ? 1.0 : -1.0;
    const double side = random.number() > 0.0 ? 1.0 : -1.0;
    return four_bar_of(place, {a, b, c, d}, margin, start, sense, side);
}

/// Crank a, coupler b, slide along x at height e.
struct SliderCrankLinks {
    double a;
    double b;
    double e;
};

/// @param start angle of the crank [rad] @param sense of its turn @param side of the crank on which the slide
/// is
inline DrivenLoop slider_crank_of(
    const Place& place, const SliderCrankLinks& links, double margin, double start, double sense,
    double side) {
    const auto [a, b, e] = links;
    const auto meeting = [place, a = a, b = b, e = e, start, sense, side](double t) {
        const double theta = start + sense * 2.0 * std::numbers::pi * t;
        const double y = e - a * std::sin(theta);
        return place.at(a * std::cos(theta) + side * std::sqrt(std::max(b * b - y * y, 0.0)), e);
    };
    SceneBuilder scene;
    const Vec3 A = place.at(a * std::cos(start), a * std::sin(start));
    const Vec3 z = place.along(0, 0, 1);
    const int crank = scene.add_body("crank", place.at(0.2, 0.1));
    const int coupler = scene.add_body("coupler", 0.3 * A + 0.7 * meeting(0.0));
    const int slider = scene.add_body("slider", meeting(0.0));
    Joint& driven = scene.add_joint("revolute", 0, crank, place.at(0, 0), z);
    scene.measure_angle(driven, place.along(1, 0, 0), A - place.at(0, 0));
    scene.add_joint("revolute", crank, coupler, A, z);
    scene.add_joint("revolute", coupler, slider, meeting(0.0), z);
    scene.add_joint("prismatic", 0, slider, meeting(0.0), place.along(1, 0, 0));
    drive(scene.mechanism, 0, start, sense);
    return {scene.mechanism, slider,        scene.local_point(slider, meeting(0.0)), meeting, place.size,
            margin,          "slider-crank"};
}

/// Any slider-crank: near folding where b exceeds a + |e| by `margin` only.
inline DrivenLoop driven_slider_crank(Random& random, double margin) {
    const Place place = random_place(random);
    const double a = random.number(0.3, 1.5);
    const double e = random.number(-1.0, 1.0) * a;
    const double start = random.number(0.0, 2.0 * std::numbers::pi);
    const double sense = random.number() > 0.0 ? 1.0 : -1.0;
    const double side = random.number() > 0.0 ? 1.0 : -1.0;
    return slider_crank_of(place, {a, a + std::abs(e) + margin, e}, margin, start, sense, side);
}

/// Universal joint whose driven shaft is `margin` [rad] short of a quarter turn, bent by half a turn: within
/// a few margins around a right angle the other shaft turns by almost half a turn.
inline DrivenLoop bent_universal_joint(Random& random, double margin) {
    const Place place = random_place(random);
    const double alpha = 0.5 * std::numbers::pi - margin;
    const double sense = random.number() > 0.0 ? 1.0 : -1.0;
    const double arm = random.number(0.2, 0.5);
    const auto tip_point = [=](double t) {
        const double bend = sense * std::numbers::pi * t;
        const double gamma = std::atan(std::tan(alpha) * std::cos(bend));
        const double along = std::cos(gamma);
        return place.at(arm * along * std::sin(bend), -arm * std::sin(gamma), arm * along * std::cos(bend));
    };
    SceneBuilder scene;
    const Vec3 centre = place.at(0, 0);
    const int yoke = scene.add_body("yoke", place.at(-0.3, 0));
    const int arm_body = scene.add_body("arm", place.at(0.35, 0));
    const int tip = scene.add_body("tip", place.at(0.2, 0));
    const Vec3 x = place.along(1, 0, 0);
    const Vec3 y = place.along(0, 1, 0);
    // turned about x by α, from y to z
    const Vec3 yoke_arm = place.along(0, std::cos(alpha), std::sin(alpha));
    const auto prescribe = [&](int joint, double start, double rate) {
        const Joint& driven = scene.mechanism.joints[at(joint)];
        TimeFunction function;
        function.polynomial = {start, rate};
        scene.mechanism.drivers.push_back(
            {"motor", joint, driven.body_i, driven.body_j, angle_of(driven), function});
    };
    Joint& input = scene.add_joint("revolute", 0, yoke, centre, x);
    scene.measure_angle(input, y, yoke_arm);
    Joint& bend = scene.add_joint("revolute", 0, arm_body, centre, y);
    scene.measure_angle(bend, x, x);
    scene.add_joint("revolute", arm_body, tip, centre, x);
    scene.add_universal(yoke, tip, centre, yoke_arm, tip_point(0.0) - centre);
    prescribe(0, alpha, 0.0);
    prescribe(1, 0.0, sense * std::numbers::pi);
    return {scene.mechanism,  tip, scene.local_point(tip, tip_point(0.0)), tip_point, place.size, margin,
            "universal joint"};
}

/// Two four-bars in a row: the rocker of the first is the crank of the second, whose own margin is large.
inline DrivenLoop driven_row(Random& random, double margin) {
    const Place place = random_place(random);
    const double start = random.number(0.0, 2.0 * std::numbers::pi);
    const double sense = random.number() > 0.0 ? 1.0 : -1.0;
    const double side = random.number() > 0.0 ? 1.0 : -1.0;
    const double a = 1.0 - margin;
    const double reach = random.number(0.3, 0.6);
    const double far = random.number(1.3, 1.6);
    // rocker about (2, 0), then an arm of length `reach` on it drives a coupler `far` and a rocker of length
    // 1 about (3.5, -0.5)
    const auto rocker = [=](double t) {
        const double theta = start + sense * 2.0 * std::numbers::pi * t;
        const double x = a * std::cos(theta) - 2.0;
        const double y = a * std::sin(theta);
        return angle_that_meets(x, y, (x * x + y * y + 1.0 - 4.0) / 2.0, side);
    };
    const auto first = [=](double t) { return place.at(2.0 + std::cos(rocker(t)), std::sin(rocker(t))); };
    const auto second = [=](double t) {
        const double phi = rocker(t);
        const double x = 2.0 + reach * std::cos(phi) - 3.5;
        const double y = reach * std::sin(phi) + 0.5;
        const double psi = angle_that_meets(x, y, (x * x + y * y + 1.0 - far * far) / 2.0, 1.0);
        return place.at(3.5 + std::cos(psi), -0.5 + std::sin(psi));
    };
    SceneBuilder scene;
    const Vec3 A = place.at(a * std::cos(start), a * std::sin(start));
    const Vec3 arm = place.at(2.0 + reach * std::cos(rocker(0.0)), reach * std::sin(rocker(0.0)));
    const Vec3 z = place.along(0, 0, 1);
    const int crank = scene.add_body("crank", place.at(0.1, 0));
    const int coupler = scene.add_body("coupler", 0.5 * (A + first(0.0)));
    const int middle = scene.add_body("rocker", place.at(2, 0.1));
    const int next = scene.add_body("second coupler", arm);
    const int last = scene.add_body("second rocker", place.at(3.5, -0.4));
    Joint& driven = scene.add_joint("revolute", 0, crank, place.at(0, 0), z);
    scene.measure_angle(driven, place.along(1, 0, 0), A - place.at(0, 0));
    scene.add_joint("revolute", crank, coupler, A, z);
    scene.add_joint("revolute", coupler, middle, first(0.0), z);
    scene.add_joint("revolute", 0, middle, place.at(2, 0), z);
    scene.add_joint("revolute", middle, next, arm, z);
    scene.add_joint("revolute", next, last, second(0.0), z);
    scene.add_joint("revolute", 0, last, place.at(3.5, -0.5), z);
    drive(scene.mechanism, 0, start, sense);
    return {scene.mechanism, last,        scene.local_point(last, second(0.0)), second, place.size,
            margin,          "row of two"};
}

/// Least value of a smooth function of an angle: samples, then golden sections.
template <class F>
double least_over_a_turn(F&& f) {
    constexpr int kSampled = 2000;
    constexpr double kSpacing = 2.0 * std::numbers::pi / kSampled;
    int best = 0;
    for (int k = 1; k < kSampled; ++k) {
        if (f(kSpacing * k) < f(kSpacing * best)) { best = k; }
    }
    double low = kSpacing * (best - 1);
    double high = kSpacing * (best + 1);
    for (int k = 0; k < 60; ++k) {
        const double section = 0.381966 * (high - low);
        (f(low + section) < f(high - section) ? high : low) +=
            f(low + section) < f(high - section) ? -section : section;
    }
    return f(0.5 * (low + high));
}

/// Crank and rocker on skew axes, joined by a rod between balls (or by a body on a ball and a universal
/// joint): the rod is `margin` longer than the shortest, or shorter than the longest, that lets the crank
/// turn.
inline DrivenLoop driven_spatial_loop(Random& random, double margin) {
    const Place place = random_place(random);
    const double crank_arm = random.number(0.3, 1.0);
    const double rocker_arm = random.number(0.8, 1.6);
    const Vec3 crank_end = Vec3(0, 0, random.number(-0.3, 0.3));
    const Mat3 rocker_axes = rotation_matrix(random.unit_p());
    const Vec3 rocker_at = Vec3(random.number(1.0, 2.0), random.number(-1.0, 1.0), random.number(-1.0, 1.0));
    const double start = random.number(0.0, 2.0 * std::numbers::pi);
    const double sense = random.number() > 0.0 ? 1.0 : -1.0;
    const double side = random.number() > 0.0 ? 1.0 : -1.0;
    const auto crank_point = [=](double theta) {
        return Vec3(crank_end + crank_arm * Vec3(std::cos(theta), std::sin(theta), 0));
    };
    // |crank point - rocker point|² = L²: cos φ (2 c w_x) + sin φ (2 c w_y) = |w|² + c² - L²
    const auto seen = [=](double theta) {
        return Vec3(rocker_axes.transpose() * (crank_point(theta) - rocker_at));
    };
    const auto reach_out = [=](double theta) {
        const Vec3 w = seen(theta);
        return std::hypot(w.head<2>().norm() + rocker_arm, w.z());
    };
    const auto reach_in = [=](double theta) {
        const Vec3 w = seen(theta);
        return -std::hypot(w.head<2>().norm() - rocker_arm, w.z());
    };
    const double longest = least_over_a_turn(reach_out);
    const double shortest = -least_over_a_turn(reach_in);
    const bool is_outer = random.number() > 0.0;
    const double length = is_outer ? longest - margin : shortest + margin;
    if (shortest + 2.0 * margin + 0.1 > longest || length < 0.3) {
        return driven_spatial_loop(random, margin);
    }
    const auto meeting = [=](double t) {
        const Vec3 w = seen(start + sense * 2.0 * std::numbers::pi * t);
        const double c = (w.squaredNorm() + rocker_arm * rocker_arm - length * length) / (2.0 * rocker_arm);
        const double phi = angle_that_meets(w.x(), w.y(), c, side);
        const Vec3 point = rocker_at + rocker_axes * (rocker_arm * Vec3(std::cos(phi), std::sin(phi), 0));
        return Vec3(place.origin + place.size * (place.axes * point));
    };
    const auto global = [=](const Vec3& point) {
        return Vec3(place.origin + place.size * (place.axes * point));
    };
    SceneBuilder scene;
    const Vec3 A = global(crank_point(start));
    const Vec3 B = meeting(0.0);
    const int crank = scene.add_body("crank", global(crank_end));
    const int rocker = scene.add_body("rocker", 0.4 * B + 0.6 * global(rocker_at));
    Joint& driven = scene.add_joint("revolute", 0, crank, global(crank_end), place.axes.col(2));
    scene.measure_angle(driven, place.axes.col(0), A - global(crank_end));
    scene.add_joint("revolute", 0, rocker, global(rocker_at), place.axes * rocker_axes.col(2));
    const bool has_rod = random.number() > 0.0;
    if (has_rod) {
        scene.add_distance(crank, rocker, A, B);
    } else {
        const int coupler = scene.add_body("coupler", 0.5 * (A + B));
        scene.add_joint("spherical", crank, coupler, A, place.axes.col(2));
        // the cross stands across the rod and across the rocker
        const Vec3 rod = (B - A).normalized();
        const Vec3 one = perpendicular_to(rod);
        const Vec3 rocker_axis = place.axes * rocker_axes.col(2);
        const Vec3 other = (one.cross(rocker_axis)).norm() > 0.1 ? one.cross(rocker_axis) : one.cross(rod);
        scene.add_universal(coupler, rocker, B, one, other.normalized());
    }
    drive(scene.mechanism, 0, start, sense);
    return {scene.mechanism, rocker, scene.local_point(rocker, B),  meeting,
            place.size,      margin, has_rod ? "R-SS-R" : "R-S-U-R"};
}

}  // namespace jw::test
