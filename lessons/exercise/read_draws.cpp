#include <cmath>

#include "lessons/exercise/read_exercise_parts.hpp"
#include "lessons/exercise/scene_edits.hpp"

namespace jw::reading {

namespace {

constexpr std::size_t kMostDraws = 20;
constexpr double kMostSteps = 1e6;

void read_keys(Fields& fields, const Exercise& exercise, Draw& draw) {
    fields.at_most_one({"key", "keys"});
    if (!fields.has("keys")) { fields.require("key", "what is drawn, such as \"joint.B.axis\""); }
    std::vector<Located<std::string>> keys;
    if (const auto key = fields.text("key")) { keys.push_back(*key); }
    if (const auto list = fields.texts("keys")) { keys = list->value; }
    for (const Located<std::string>& key : keys) {
        if (!exercise.scene.empty() && value_in(exercise.scene, key.value).empty()) {
            fields.problems().add(
                Code::exercise_edit, key.span,
                "the scene has no " + in_quotes(key.value) +
                    "; expected a key that is there, by the names "
                    "of its tables",
                "for example \"joint.hinge.axis\" or \"body.crank.rotation.angle_deg\"");
        }
        draw.keys.push_back(key.value);
    }
}

void read_range(Fields& fields, Draw& draw) {
    fields.require("from", "the smallest value");
    fields.require("to", "the largest value");
    const auto from = fields.number("from");
    const auto to = fields.number("to");
    const auto step = fields.positive("step");
    const auto count = fields.integer("count");
    if (!from || !to) { return; }
    draw.kind = Draw::Kind::numbers;
    draw.from = from->value;
    draw.to = to->value;
    draw.step = step ? step->value : 1.0;
    draw.count = count ? count->value : 1;
    if (draw.to <= draw.from || (draw.to - draw.from) / draw.step > kMostSteps) {
        fields.problems().add(
            Code::out_of_range, to->span, "'to' has to be above 'from', by at most a million steps");
    }
}

Draw read_draw(Fields& fields, const Exercise& exercise) {
    Draw draw;
    fields.call("the draw");
    read_keys(fields, exercise, draw);
    fields.at_most_one({"values", "from", "nice"});
    if (const auto nice = fields.word("nice")) {
        draw.kind = *nice == 0 ? Draw::Kind::direction : Draw::Kind::euler_parameters;
    } else if (fields.has("values")) {
        draw.values = list_of_toml(fields, "values");
        if (draw.values.size() < 2) {
            fields.problems().add(
                Code::wrong_count, fields.span("values"), "expected a list of two values or more");
        }
    } else {
        read_range(fields, draw);
    }
    fields.finish();
    return draw;
}

}  // namespace

void read_draws(Fields& fields, Exercise& exercise) {
    for (Fields& draw : fields.tables("vary", kMostDraws)) {
        exercise.vary.push_back(read_draw(draw, exercise));
    }
    if (const auto limit = fields.positive("condition_below")) { exercise.condition_below = limit->value; }
}

}  // namespace jw::reading
