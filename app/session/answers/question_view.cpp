#include "app/session/answers/question_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/session/answers/right_answer.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "app/session/wording/quantity_text.hpp"
#include "core/elementary/elementary.hpp"
#include "core/numerics/variants.hpp"

namespace jw {

namespace {

constexpr std::array<const char*, 3> kAxes{"x", "y", "z"};

std::vector<std::string> choices_of(const Question& question) {
    return std::visit(
        Overloaded{
            [](const ChoiceAnswer& a) {
                return std::vector<std::string>(a.choices.begin(), a.choices.end());
            },
            [](const DroppedAnswer&) { return std::vector<std::string>(kAxes.begin(), kAxes.end()); },
            [](const auto&) { return std::vector<std::string>(); },
        },
        question.answer);
}

std::string unit_of_answer(const Question& question) {
    const auto* const quantity = std::get_if<QuantityAnswer>(&question.answer);
    if (quantity == nullptr) { return {}; }
    return unit_text(dimension_of(quantity->quantity), quantity->derivative, quantity->in_degrees);
}

QuestionView::Kind kind_of(const Answer& answer) {
    using Kind = QuestionView::Kind;
    return std::visit(
        Overloaded{
            [](const CountAnswer&) { return Kind::number; },
            [](const DroppedAnswer&) { return Kind::choice; },
            [](const QuantityAnswer&) { return Kind::number; },
            [](const ChoiceAnswer&) { return Kind::choice; },
            [](const PointedAnswer&) { return Kind::thing; },
            [](const PoseAnswer&) { return Kind::pose; },
        },
        answer);
}

std::string how_to_point(Thing::Kind kind) {
    switch (kind) {
        case Thing::Kind::body: return tr("Click a body, or give its name.");
        case Thing::Kind::joint: return tr("Click a joint, or give its name.");
        case Thing::Kind::vector: return tr("Click a vector, or give its name.");
        case Thing::Kind::row: break;
    }
    return tr("Click a row, or give its name.");
}

/// Names of all things that can be clicked at this step.
std::vector<std::string> names_of(const Lesson& lesson, Thing::Kind kind) {
    std::vector<std::string> names;
    for (const Thing& thing : things_of(lesson.mechanism, kind)) {
        if (is_present(thing, lesson)) { names.push_back(name_of(thing, lesson.mechanism)); }
    }
    return names;
}

void add_how(const Lesson& lesson, const Answer& answer, QuestionView& view) {
    if (const auto* const pointed = std::get_if<PointedAnswer>(&answer)) {
        view.thing = pointed->kind;
        view.names = names_of(lesson, pointed->kind);
        view.how = how_to_point(pointed->kind);
    } else if (const auto* const pose = std::get_if<PoseAnswer>(&answer)) {
        const std::string& body = lesson.mechanism.bodies[at(pose->body)].name;
        view.how = tr("Drag {0} there, or give its x, y, z [m] and e0, e1, e2, e3.", body);
    }
}

std::string pose_answer_text(const BodyPose& pose) {
    const std::string p = joined(pose.p, ", ", [](double e) { return number_text(e, 4); });
    return tr("r = {0} m, p = ({1})", vector_text(pose.r), p);
}

std::string answer_text(const Lesson& lesson, const Question& question, const RightAnswer& right) {
    if (!right.known) { return tr("This cannot be determined in this scene."); }
    if (right.pose) { return pose_answer_text(*right.pose); }
    if (!right.things.empty()) {
        std::vector<std::string> names;
        for (const Thing& thing : right.things) { names.push_back(name_of(thing, lesson.mechanism)); }
        return alternatives(names);
    }
    if (right.choice >= 0) { return choices_of(question)[at(right.choice)]; }
    const std::string unit = unit_of_answer(question);
    // as many digits as the tolerance asks for, and two more
    const double size = std::max(std::abs(right.number), 1e-300);
    const int digits =
        right.tolerance > 0.0
            ? std::clamp(static_cast<int>(std::ceil(elementary::log10(size / right.tolerance))) + 2, 2, 9)
            : 6;
    return number_text(right.number, digits) + (unit.empty() ? "" : " " + unit);
}

}  // namespace

int joint_asked_about(const Lesson& lesson, const Step& step) {
    if (step.kind != Step::Kind::question) { return -1; }
    const Question& question = question_of(lesson, step);
    const auto* const pointed = std::get_if<PointedAnswer>(&question.answer);
    const bool of_joint =
        question.place == Question::Place::addition && question.addition.kind == Addition::Kind::joint;
    const bool of_its_parts =
        pointed != nullptr && (pointed->kind == Thing::Kind::row || pointed->kind == Thing::Kind::vector);
    return of_joint && of_its_parts ? question.addition.index : -1;
}

QuestionView question_view_of(const Story& story, const Step& step) {
    const Question& question = question_of(story.lesson(), step);
    QuestionView view;
    view.kind = kind_of(question.answer);
    view.ask = question.ask;
    view.choices = choices_of(question);
    view.unit = unit_of_answer(question);
    add_how(story.lesson(), question.answer, view);
    view.answered = step.kind == Step::Kind::answer;
    if (!view.answered) { return view; }
    const RightAnswer right = right_answer(story, question, step);
    view.answer = answer_text(story.lesson(), question, right);
    view.right = right.things;
    view.why = question.why;
    return view;
}

}  // namespace jw
