#include <array>
#include <cmath>

#include "lessons/exercise/read_exercises.hpp"
#include "lessons/exercise/scene_edits.hpp"
#include "lessons/exercise/scene_nodes.hpp"
#include "lessons/format/claim_keys.hpp"
#include "lessons/read/reader.hpp"
#include "lessons/typed/exact_text.hpp"

namespace jw::reading {

namespace {

constexpr std::size_t kMostItems = 10;
constexpr std::size_t kMostEdits = 50;

/// A value as its author may have written it: toml++ writes 0.4 as 0.40000000000000002.
std::string value_text(const toml::node& node) {
    if (const toml::array* const array = node.as_array()) { return writing::list_text(*array, value_text); }
    const toml::value<double>* const number = node.as_floating_point();
    if (number != nullptr && std::isfinite(number->get())) {
        const std::string text = writing::number_text(number->get());
        // a TOML number that is not an integer must not become one
        return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
    }
    return node_text(node);
}

/// Copies the keys of [[expect]] that are present.
void copy_keys(Fields& fields, std::span<const Key> keys, toml::table& to) {
    for (const Key& key : keys) {
        if (const toml::node* const node = fields.raw(key.name)) { to.insert(key.name, *node); }
    }
}

/// A node as TOML; empty if the key is not there.
std::string toml_of(Fields& fields, std::string_view key) {
    const toml::node* const node = fields.raw(key);
    if (node == nullptr) { return {}; }
    return value_text(*node);
}

/// The entries of a list, each as TOML.
std::vector<std::string> list_of_toml(Fields& fields, std::string_view key) {
    std::vector<std::string> entries;
    const toml::node* const node = fields.raw(key);
    if (node == nullptr || !node->is_array()) { return entries; }
    for (const toml::node& entry : *node->as_array()) { entries.push_back(value_text(entry)); }
    return entries;
}

/// Reads the scene with these claims; mistakes in them are reported at the exercise.
void check_claims_of(
    Fields& fields, const Exercise& exercise, const std::string& claims, std::string_view what) {
    // other mistakes would only be reported twice
    if (exercise.scene.empty() || fields.problems().errors_count() > 0) { return; }
    const ReadResult read = read_lesson_with_claims(exercise.scene, exercise.scene_name, claims);
    if (read.lesson) { return; }
    const Diagnostic& first = read.diagnostics.front();
    fields.report(
        Code::exercise_answer, fields.span(), std::string(what) + " does not fit the scene: " + first.message,
        first.hint);
}

/// The texts under a key, without their places.
std::vector<std::string> plain_texts(Fields& fields, std::string_view key) {
    std::vector<std::string> texts;
    const auto given = fields.texts(key);
    for (const auto& text : given ? given->value : std::vector<Located<std::string>>()) {
        texts.push_back(text.value);
    }
    return texts;
}

void read_formula_keys(Fields& fields, Exercise& exercise, toml::table& claim) {
    if (const auto formula = fields.formula("formula")) {
        exercise.formula = formula->value;
        claim.insert("formula", formula->value);
    } else if (exercise.kind == ExerciseKind::pose) {
        claim.insert("formula", "p = p");
        exercise.formula = "p = p";
    }
    copy_keys(fields, format::kSubjectOfFormula, claim);
    exercise.where = plain_texts(fields, "where");
    exercise.given = plain_texts(fields, "given");
}

void read_quantity_keys(Fields& fields, Exercise& exercise, toml::table& claim) {
    copy_keys(fields, format::kMeasured, claim);
    exercise.absolute = true;
    for (const UnitEnding& ending : endings_of(Spelling::any)) {
        const std::string key = std::string("tolerance").append(ending.text);
        const auto tolerance = fields.positive(key);
        if (!tolerance) { continue; }
        exercise.tolerance = tolerance->value;
        claim.insert(key, tolerance->value);
        claim.insert(std::string("value").append(ending.text), 0.0);
    }
}

/// Reads what is asked, as a claim.
void read_asked(Fields& fields, Exercise& exercise) {
    toml::table claim;
    copy_keys(fields, format::kMoment, claim);
    const bool any = exercise.kind == ExerciseKind::code;
    if (any) { claim.insert("any_state", true); }
    fields.at_most_one({"formula", "count", "dropped", "quantity", "choices"});
    if (const auto count = fields.word("count", kCounts)) {
        claim.insert(word_of(kCounts, *count), 0);
        exercise.tolerance = 0.0;
        exercise.absolute = true;
    } else if (const auto dropped = fields.text("dropped")) {
        claim.insert("dropped", dropped->value + " x");
    } else if (fields.has("quantity")) {
        read_quantity_keys(fields, exercise, claim);
    } else {
        read_formula_keys(fields, exercise, claim);
        if (exercise.formula.empty()) {
            fields.missing("formula", "what is asked: a formula, 'count', 'dropped' or 'quantity'");
            return;
        }
        if (const auto tolerance = fields.positive("tolerance")) { exercise.tolerance = tolerance->value; }
        const auto absolute = fields.flag("absolute");
        exercise.absolute = absolute && absolute->value;
    }
    toml::table claims;
    claims.insert("expect", toml::array{claim});
    exercise.asked = table_text(claims);
    check_claims_of(fields, exercise, exercise.asked, "what is asked");
}

void read_computed(Fields& fields, Exercise& exercise) {
    read_asked(fields, exercise);
    if (const auto unit = fields.text("unit")) { exercise.unit = unit->value; }
    exercise.only = plain_texts(fields, "mistakes");
    exercise.branch = plain_texts(fields, "branch");
    if (const auto cases = fields.integer("cases")) { exercise.cases = cases->value; }
}

void read_choices(Fields& fields, Exercise& exercise) {
    for (Fields& choice : fields.tables("choices", kMostItems)) {
        choice.call("the choice");
        ExerciseChoice read;
        choice.require("text", "the words of the choice");
        if (const auto text = choice.words("text")) { read.text = text->value; }
        if (const auto why = choice.words("why")) { read.why = why->value; }
        const auto right = choice.flag("right");
        if (right && right->value) { exercise.right_choice = static_cast<int>(exercise.choices.size()); }
        choice.finish();
        exercise.choices.push_back(std::move(read));
    }
    if (exercise.choices.size() < 2) {
        fields.report(
            Code::wrong_count, fields.span("choices"),
            "expected two choices or more, one of them with right = true");
    }
}

void read_items(Fields& fields, Exercise& exercise) {
    fields.require("items", "sentences in their right order");
    const auto items = fields.list_of_words("items");
    if (!items) { return; }
    exercise.items = items->value;
    if (exercise.items.size() < 3 || exercise.items.size() > kMostItems) {
        fields.report(
            Code::wrong_count, items->span, "expected 3 to " + std::to_string(kMostItems) + " items");
    }
}

/// Reads the hidden claims; without any, those of the scene are used.
void read_hidden(Fields& fields, Exercise& exercise) {
    if (const toml::node* const expect = fields.raw("expect")) {
        toml::table claims;
        claims.insert("expect", *expect);
        exercise.expect = table_text(claims);
        check_claims_of(fields, exercise, exercise.expect, "what is expected");
    }
    if (const auto most = fields.integer("most")) { exercise.most = most->value; }
}

void read_spoil(Fields& fields, Exercise& exercise) {
    fields.require(
        "spoil", "changes that put faults into the scene: { key = \"joint.B.axis\", value = [1, 0, 0] }");
    exercise.spoil = read_edits(fields, "spoil");
    const EditedScene sick = with_edits(exercise.scene, exercise.spoil);
    if (!exercise.scene.empty() && !sick.problem.empty()) {
        fields.report(
            Code::exercise_edit, fields.span("spoil"), sick.problem + "; expected keys of the scene");
    }
}

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
            fields.report(
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
        fields.report(
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
            fields.report(Code::wrong_count, fields.span("values"), "expected a list of two values or more");
        }
    } else {
        read_range(fields, draw);
    }
    fields.finish();
    return draw;
}

}  // namespace

