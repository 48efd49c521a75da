#include <algorithm>

#include "lessons/diagnostics/text_place.hpp"
#include "lessons/format/claim_keys.hpp"
#include "lessons/formula/symbol_values.hpp"
#include "lessons/read/reading.hpp"
#include "lessons/typed/exact_text.hpp"

namespace jw::reading {

namespace {

constexpr std::size_t kMostClaims = 5000;

using Facts = std::vector<std::pair<Fact, SourceSpan>>;

/// Reads a time of [motion] or of the motion by masses and forces: the one that the lesson has, or the one
/// that `of` names.
std::optional<Moment> read_time(Fields& fields, const Lesson& lesson) {
    const auto t = fields.number("at_s");
    const auto of = fields.word("of");
    if (!t) { return std::nullopt; }
    const bool by_forces = of ? *of == 1 : !lesson.motion && lesson.dynamics.has_value();
    const auto& motion = lesson.motion;
    const std::string none =
        "there is no motion at " + writing::number_text(t->value) + " s; expected a time ";
    if (by_forces) {
        if (!lesson.dynamics || t->value < 0.0 || t->value > lesson.dynamics->duration) {
            fields.report(Code::no_motion, t->span, none + "from 0 to 'duration' of [dynamics]");
        }
    } else if (!motion || t->value < motion->from || t->value > motion->to) {
        fields.report(Code::no_motion, t->span, none + "between 'from_s' and 'to_s' of [motion]");
    }
    return AtTime{t->value, by_forces};
}

std::optional<Moment> at_rest(Fields& fields, const Lesson& lesson, SourceSpan span) {
    if (lesson.dynamics) { return AtRest{}; }
    fields.report(
        Code::no_motion, span, "no forces lead to an equilibrium; expected masses and a table [dynamics]");
    return std::nullopt;
}

std::optional<Moment> read_moment(Fields& fields, const Reading& reading) {
    if (!fields.at_most_one({"after", "at_s", "at_rest", "as_given", "any_state"})) { return std::nullopt; }
    if (fields.has("at_s")) { return read_time(fields, reading.lesson); }
    if (fields.has("after")) {
        const auto name = fields.text("after");
        const Named* named = name ? reading.addition(*name) : nullptr;
        if (named == nullptr) { return std::nullopt; }
        return AfterAddition{reading.place_of(*named) + 1};
    }
    const auto is_set = [&](const char* key) {
        const auto flag = fields.flag(key);
        return flag && flag->value;
    };
    if (is_set("at_rest")) { return at_rest(fields, reading.lesson, fields.span("at_rest")); }
    if (is_set("as_given")) { return AsGiven{}; }
    if (is_set("any_state")) { return AnyState{}; }
    return AfterAddition{static_cast<int>(reading.lesson.order.size())};
}

void read_plain_facts(Fields& fields, const std::optional<Moment>& when, Facts& facts) {
    for (const EnumWord<Count>& count : kCounts) {
        if (const auto value = fields.integer(count.word)) {
            facts.emplace_back(CountClaim{count.value, value->value}, value->span);
        }
    }
    for (const EnumWord<Bound>& bound : kBounds) {
        if (const auto value = fields.positive(bound.word)) {
            facts.emplace_back(BoundClaim{bound.value, value->value}, value->span);
        }
    }
    for (const EnumWord<Verdict>& verdict : kVerdicts) {
        if (const auto value = fields.flag(verdict.word)) {
            const bool is_at_rest = when && std::holds_alternative<AtRest>(*when);
            if (verdict.value == Verdict::closes && is_at_rest) {
                fields.report(
                    Code::no_motion, value->span,
                    "'closes' cannot be claimed of an equilibrium, which is assembled; expected another "
                    "moment, or 'stable'");
            }
            if (verdict.value == Verdict::stable && when && !is_at_rest) {
                fields.report(
                    Code::no_motion, value->span,
                    "only an equilibrium is stable or not; expected 'at_rest = true' beside 'stable'");
            }
            facts.emplace_back(VerdictClaim{verdict.value, value->value}, value->span);
        }
    }
}

/// Keys of facts: a claim needs one of them.
std::vector<std::string> keys_of_facts() {
    std::vector<std::string> keys = words_in<format::kFacts>();
    keys.insert(keys.end(), {"quantity", "formula"});
    return keys;
}

/// "hinge p1 z": the joint's name may have blanks, the last two words are primitive and component.
void read_dropped(Fields& fields, const Reading& reading, const std::optional<Moment>& when, Facts& facts) {
    const auto text = fields.text("dropped");
    if (!text) { return; }
    const std::string& t = text->value;
    const std::string ending = t.size() > 5 ? t.substr(t.size() - 5) : "";
    const auto component = ending.empty() ? std::string::npos : std::string("xyz").find(ending[4]);
    const bool is_p1 = ending.starts_with(" p1 ");
    if (component == std::string::npos || (!is_p1 && !ending.starts_with(" p2 "))) {
        fields.report(
            Code::unknown_equation, text->span,
            in_quotes(t) + " names no equation; expected \"JOINT p1 x\", p1 or p2 and x, y or z");
        return;
    }
    const std::string name = t.substr(0, t.size() - 5);
    const Named* joint = reading.joint({name, text->span});
    if (joint == nullptr || !joint->sound) { return; }
    const Role role = is_p1 ? Role::axes_parallel : Role::distance_parallel;
    const JointType& type = *reading.joint_at(joint->index).type;
    if (!type.uses(role)) {
        fields.report(
            Code::unknown_equation, text->span,
            "joint " + in_quotes(name) + " of type " + std::string(type.name) + " has no " +
                (is_p1 ? "p1" : "p2") + "; expected a primitive that it is made of");
    }
    const auto* after = when ? std::get_if<AfterAddition>(&*when) : nullptr;
    if (after != nullptr && reading.place_of(*joint) >= after->count) {
        fields.report(
            Code::not_added_yet, text->span,
            "joint " + in_quotes(name) + " has not been added by then; expected a later 'after'");
    }
    facts.emplace_back(DroppedClaim{joint->index, role, static_cast<int>(component)}, text->span);
}

void read_value(Fields& fields, QuantityClaim& claim) {
    const std::vector<std::string> endings = unit_endings(claim.quantity, claim.derivative);
    std::vector<std::string> keys;
    for (const std::string& ending : endings) { keys.push_back("value" + ending); }
    if (!fields.at_most_one(keys)) {
        for (const std::string& ending : endings) { fields.has("tolerance" + ending); }
        return;
    }
    const bool second = endings.size() > 1 && fields.has(keys[1]);
    const std::string& ending = endings[second ? 1 : 0];
    const std::string unit = endings.size() > 1 ? ", in degrees or radians" : "";
    fields.require("value" + ending, "the value of " + in_quotes(claim.text) + unit);
    fields.require("tolerance" + ending, "the largest allowed deviation, in the unit of the value");
    claim.in_degrees = ending.starts_with("_deg");
    const auto in_si = [&](double typed) { return claim.in_degrees ? radians(typed) : typed; };
    if (const auto value = fields.number("value" + ending)) { claim.value = in_si(value->value); }
    if (const auto tolerance = fields.positive("tolerance" + ending)) {
        claim.tolerance = in_si(tolerance->value);
    }
}

/// Reads the key `derivative`; `of` says how many derivatives the quantity has and how many are part of its
/// name.
int read_derivative(
    Fields& fields, const std::optional<Moment>& when, const std::optional<NamedQuantity>& of,
    SourceSpan name) {
    const int named = of ? of->derivative : 0;
    const int most = of ? derivatives_of(of->quantity) - named : 2;
    const auto derivative = fields.integer("derivative", 0, most);
    const bool moves = !when || std::holds_alternative<AtTime>(*when);
    const bool is_rate = named > 0 || (derivative && derivative->value > 0);
    if (is_rate && !moves) {
        fields.report(
            Code::rate_at_rest, derivative ? derivative->span : name,
            std::string(
                when && std::holds_alternative<AtRest>(*when) ? "nothing moves at rest"
                                                              : "nothing moves before the motion") +
                "; expected 'at_s' beside " + (derivative ? "'derivative'" : "a rate"));
    }
    const bool of_forces =
        of && needs_masses(of->quantity) && !std::holds_alternative<EnergyQuantity>(of->quantity);
    if (of_forces && !moves && !std::holds_alternative<AtRest>(*when)) {
        fields.report(
            Code::rate_at_rest, name,
            "reactions belong to a motion or an equilibrium; expected 'at_s' or 'at_rest' beside them");
    }
    return derivative ? derivative->value : 0;
}

void read_measured(Fields& fields, const Reading& reading, const std::optional<Moment>& when, Facts& facts) {
    const auto text = fields.text("quantity");
    if (!text) { return; }
    QuantityClaim claim;
    claim.text = text->value;
    const auto quantity = read_quantity(fields, *text, reading);
    claim.derivative = read_derivative(fields, when, quantity, text->span);
    if (!quantity) {
        // the quantity decides which keys belong to it: only keys of no quantity are reported as unknown
        for (const UnitEnding& ending : endings_of(Spelling::any)) {
            fields.number(std::string("value").append(ending.text));
            fields.positive(std::string("tolerance").append(ending.text));
        }
        fields.vector("point");
        return;
    }
    claim.quantity = quantity->quantity;
    claim.named_derivative = quantity->derivative;
    claim.derivative += claim.named_derivative;
    read_value(fields, claim);
    facts.emplace_back(claim, text->span);
}

void read_joint(Fields& fields, const Reading& reading, formula::Subject& subject) {
    const auto name = fields.text("joint");
    const Named* const joint = name ? reading.joint(*name) : nullptr;
    if (joint == nullptr || !joint->sound) { return; }
    subject.joint = joint->index;
    const JointType& type = *reading.joint_at(joint->index).type;
    std::vector<std::string> words;
    for (const Role role : type.roles) { words.emplace_back(word_of(role)); }
    if (const auto word = fields.word("primitive", words)) { subject.role = type.roles[*word]; }
}

formula::Subject read_subject(Fields& fields, const Reading& reading) {
    formula::Subject subject;
    fields.at_most_one({"joint", "body"});
    if (fields.has("joint")) {
        read_joint(fields, reading, subject);
    } else if (const auto name = fields.text("body")) {
        const Named* const body = reading.body(*name);
        if (body != nullptr) { subject.body = body->index; }
    } else {
        subject.coordinates = fields.word("coordinates", kChoices).value_or(subject.coordinates);
    }
    return subject;
}

/// Evaluates the formula in a random state, where only its symbols and shapes can be wrong.
void try_out(Fields& fields, const Reading& reading, const formula::Formula& formula, bool holds) {
    // other mistakes would only be reported twice
    if (reading.problems->errors_count() > 0) { return; }
    const Mechanism& mechanism = reading.lesson.mechanism;
    Instant instant =
        formula::arbitrary_instant(std::make_shared<const System>(mechanism, everything(mechanism)), 0);
    if (reading.lesson.dynamics) {
        instant.scene =
            std::make_shared<const Centroidal>(centroidal(mechanism, reading.lesson.dynamics->loads));
    }
    const formula::Outcome outcome = formula::evaluate_at(formula, instant);
    // shapes that do not fit may be the misprint; in other states, a function may have a value
    if (!outcome.problem || (outcome.misfit && !holds) || outcome.no_value) { return; }
    const math::Problem& problem = *outcome.problem;
    reading.report(
        Code::formula_without_value,
        outcome.definition < 0 ? fields.place_in("formula", problem.at) : fields.span("where"),
        problem.message, problem.hint);
}

/// The key `formula` and those that belong to it; nothing if there is none, or it is wrong.
std::optional<FormulaClaim> read_formula_claim(Fields& fields, const Reading& reading) {
    if (!fields.has("formula")) { return std::nullopt; }
    const int errors = reading.problems->errors_count();
    FormulaClaim claim;
    const auto source = fields.formula("formula");
    claim.formula.subject = read_subject(fields, reading);
    if (const auto where = fields.texts("where")) {
        for (const Located<std::string>& definition : where->value) {
            if (const auto problem = math::read_math(definition.value).problem) {
                reading.report(
                    Code::unreadable_formula,
                    place_in_text(reading.problems->source(), definition.span, problem->at), problem->message,
                    problem->hint);
            }
            claim.formula.where.push_back(definition.value);
        }
    }
    if (const auto holds = fields.flag("holds")) { claim.holds = holds->value; }
    if (!source || reading.problems->errors_count() > errors) { return std::nullopt; }
    claim.formula.source = source->value;
    try_out(fields, reading, claim.formula, claim.holds);
    return claim;
}

void read_claim(Fields& fields, Reading& reading) {
    fields.call("the claim");
    const auto when = read_moment(fields, reading);
    const auto why = fields.words("why", Audience::authors);
    Facts facts;
    read_plain_facts(fields, when, facts);
    read_dropped(fields, reading, when, facts);
    read_measured(fields, reading, when, facts);
    const bool only_formulas = facts.empty();
    if (auto claim = read_formula_claim(fields, reading)) {
        facts.emplace_back(std::move(*claim), fields.span("formula"));
    }
    if (!only_formulas && when && std::holds_alternative<AnyState>(*when)) {
        reading.report(
            Code::only_formulas, fields.span("any_state"),
            "only a formula can hold in any state; expected another moment for the other claims");
    }
    static const std::vector<std::string> kFacts = keys_of_facts();
    if (std::ranges::none_of(kFacts, [&](const std::string& key) { return fields.has(key); })) {
        reading.report(
            Code::missing_key, fields.span(),
            "the claim is empty; expected one or several of " + comma_list(kFacts));
    }
    fields.finish();
    if (!when) { return; }
    for (auto& [fact, span] : facts) {
        reading.lesson.claims.push_back({*when, fact, span, why ? why->value : Text()});
    }
}

}  // namespace

void read_claims(Fields& root, Reading& reading) {
    for (Fields& fields : root.tables("expect", kMostClaims)) { read_claim(fields, reading); }
}

}  // namespace jw::reading
