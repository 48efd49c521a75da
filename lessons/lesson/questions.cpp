#include "lessons/lesson/questions.hpp"

#include <algorithm>

#include "core/numerics/variants.hpp"
#include "lessons/lesson/lesson.hpp"

namespace jw {

namespace {

bool is_there(const Quantity& quantity, const Lesson& lesson) {
    const int joint = joint_of(quantity);
    const int driver = driver_of(quantity);
    if (joint >= 0) { return is_added({Addition::Kind::joint, joint}, lesson); }
    return driver < 0 || is_added({Addition::Kind::driver, driver}, lesson);
}

/// False if the answer is about something that was taken out.
bool is_there(const Answer& answer, const Lesson& lesson) {
    const auto has_thing = [&](const Thing& thing) { return is_present(thing, lesson); };
    return std::visit(
        Overloaded{
            [&](const DroppedAnswer& a) {
                return is_added({Addition::Kind::joint, a.joint}, lesson);
            },
            [&](const QuantityAnswer& a) { return is_there(a.quantity, lesson); },
            [&](const PointedAnswer& a) { return std::ranges::all_of(a.right, has_thing); },
            [](const auto&) { return true; },
        },
        answer);
}

bool is_of_motion(const Question& question) {
    if (question.place == Question::Place::motion) { return true; }
    const auto* const pose = std::get_if<PoseAnswer>(&question.answer);
    return std::holds_alternative<QuantityAnswer>(question.answer) || (pose != nullptr && pose->when);
}

}  // namespace

bool is_added(const Addition& addition, const Lesson& lesson) {
    const auto is_in_order = [&](const Addition& a) {
        return std::ranges::find(lesson.order, a) != lesson.order.end();
    };
    if (!is_in_order(addition)) { return false; }
    if (addition.kind == Addition::Kind::joint) { return true; }
    // a driver is taken out with its joint
    const int joint = lesson.mechanism.drivers[jw::at(addition.index)].joint;
    return joint < 0 || is_in_order({Addition::Kind::joint, joint});
}

bool applies(const Question& question, const Lesson& lesson) {
    if (question.place == Question::Place::addition && !is_added(question.addition, lesson)) { return false; }
    const bool moves = lesson.motion || lesson.dynamics;
    return (moves || !is_of_motion(question)) && is_there(question.answer, lesson);
}

}  // namespace jw
