#include "app/session/try/experiments.hpp"

#include <algorithm>

#include "app/session/try/experiment_text.hpp"

namespace jw {

namespace {

/// Subject of an edit: two edits about the same thing set the same values.
struct Topic {
    std::size_t kind = 0;
    int index = 0;  ///< of a joint, driver or body
    std::optional<Addition> addition;
    std::optional<EquationOut> equation;

    bool operator==(const Topic&) const = default;
};

Topic topic_of(const Experiment& edit) {
    Topic topic;
    topic.kind = edit.index();
    std::visit(
        Overloaded{
            [&](const SetParallelForm& a) { topic.index = a.joint; },
            [&](const SetScrewAngleForm& a) { topic.index = a.joint; },
            [](const SetCoordinates&) {},
            [&](const SetPresent& a) { topic.addition = a.what; },
            [&](const SetEquationPresent& a) {
                topic.index = a.joint;
                topic.equation = a.equation;
            },
            [&](const SetGeometry& a) { topic.index = a.joint; },
            [&](const SetDriver& a) { topic.index = a.driver; },
            [&](const SetPose& a) { topic.index = a.body; },
            [](const auto& other) { static_assert(!EditsLesson<std::decay_t<decltype(other)>>); },
        },
        edit);
    return topic;
}

bool same_body(const Body& a, const Body& b) { return a.r == b.r && a.p == b.p; }

bool same_joint(const Joint& a, const Joint& b) {
    return a.geometry == b.geometry && a.parallel_form == b.parallel_form && a.without == b.without;
}

/// True if everything that edits can change is equal; the measure of a driver follows from its joint.
bool same_lesson(const Lesson& a, const Lesson& b) {
    const auto same_function = [](const Driver& x, const Driver& y) { return x.function == y.function; };
    return a.order == b.order && a.coordinates == b.coordinates &&
           std::ranges::equal(a.mechanism.bodies, b.mechanism.bodies, same_body) &&
           std::ranges::equal(a.mechanism.joints, b.mechanism.joints, same_joint) &&
           std::ranges::equal(a.mechanism.drivers, b.mechanism.drivers, same_function);
}

/// True if the sentences of `edits`, read and carried out, lead to `now`.
bool lead_to(const Lesson& now, std::span<const Experiment> edits, const Lesson& written) {
    Lesson lesson = written;
    for (const Experiment& edit : edits) {
        const std::optional<Experiment> read = read_edit(text_of(edit, lesson), lesson);
        if (!read) { return false; }
        Edit done = edit_of(std::move(lesson), written, *read);
        if (!done.lesson) { return false; }
        lesson = std::move(*done.lesson);
    }
    return same_lesson(lesson, now);
}

}  // namespace

std::vector<Experiment> tried_with(
    std::vector<Experiment> edits, std::span<const Experiment> more, const LessonChange& change) {
    if (same_lesson(change.now, change.written)) { return {}; }
    if (same_lesson(change.now, change.before)) { return edits; }
    std::vector<Experiment> fewer = edits;
    std::erase_if(fewer, [&](const Experiment& before) {
        return std::ranges::any_of(
            more, [&](const Experiment& later) { return topic_of(later) == topic_of(before); });
    });
    if (fewer.size() < edits.size() && lead_to(change.now, fewer, change.written)) { return fewer; }
    std::ranges::copy(more, std::back_inserter(fewer));
    const bool shorter = fewer.size() < edits.size() + more.size();
    if (shorter && lead_to(change.now, fewer, change.written)) { return fewer; }
    std::ranges::copy(more, std::back_inserter(edits));
    return edits;
}

std::vector<std::string> sentences_of(std::span<const Experiment> edits, const Lesson& written) {
    std::vector<std::string> sentences;
    Lesson lesson = written;
    for (const Experiment& edit : edits) {
        sentences.push_back(text_of(edit, lesson));
        Edit done = edit_of(std::move(lesson), written, edit);
        lesson = std::move(done.lesson).value();
    }
    return sentences;
}

}  // namespace jw
