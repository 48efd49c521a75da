#include "lessons/questions.hpp"

#include <algorithm>

#include "core/numerics/variants.hpp"
#include "lessons/lesson.hpp"

namespace jw {

namespace {

/// The joint or driver that an answer is about, index -1 for none.
Addition subject_of_answer(const Answer& answer) {
    const Addition none{Addition::Kind::joint, -1};
    return std::visit(
        Overloaded{
            [&](const CountAnswer&) { return none; },
            [](const DroppedAnswer& a) {
                return Addition{Addition::Kind::joint, a.joint};
            },
            [](const QuantityAnswer& a) {
                const int joint = joint_of(a.quantity);
                return joint >= 0 ? Addition{Addition::Kind::joint, joint}
                                  : Addition{Addition::Kind::driver, driver_of(a.quantity)};
            },
            [&](const ChoiceAnswer&) { return none; },
        },
        answer);
}

bool is_added(const Addition& addition, const Lesson& lesson) {
    const auto is_in_order = [&](const Addition& a) {
        return std::ranges::find(lesson.order, a) != lesson.order.end();
    };
    if (!is_in_order(addition)) { return false; }
    if (addition.kind == Addition::Kind::joint) { return true; }
    // a driver goes with its joint
    const int joint = lesson.mechanism.drivers[static_cast<std::size_t>(addition.index)].joint;
    return joint < 0 || is_in_order({Addition::Kind::joint, joint});
}

}  // namespace

bool applies(const Question& question, const Lesson& lesson) {
    if (question.place == Question::Place::addition && !is_added(question.addition, lesson)) { return false; }
    const bool moves = lesson.motion || lesson.dynamics;
    const bool of_motion =
        question.place == Question::Place::motion || std::holds_alternative<QuantityAnswer>(question.answer);
    if (of_motion && !moves) { return false; }
    const Addition subject = subject_of_answer(question.answer);
    return subject.index < 0 || is_added(subject, lesson);
}

}  // namespace jw
