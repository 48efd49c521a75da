#pragma once

#include "tests/support/driven_loops.hpp"

/// More loops with one driven crank: on a sphere, one loop on another, and through change points.
namespace jw::test {

/// Four hinges whose axes meet in a point: the angles between axes take the place of lengths. Three of its
/// equations repeat others.
inline DrivenLoop driven_spherical_loop(Random& random, double margin) {
    const Place place = random_place(random);
    const double ground = random.number(0.7, 1.1);
    const double crank_angle = random.number(0.2, 0.5);
    const double difference = ground - crank_angle;
    const double sum = ground + crank_angle;
    // the arc from pin to rocker's axis lies between difference and sum, coupler ± rocker lie around that
    const bool is_outer = random.number() > 0.0;
    const double most = is_outer ? sum + margin : sum + random.number(0.05, 0.4);
    const double least = is_outer ? random.number() * (difference - 0.05) : difference - margin;
    const double coupler_angle = 0.5 * (most + least);
    const double rocker_angle = 0.5 * (most - least);
    const double start = random.number(0.0, 2.0 * std::numbers::pi);
    const double sense = random.number() > 0.0 ? 1.0 : -1.0;
    const double side = random.number() > 0.0 ? 1.0 : -1.0;
    const Vec3 R(std::sin(ground), 0, std::cos(ground));
    const Vec3 U(std::cos(ground), 0, -std::sin(ground));
    const Vec3 V(0, 1, 0);
    const auto pin = [=](double t) {
        const double theta = start + sense * 2.0 * std::numbers::pi * t;
        return Vec3(
            std::sin(crank_angle) * std::cos(theta), std::sin(crank_angle) * std::sin(theta),
            std::cos(crank_angle));
    };
    const auto meeting = [=](double t) {
        const Vec3 A = pin(t);
        const double c =
            (std::cos(coupler_angle) - std::cos(rocker_angle) * A.dot(R)) / std::sin(rocker_angle);
        const double phi = angle_that_meets(A.dot(U), A.dot(V), c, side);
        return Vec3(
            std::cos(rocker_angle) * R + std::sin(rocker_angle) * (std::cos(phi) * U + std::sin(phi) * V));
    };
    const auto global = [=](const Vec3& v) { return place.at(v.x(), v.y(), v.z()); };
    SceneBuilder scene;
    const Vec3 A = pin(0.0);
    const Vec3 B = meeting(0.0);
    const int crank = scene.add_body("crank", global(0.5 * A));
    const int coupler = scene.add_body("coupler", global(0.5 * (A + B)));
    const int rocker = scene.add_body("rocker", global(0.5 * (B + R)));
    Joint& driven = scene.add_joint("revolute", 0, crank, global(Vec3::Zero()), place.along(0, 0, 1));
    scene.measure_angle(driven, place.along(1, 0, 0), place.along(A.x(), A.y(), 0));
    scene.add_joint("revolute", crank, coupler, global(A), place.axes * A);
    scene.add_joint("revolute", coupler, rocker, global(0.8 * B), place.axes * B);
    scene.add_joint("revolute", 0, rocker, global(1.1 * R), place.axes * R);
    drive(scene.mechanism, 0, start, sense);
    return {
        scene.mechanism,
        rocker,
        scene.local_point(rocker, global(B)),
        [=](double t) { return global(meeting(t)); },
        place.size,
        margin,
        "spherical four-bar"};
}

/// A four-bar far from folding whose coupler carries a point that drives two more links: these come within
/// `margin` of folding, or of being stretched.
inline DrivenLoop driven_coupler_point(Random& random, double margin) {
    const Place place = random_place(random);
    const double start = random.number(0.0, 2.0 * std::numbers::pi);
    const double sense = random.number() > 0.0 ? 1.0 : -1.0;
    const double side = random.number() > 0.0 ? 1.0 : -1.0;
    const FourBarLinks links{random.number(0.4, 0.7), 1.8, random.number(1.3, 1.6), 2.0};
    const DrivenLoop four_bar = four_bar_of(place, links, margin, start, sense, side);
    const double along = random.number(0.2, 0.8);
    const double across = random.number(-0.8, 0.8);
    const Vec3 pivot(random.number(0.0, 2.0), random.number(2.5, 3.5), 0);
    const auto coupler_point = [=](double t) {
        const double theta = start + sense * 2.0 * std::numbers::pi * t;
        const Vec3 A = place.at(links.a * std::cos(theta), links.a * std::sin(theta));
        const Vec3 bar = four_bar.expected(t) - A;
        return Vec3(A + along * bar + across * place.along(0, 0, 1).cross(bar));
    };
    /// From the pivot, in the plane and in sizes.
    const auto seen = [=](double t) {
        return Vec3(
            place.axes.transpose() * (coupler_point(t) - place.at(pivot.x(), pivot.y())) / place.size);
    };
    const double shortest =
        least_over_a_turn([&](double angle) { return seen(angle / (2.0 * std::numbers::pi)).norm(); });
    const double longest =
        -least_over_a_turn([&](double angle) { return -seen(angle / (2.0 * std::numbers::pi)).norm(); });
    const bool is_outer = random.number() > 0.0;
    const double sum = longest + (is_outer ? margin : random.number(0.1, 0.5));
    const double difference = is_outer ? random.number() * (shortest - 0.1) : shortest - margin;
    if (shortest < 0.2 || sum - std::abs(difference) < 0.2) { return driven_coupler_point(random, margin); }
    const double link = 0.5 * (sum + difference);
    const double last_link = 0.5 * (sum - difference);
    const double last_side = random.number() > 0.0 ? 1.0 : -1.0;
    const auto meeting = [=](double t) {
        const Vec3 w = seen(t);
        const double c = (w.squaredNorm() + last_link * last_link - link * link) / (2.0 * last_link);
        const double psi = angle_that_meets(w.x(), w.y(), c, last_side);
        return place.at(pivot.x() + last_link * std::cos(psi), pivot.y() + last_link * std::sin(psi));
    };
    SceneBuilder scene;
    scene.mechanism = four_bar.mechanism;
    const Vec3 z = place.along(0, 0, 1);
    const Vec3 C = coupler_point(0.0);
    const Vec3 E = meeting(0.0);
    const int next = scene.add_body("second coupler", 0.5 * (C + E));
    const int last = scene.add_body("second rocker", place.at(pivot.x(), pivot.y() + 0.1));
    scene.add_joint("revolute", four_bar.body, next, C, z);
    scene.add_joint("revolute", next, last, E, z);
    scene.add_joint("revolute", 0, last, place.at(pivot.x(), pivot.y()), z);
    return {scene.mechanism, last, scene.local_point(last, E), meeting, place.size, margin, "six-bar"};
}

/// Crank and rocker of length 1 on a coupler as long as the ground: turning together, or against each other.
/// Both branches meet where all lie in a line, at turns of 0 and 1/2. @param start of the crank [rad]
inline DrivenLoop driven_parallelogram(const Place& place, double length, double start, bool turns_against) {
    const auto crank_pin = [=](double t) {
        const double theta = start + 2.0 * std::numbers::pi * t;
        return place.at(std::cos(theta), std::sin(theta));
    };
    const auto rocker_pin = [=](double t) {
        const double theta = start + 2.0 * std::numbers::pi * t;
        // the other branch is its mirror image about the line from pin to pivot
        const double phi =
            turns_against ? 2.0 * std::atan2(std::sin(theta), std::cos(theta) - length) - theta : theta;
        return place.at(length + std::cos(phi), std::sin(phi));
    };
    SceneBuilder scene;
    const Vec3 z = place.along(0, 0, 1);
    const int crank = scene.add_body("crank", place.at(0.2, 0));
    const int coupler = scene.add_body("coupler", crank_pin(0.0));
    const int rocker = scene.add_body("rocker", place.at(length, 0.3));
    Joint& driven = scene.add_joint("revolute", 0, crank, place.at(0, 0), z);
    scene.measure_angle(driven, place.along(1, 0, 0), crank_pin(0.0) - place.at(0, 0));
    scene.add_joint("revolute", crank, coupler, crank_pin(0.0), z);
    scene.add_joint("revolute", coupler, rocker, rocker_pin(0.0), z);
    scene.add_joint("revolute", 0, rocker, place.at(length, 0), z);
    drive(scene.mechanism, 0, start, 1.0);
    return {scene.mechanism, rocker, scene.local_point(rocker, rocker_pin(0.0)), rocker_pin, place.size, 0.0,
            "parallelogram"};
}

}  // namespace jw::test
