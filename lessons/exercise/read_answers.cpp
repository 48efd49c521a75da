#include <array>
#include <cmath>
#include <sstream>

#include "lessons/exercise/read_exercise_parts.hpp"
#include "lessons/exercise/read_exercises.hpp"
#include "lessons/exercise/scene_edits.hpp"
#include "lessons/format/claim_keys.hpp"
#include "lessons/read/reader.hpp"
#include "lessons/typed/exact_text.hpp"

namespace jw::reading {

namespace {

constexpr std::size_t kMostItems = 10;
constexpr std::size_t kMostEdits = 50;

std::string text_of_table(const toml::table& table) {
    std::ostringstream out;
    out << toml::toml_formatter{table};
    return out.str() + "\n";
}

/// A value as its author may have written it: toml++ writes 0.4 as 0.40000000000000002.
std::string value_text(const toml::node& node) {
    if (const toml::array* const array = node.as_array()) {
        std::string list;
        for (const toml::node& entry : *array) { list += (list.empty() ? "" : ", ") + value_text(entry); }
        return "[" + list + "]";
    }
    const toml::value<double>* const number = node.as_floating_point();
    if (number != nullptr && std::isfinite(number->get())) {
        const std::string text = writing::number_text(number->get());
        // a TOML number that is not an integer must not become one
        return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
    }
    std::ostringstream out;
    node.visit([&](const auto& value) { out << value; });
    return out.str();
}

/// Copies the keys of [[expect]] that are present.
void copy_keys(Fields& fields, std::span<const Key> keys, toml::table& to) {
    for (const Key& key : keys) {
        if (const toml::node* const node = fields.raw(key.name)) { to.insert(key.name, *node); }
    }
}

/// Reads the scene with these claims; mistakes in them are reported at the exercise.
void check_claims_of(
    Fields& fields, const Exercise& exercise, const std::string& claims, std::string_view what) {
    // other mistakes would only be reported twice
    if (exercise.scene.empty() || fields.problems().errors_count() > 0) { return; }
    const ReadResult read = read_lesson_with_claims(exercise.scene, exercise.scene_name, claims);
    if (read.lesson) { return; }
    const Diagnostic& first = read.diagnostics.front();
    fields.problems().add(
        Code::exercise_answer, fields.span(), std::string(what) + " does not fit the scene: " + first.message,
        first.hint);
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
    if (const auto where = fields.texts("where")) {
        for (const Located<std::string>& definition : where->value) {
            exercise.where.push_back(definition.value);
        }
    }
    if (const auto given = fields.texts("given")) {
        for (const Located<std::string>& symbol : given->value) { exercise.given.push_back(symbol.value); }
    }
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
    exercise.asked = text_of_table(claims);
    check_claims_of(fields, exercise, exercise.asked, "what is asked");
}

void read_computed(Fields& fields, Exercise& exercise) {
    read_asked(fields, exercise);
    if (const auto unit = fields.text("unit")) { exercise.unit = unit->value; }
    if (const auto only = fields.texts("mistakes")) {
        for (const Located<std::string>& name : only->value) { exercise.only.push_back(name.value); }
    }
    if (const auto branch = fields.texts("branch")) {
        for (const Located<std::string>& action : branch->value) { exercise.branch.push_back(action.value); }
    }
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
        fields.problems().add(
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
        fields.problems().add(
            Code::wrong_count, items->span, "expected 3 to " + std::to_string(kMostItems) + " items");
    }
}

/// Reads the hidden claims; without any, those of the scene are used.
void read_hidden(Fields& fields, Exercise& exercise) {
    if (const toml::node* const expect = fields.raw("expect")) {
        toml::table claims;
        claims.insert("expect", *expect);
        exercise.expect = text_of_table(claims);
        check_claims_of(fields, exercise, exercise.expect, "what is expected");
    }
    if (const auto most = fields.integer("most")) { exercise.most = most->value; }
}

void read_spoil(Fields& fields, Exercise& exercise) {
    fields.require(
        "spoil", "changes that make the scene sick: { key = \"joint.B.axis\", value = [1, 0, 0] }");
    exercise.spoil = read_edits(fields, "spoil");
    const EditedScene sick = with_edits(exercise.scene, exercise.spoil);
    if (!exercise.scene.empty() && !sick.problem.empty()) {
        fields.problems().add(
            Code::exercise_edit, fields.span("spoil"), sick.problem + "; expected keys of the scene");
    }
}

std::vector<std::string> read_actions(Fields& fields) {
    std::vector<std::string> actions;
    fields.require("do", "a list of experiments that solves it");
    if (const auto list = fields.texts("do")) {
        for (const Located<std::string>& action : list->value) { actions.push_back(action.value); }
    }
    return actions;
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

std::string toml_of(Fields& fields, std::string_view key) {
    const toml::node* const node = fields.raw(key);
    if (node == nullptr) { return {}; }
    return value_text(*node);
}

std::vector<std::string> list_of_toml(Fields& fields, std::string_view key) {
    std::vector<std::string> entries;
    const toml::node* const node = fields.raw(key);
    if (node == nullptr || !node->is_array()) { return entries; }
    for (const toml::node& entry : *node->as_array()) { entries.push_back(value_text(entry)); }
    return entries;
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
            exercise.does = read_actions(fields);
            return;
    }
}

}  // namespace jw::reading
