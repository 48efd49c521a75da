#pragma once

#include <algorithm>
#include <numbers>
#include <string>

#include "app/session/picture/picture_parts.hpp"
#include "tests/support/scene_builder.hpp"

/// Lessons in code and what to look for in their pictures.
namespace jw::test {

/// A lesson around a mechanism: joints in their order, nothing drawn by the author.
inline Lesson lesson_of(const Mechanism& mechanism) {
    Lesson lesson;
    lesson.mechanism = mechanism;
    lesson.looks.resize(mechanism.bodies.size());
    lesson.step_texts.joints.resize(mechanism.joints.size());
    lesson.step_texts.drivers.resize(mechanism.drivers.size());
    for (int j = 0; j < static_cast<int>(mechanism.joints.size()); ++j) {
        lesson.order.push_back({Addition::Kind::joint, j});
    }
    for (int d = 0; d < static_cast<int>(mechanism.drivers.size()); ++d) {
        lesson.order.push_back({Addition::Kind::driver, d});
    }
    return lesson;
}

inline const Vec3 kPoint(0.4, 0.2, 0.9);
inline const Vec3 kAxis = Vec3(0.3, -0.5, 0.8).normalized();

/// One joint of each type in turn between the ground and a body.
inline Lesson one_joint(std::string_view type) {
    SceneBuilder scene;
    const int body = scene.add_body("body", Vec3(1.0, 0.4, 0.6));
    if (type == "universal") {
        scene.add_universal(0, body, kPoint, kAxis, perpendicular_to(kAxis));
    } else if (find_joint_type(type)->has_distance()) {
        scene.add_link(type, 0, body, kPoint, kPoint + 0.5 * kAxis, perpendicular_to(kAxis));
    } else if (find_joint_type(type)->has_own_coordinate()) {
        scene.add_any_wheels(type, 0, body, kPoint, kAxis);
    } else {
        Joint& joint = scene.add_joint(type, 0, body, kPoint, kAxis);
        if (type == "screw") { joint.geometry.alpha = 0.02; }
    }
    return lesson_of(scene.mechanism);
}

/// Ground, a hinge, a hinge across it, a ball, ground.
inline Lesson chain() {
    SceneBuilder scene;
    const int a = scene.add_body("a", Vec3(0.3, 0.0, 0.0));
    const int b = scene.add_body("b", Vec3(0.9, 0.2, 0.1));
    scene.add_joint("revolute", 0, a, Vec3::Zero(), Vec3::UnitZ());
    scene.add_joint("revolute", a, b, Vec3(0.6, 0.1, 0.0), Vec3::UnitY());
    scene.add_joint("spherical", b, 0, Vec3(1.2, 0.3, 0.2), Vec3::UnitY());
    return lesson_of(scene.mechanism);
}

/// A crank, driven through three quarters of a turn in one second.
inline Lesson crank() {
    Lesson lesson = one_joint("revolute");
    drive_angle(lesson.mechanism, 0, polynomial({0.0, 1.5 * std::numbers::pi}));
    lesson = lesson_of(lesson.mechanism);
    lesson.motion = MotionPlan{0.0, 1.0, 1.0, 40};
    return lesson;
}

inline Step::Kind kind_of(const Story& story, int index) {
    return story.steps()[static_cast<std::size_t>(index)].kind;
}

inline int first_of(const Story& story, Step::Kind kind) {
    int index = 0;
    while (kind_of(story, index) != kind) { ++index; }
    return index;
}

/// True if everything in a picture is finite.
inline bool is_finite(const Picture& picture) {
    const render::Bounds bounds = render::bounds_of(picture.scene);
    const bool scene = bounds.lowest().allFinite() && bounds.highest().allFinite();
    return scene && std::ranges::all_of(picture.annotations, [](const Annotation& a) {
               return a.at.allFinite() && a.towards.allFinite();
           });
}

inline bool has_text(const Picture& picture, const std::string& text) {
    return std::ranges::any_of(picture.annotations, [&](const Annotation& a) { return a.text == text; });
}

inline std::vector<render::Shape> highlighted(const Picture& picture) {
    std::vector<render::Shape> found;
    std::ranges::copy_if(picture.scene.shapes, std::back_inserter(found), [](const render::Shape& s) {
        return s.highlighted;
    });
    return found;
}

inline render::Bounds bounds_of(const std::vector<render::Shape>& shapes) {
    render::Scene scene;
    scene.shapes = shapes;
    return render::bounds_of(scene);
}

/// True if two pictures have equally many parts and the same bounds.
inline bool same_pictures(const Picture& a, const Picture& b) {
    const render::Bounds x = render::bounds_of(a.scene);
    const render::Bounds y = render::bounds_of(b.scene);
    return a.scene.shapes.size() == b.scene.shapes.size() && a.scene.arrows.size() == b.scene.arrows.size() &&
           a.annotations.size() == b.annotations.size() && x.lowest() == y.lowest() &&
           x.highest() == y.highest();
}

}  // namespace jw::test
