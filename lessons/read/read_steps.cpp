#include <algorithm>
#include <span>

#include "lessons/read/reading.hpp"
#include "lessons/typed/exact_text.hpp"

namespace jw::reading {

namespace {

constexpr std::size_t kMostTexts = 2000;

void set_text(Fields& fields, const Located<std::string>& at, const Text& words, Text& text) {
    if (!text.empty()) {
        fields.report(
            Code::named_twice, at.span,
            "the step " + in_quotes(at.value) + " has a text already; expected one for each step");
    }
    text = words;
}

/// Finds the place for the text of a step; nullptr if there is no such step.
Text* text_of(const Located<std::string>& at, Reading& reading) {
    StepTexts& texts = reading.lesson.step_texts;
    if (at.value == "bodies") { return &texts.bodies; }
    if (at.value == "motion") { return &texts.motion; }
    const Named* named = reading.addition(at);
    if (named == nullptr) { return nullptr; }
    auto& list = named->kind == Named::Kind::joint ? texts.joints : texts.drivers;
    return &list[jw::at(named->index)];
}

bool moves_at(const Lesson& lesson, double t) {
    const auto& motion = lesson.motion;
    const auto& dynamics = lesson.dynamics;
    return (motion && t >= motion->from && t <= motion->to) ||
           (dynamics && t >= 0.0 && t <= dynamics->duration);
}

void read_step(Fields& fields, Reading& reading) {
    const auto at = fields.text("at");
    const auto at_s = fields.number("at_s");
    const auto text = fields.words("text");
    fields.call("the step");
    fields.at_most_one({"at", "at_s"});
    fields.require("text", "the words to show");
    if (!fields.has("at_s")) {
        fields.require("at", "\"bodies\", \"motion\", a joint or a driver, or 'at_s' for a time");
    }
    fields.finish();
    Text words = text ? text->value : Text();
    words.drop_line_feeds();
    if (at_s) {
        if (!moves_at(reading.lesson, at_s->value)) {
            reading.report(
                Code::no_motion, at_s->span,
                "there is no motion at " + writing::number_text(at_s->value) +
                    " s; expected a time between 'from_s' and 'to_s' of [motion]" +
                    (reading.lesson.dynamics ? " or within 'duration' of [dynamics]" : ""));
        }
        reading.lesson.step_texts.times.push_back({at_s->value, words});
    } else if (at) {
        if (Text* into = text_of(*at, reading)) { set_text(fields, *at, words, *into); }
    }
}

}  // namespace

void read_order(Fields& root, Reading& reading) {
    const auto names = root.texts("order");
    if (!names) { return; }
    std::vector<Addition>& all = reading.lesson.order;
    std::vector<Addition> order;
    for (const auto& name : names->value) {
        const Named* named = reading.addition(name);
        if (named == nullptr) { continue; }
        if (std::ranges::find(order, named->addition()) != order.end()) {
            root.report(
                Code::named_twice, name.span,
                in_quotes(name.value) + " is in 'order' twice; expected each name once");
            continue;
        }
        order.push_back(named->addition());
    }
    // a driver along a joint needs the joint's vectors
    for (std::size_t k = 0; k < order.size(); ++k) {
        if (order[k].kind != Addition::Kind::driver) { continue; }
        const auto& driver = reading.lesson.mechanism.drivers[jw::at(order[k].index)];
        const Addition joint{Addition::Kind::joint, driver.joint};
        const auto before = std::span(order).first(k);
        if (driver.joint >= 0 && std::ranges::find(before, joint) == before.end()) {
            root.report(
                Code::driver_before_joint, names->span,
                "'order' adds the driver " + in_quotes(driver.name) +
                    " before its joint; expected the joint first");
        }
    }
    for (const Addition& addition : all) {
        if (std::ranges::find(order, addition) == order.end()) { order.push_back(addition); }
    }
    all = std::move(order);
}

void read_steps(Fields& root, Reading& reading) {
    for (Fields& fields : root.tables("step", kMostTexts)) { read_step(fields, reading); }
    std::ranges::stable_sort(reading.lesson.step_texts.times, {}, &StepTexts::AtTime::from);
}

}  // namespace jw::reading
