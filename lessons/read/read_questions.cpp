#include <algorithm>

#include "core/quantity/names.hpp"
#include "lessons/read/reading.hpp"

namespace jw::reading {

namespace {

constexpr std::size_t kMostQuestions = 200;
constexpr std::size_t kMostChoices = 8;
constexpr std::size_t kMostActions = 20;

void check_motion(const Reading& reading, const SourceSpan& span) {
    if (reading.lesson.motion || reading.lesson.dynamics) { return; }
    reading.report(
        Code::no_motion, span, "the lesson has no motion; expected a table [motion] or [dynamics]");
}

bool read_place(Fields& fields, const Reading& reading, Question& question) {
    fields.require("at", "\"bodies\", \"motion\", or the joint or driver before which it is asked");
    const auto at = fields.text("at");
    if (!at) { return false; }
    if (at->value == "bodies" || at->value == "motion") {
        question.place = at->value == "bodies" ? Question::Place::bodies : Question::Place::motion;
        if (question.place == Question::Place::motion) { check_motion(reading, at->span); }
        return true;
    }
    const Named* const named = reading.addition(*at);
    if (named == nullptr) { return false; }
    question.addition = named->addition();
    return true;
}

std::optional<Answer> read_count(Fields& fields, const Reading& /*reading*/) {
    const auto count = fields.word("count", kCounts);
    return count ? std::optional<Answer>(CountAnswer{*count}) : std::nullopt;
}

/// "hinge p1"
std::optional<Answer> read_dropped_answer(Fields& fields, const Reading& reading) {
    const auto text = fields.text("dropped");
    if (!text) { return std::nullopt; }
    const std::size_t blank = text->value.rfind(' ');
    const std::string primitive = blank == std::string::npos ? "" : text->value.substr(blank + 1);
    const auto parallel = {Role::axes_parallel, Role::distance_parallel};
    const auto* const role = std::ranges::find_if(parallel, [&](Role r) { return word_of(r) == primitive; });
    if (role == parallel.end()) {
        reading.report(
            Code::unknown_equation, text->span,
            in_quotes(text->value) + " names no pair of equations; expected \"JOINT p1\" or \"JOINT p2\"");
        return std::nullopt;
    }
    const Named* const joint = reading.joint({text->value.substr(0, blank), text->span});
    if (joint == nullptr || !joint->sound) { return std::nullopt; }
    if (!reading.joint_at(joint->index).type->uses(*role)) {
        reading.report(
            Code::unknown_equation, text->span,
            "this joint has no " + primitive + "; expected a primitive that it is made of");
        return std::nullopt;
    }
    return DroppedAnswer{joint->index, *role};
}

std::optional<Answer> read_quantity_answer(Fields& fields, const Reading& reading) {
    const auto text = fields.text("quantity");
    if (!text) { return std::nullopt; }
    fields.require("at_s", "the time of the motion at which it is asked for");
    const auto t = fields.number("at_s");
    const auto named = read_quantity(fields, *text, reading);
    if (!named || !t) { return std::nullopt; }
    QuantityAnswer answer{named->quantity, text->value, named->derivative, {}, false, 0.0};
    const Lesson& lesson = reading.lesson;
    answer.when = {t->value, !lesson.motion && lesson.dynamics.has_value()};
    const std::vector<std::string> endings = unit_endings(named->quantity, named->derivative);
    const bool is_angle = endings.size() > 1;
    const bool in_rad = is_angle && fields.has("tolerance" + endings[1]);
    const std::string key = "tolerance" + endings[in_rad ? 1 : 0];
    fields.require(key, "the largest deviation that counts as right");
    const auto tolerance = fields.positive(key);
    if (!tolerance) { return std::nullopt; }
    answer.in_degrees = is_angle && !in_rad;
    answer.tolerance = answer.in_degrees ? radians(tolerance->value) : tolerance->value;
    return answer;
}

std::optional<Answer> read_choice(Fields& fields, const Reading& reading) {
    const auto choices = fields.list_of_words("choices");
    if (!choices) { return std::nullopt; }
    const auto count = choices->value.size();
    fields.require("answer", "the number of the right choice, from 1");
    const auto right = fields.integer("answer", 1, static_cast<int>(std::max<std::size_t>(1, count)));
    if (count < 2 || count > kMostChoices) {
        reading.report(
            Code::wrong_count, choices->span,
            std::to_string(count) + (count == 1 ? " choice" : " choices") + "; expected 2 to " +
                std::to_string(kMostChoices));
        return std::nullopt;
    }
    if (!right) { return std::nullopt; }
    return ChoiceAnswer{choices->value, right->value - 1};
}

/// The names of the key `right`.
std::vector<Thing> read_right_things(Fields& fields, const Reading& reading, Thing::Kind kind) {
    std::vector<Thing> things;
    const auto names = fields.texts("right");
    if (!names) { return things; }
    const Mechanism& mechanism = reading.lesson.mechanism;
    std::vector<std::string> possible;
    for (const Thing& thing : things_of(mechanism, kind)) { possible.push_back(name_of(thing, mechanism)); }
    for (const Located<std::string>& name : names->value) {
        if (const auto thing = thing_named(mechanism, kind, name.value)) {
            things.push_back(*thing);
            continue;
        }
        const std::string word = word_of(kThings, kind);
        reading.report(
            kind == Thing::Kind::row ? Code::unknown_equation : Code::unknown_name, name.span,
            "unknown " + word + " " + in_quotes(name.value) +
                (possible.empty() ? "; there is none in this lesson"
                                  : "; expected one of " + comma_list(possible)),
            did_you_mean(name.value, possible));
    }
    if (names->value.empty()) {
        reading.report(Code::wrong_count, names->span, "no name; expected at least one that is right");
    }
    return things;
}

/// click = "row", and rows = "dropped" or right = ["hinge p1 y"]
std::optional<Answer> read_pointed(Fields& fields, const Reading& reading) {
    const auto kind = fields.word("click", kThings);
    if (!kind) {
        // if the kind is wrong, its other keys are not reported as well
        if (fields.has("click")) { fields.texts("right"); }
        if (fields.has("click")) { fields.word("rows", kRowsFound); }
        return std::nullopt;
    }
    PointedAnswer answer{*kind, {}, {}};
    if (*kind == Thing::Kind::row) {
        const std::vector<std::string> keys{"right", "rows"};
        fields.at_most_one(keys);
        if (const auto found = fields.word("rows", kRowsFound)) { answer.found = *found; }
        if (fields.has("rows")) { return answer.found ? std::optional<Answer>(answer) : std::nullopt; }
    }
    fields.require("right", "names of those that are right, such as [\"hinge s_i\"]");
    answer.right = read_right_things(fields, reading, *kind);
    return answer.right.empty() ? std::nullopt : std::optional<Answer>(answer);
}

/// pose = "crank"
std::optional<Answer> read_pose(Fields& fields, const Reading& reading) {
    const auto name = fields.text("pose");
    if (!name) { return std::nullopt; }
    PoseAnswer answer;
    const bool in_rad = fields.has("tolerance_rad");
    const std::string turn_key = in_rad ? "tolerance_rad" : "tolerance_deg";
    fields.require("tolerance", "how far off the point r of the body may be, in m");
    fields.require(turn_key, "how far off its orientation may be");
    const auto tolerance = fields.positive("tolerance");
    const auto turn = fields.positive(turn_key);
    if (fields.has("at_s")) {
        const auto t = fields.number("at_s");
        if (!t) { return std::nullopt; }
        check_motion(reading, t->span);
        answer.when = AtTime{t->value, !reading.lesson.motion && reading.lesson.dynamics.has_value()};
    }
    const Named* const body = reading.body(*name);
    if (body == nullptr || !tolerance || !turn) { return std::nullopt; }
    answer.body = body->index;
    reading.moves(body->index, name->span);
    answer.tolerance_m = tolerance->value;
    answer.tolerance_rad = in_rad ? turn->value : radians(turn->value);
    return answer;
}

void read_question(Fields& fields, Reading& reading) {
    fields.call("the question");
    Question question;
    question.span = fields.span();
    const bool placed = read_place(fields, reading, question);
    fields.require("ask", "the question");
    if (const auto ask = fields.words("ask")) { question.ask = ask->value; }
    if (const auto why = fields.words("why")) { question.why = why->value; }
    question.ask.drop_line_feeds();
    question.why.drop_line_feeds();
    const std::vector<std::string> kinds{"count", "dropped", "quantity", "choices", "click", "pose"};
    fields.at_most_one(kinds);
    if (std::ranges::none_of(kinds, [&](const std::string& key) { return fields.has(key); })) {
        reading.report(
            Code::missing_key, fields.span(),
            "the question has no answer; expected one of " + comma_list(kinds));
    }
    std::optional<Answer> answer;
    for (auto* read :
         {read_count, read_dropped_answer, read_quantity_answer, read_choice, read_pointed, read_pose}) {
        if (!answer) { answer = read(fields, reading); }
    }
    fields.finish();
    if (!placed || !answer) { return; }
    question.answer = std::move(*answer);
    reading.lesson.questions.push_back(std::move(question));
}

void read_trial(Fields& fields, Lesson& lesson) {
    fields.call("the trial");
    Trial trial;
    trial.span = fields.span();
    fields.require("text", "what to try, and what to look at");
    if (const auto text = fields.words("text")) { trial.text = text->value; }
    trial.text.drop_line_feeds();
    fields.require("do", "a list of experiments in the form that --try takes");
    if (const auto actions = fields.texts("do")) {
        if (actions->value.empty() || actions->value.size() > kMostActions) {
            fields.report(
                Code::wrong_count, actions->span,
                "expected 1 to " + std::to_string(kMostActions) + " experiments");
        }
        for (const Located<std::string>& action : actions->value) { trial.actions.push_back(action.value); }
    }
    if (const auto breaks = fields.flag("breaks")) { trial.breaks = breaks->value; }
    fields.finish();
    lesson.trials.push_back(std::move(trial));
}

}  // namespace

void read_questions(Fields& root, Reading& reading) {
    for (Fields& fields : root.tables("question", kMostQuestions)) { read_question(fields, reading); }
    for (Fields& fields : root.tables("try", kMostQuestions)) { read_trial(fields, reading.lesson); }
}

}  // namespace jw::reading
