#include "tests/support/generators/as_lesson.hpp"

namespace jw::test {

Lesson lesson_of(const Generated& generated, const std::string& title, const std::string& text) {
    Lesson lesson;
    lesson.file_name = "generated.toml";
    lesson.title = title;
    lesson.chapter = "soak";
    lesson.source = "made by ./dev soak";
    lesson.text = text;
    lesson.mechanism = generated.mechanism;
    lesson.looks.resize(lesson.mechanism.bodies.size());
    lesson.step_texts.joints.resize(lesson.mechanism.joints.size());
    lesson.step_texts.drivers.resize(lesson.mechanism.drivers.size());
    for (std::size_t k = 0; k < lesson.mechanism.joints.size(); ++k) {
        lesson.order.push_back({Addition::Kind::joint, static_cast<int>(k)});
    }
    for (std::size_t k = 0; k < lesson.mechanism.drivers.size(); ++k) {
        lesson.order.push_back({Addition::Kind::driver, static_cast<int>(k)});
    }
    DynamicsPlan& plan = lesson.dynamics.emplace();
    plan.loads = generated.loads;
    plan.duration = 0.5;
    plan.settings.tolerance = 1e-9;
    plan.point = BodyPoint{static_cast<int>(lesson.mechanism.bodies.size()) - 1, Vec3::Zero()};
    return lesson;
}

}  // namespace jw::test