std::vector<SceneEdit> read_edits(Fields& fields, std::string_view key) {
    std::vector<SceneEdit> edits;
    for (Fields& edit : fields.tables(key, kMostEdits)) {
        edit.call("the change");
        edit.require("key", "what is changed, such as \"joint.B.axis\"");
        SceneEdit change;
        if (const auto place = edit.text("key")) { change.key = place->value; }
        change.value = toml_of(edit, "value");
        edit.finish();
        edits.push_back(std::move(change));
    }
    return edits;
}

void read_answer(Fields& fields, Exercise& exercise) {
    switch (exercise.kind) {
        case ExerciseKind::number:
        case ExerciseKind::vector:
        case ExerciseKind::matrix:
        case ExerciseKind::pose:
        case ExerciseKind::code: return read_computed(fields, exercise);
        case ExerciseKind::choose:
            return fields.has("choices") ? read_choices(fields, exercise) : read_computed(fields, exercise);
        case ExerciseKind::order: return read_items(fields, exercise);
        case ExerciseKind::repair: read_hidden(fields, exercise); return read_spoil(fields, exercise);
        case ExerciseKind::build:
            read_hidden(fields, exercise);
            fields.require("solution", "joints that solve it, as they stand in a lesson file");
            if (const auto solution = fields.text("solution")) { exercise.solution = solution->value; }
            return;
        case ExerciseKind::experiment:
            read_hidden(fields, exercise);
            fields.require("do", "a list of experiments that solves it");
            exercise.does = plain_texts(fields, "do");
            return;
    }
}

void read_draws(Fields& fields, Exercise& exercise) {
    for (Fields& draw : fields.tables("vary", kMostDraws)) {
        exercise.vary.push_back(read_draw(draw, exercise));
    }
    if (const auto limit = fields.positive("condition_below")) { exercise.condition_below = limit->value; }
}

}  // namespace jw::reading
