#include <algorithm>
#include <numbers>
#include <sstream>

#include "lessons/reading.hpp"

namespace jw::reading {

namespace {

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);) { parts.push_back(part); }
    return parts;
}

std::optional<int> axis_of(const std::string& text) {
    if (text == "x") { return 0; }
    if (text == "y") { return 1; }
    if (text == "z") { return 2; }
    return std::nullopt;
}

const char* kQuantityForms =
    "expected JOINT.angle, JOINT.displacement, BODY.x, BODY.e0, BODY.omega.x, BODY.omega_local.x or, with "
    "'point', BODY.point.x";

/// "hinge.angle", "crank.x", "crank.omega.z" ... -> what to measure and its unit.
std::optional<std::pair<Quantity, Unit>> quantity_of(
    Fields& fields, const Located<std::string>& text, const Reading& reading) {
    const std::vector<std::string> parts = split(text.value, '.');
    const auto fail = [&](const std::string& message) {
        fields.problems().add(text.span, message + "; " + kQuantityForms);
        return std::nullopt;
    };
    if (parts.size() < 2) { return fail("'" + text.value + "' is no quantity"); }
    const Mechanism& mechanism = reading.lesson.mechanism;

    const auto joint = std::ranges::find(mechanism.joints, parts[0], &Joint::name);
    if (joint != mechanism.joints.end() && parts.size() == 2) {
        const int index = static_cast<int>(joint - mechanism.joints.begin());
        MeasureQuantity quantity{ThetaMeasure{}, joint->body_i, joint->body_j, index};
        if (parts[1] == "angle") {
            if (joint->type->artificial == 0) { quantity.measure = angle_of(*joint); }
            return std::pair<Quantity, Unit>(quantity, Unit::radian);
        }
        if (parts[1] == "displacement") {
            quantity.measure = displacement_of(*joint);
            return std::pair<Quantity, Unit>(quantity, Unit::metre);
        }
        return fail("joint '" + parts[0] + "' has no quantity '" + parts[1] + "'");
    }
    const auto body = std::ranges::find(mechanism.bodies, parts[0], &Body::name);
    if (body == mechanism.bodies.end()) {
        std::vector<std::string> names = reading.body_names();
        const std::vector<std::string> joints = reading.joint_names();
        names.insert(names.end(), joints.begin(), joints.end());
        fields.problems().add(
            text.span, "no body or joint '" + parts[0] + "'; expected one of " + comma_list(names),
            did_you_mean(parts[0], names));
        return std::nullopt;
    }
    const int index = static_cast<int>(body - mechanism.bodies.begin());
    if (parts.size() == 2) {
        if (const auto axis = axis_of(parts[1])) {
            return std::pair<Quantity, Unit>(
                MeasureQuantity{CoordinateMeasure{*axis}, 0, index, -1}, Unit::metre);
        }
        if (parts[1].size() == 2 && parts[1][0] == 'e' && parts[1][1] >= '0' && parts[1][1] <= '3') {
            return std::pair<Quantity, Unit>(
                MeasureQuantity{CoordinateMeasure{3 + parts[1][1] - '0'}, 0, index, -1}, Unit::none);
        }
        return fail("body '" + parts[0] + "' has no quantity '" + parts[1] + "'");
    }
    const auto axis = axis_of(parts[2]);
    if (!axis || parts.size() != 3) { return fail("'" + text.value + "' is no quantity"); }
    if (parts[1] == "omega" || parts[1] == "omega_local") {
        return std::pair<Quantity, Unit>(
            AngularVelocityQuantity{index, parts[1] == "omega_local", *axis}, Unit::radian_per_second);
    }
    if (parts[1] == "point") {
        const auto point = fields.vector("point");
        return std::pair<Quantity, Unit>(
            PointQuantity{index, point ? point->value : Vec3::Zero(), *axis}, Unit::metre);
    }
    return fail("body '" + parts[0] + "' has no quantity '" + parts[1] + "'");
}

std::optional<Moment> read_moment(Fields& fields, const Reading& reading) {
    if (!fields.at_most_one({"after", "at_s", "as_given"})) { return std::nullopt; }
    const Lesson& lesson = reading.lesson;
    if (const auto t = fields.number("at_s")) {
        if (lesson.motion && (t->value < lesson.motion->from || t->value > lesson.motion->to)) {
            fields.problems().add(
                t->span, "'at_s' lies outside the motion; expected a time from 'from_s' to 'to_s'");
        }
        if (!lesson.motion) {
            fields.problems().add(
                t->span, "'at_s' without a motion; expected a [motion] table in the lesson");
        }
        return AtTime{t->value};
    }
    if (const auto given = fields.flag("as_given"); given && given->value) { return AsGiven{}; }
    const auto after = fields.text("after");
    if (!after) { return AfterAddition{static_cast<int>(lesson.order.size())}; }
    std::vector<std::string> names;
    for (std::size_t k = 0; k < lesson.order.size(); ++k) {
        const Addition& a = lesson.order[k];
        const auto index = static_cast<std::size_t>(a.index);
        const std::string& name = a.kind == Addition::Kind::joint ? lesson.mechanism.joints[index].name
                                                                  : lesson.mechanism.drivers[index].name;
        if (name == after->value) { return AfterAddition{static_cast<int>(k) + 1}; }
        names.push_back(name);
    }
    fields.problems().add(
        after->span, "no joint or driver '" + after->value + "'; expected one of " + comma_list(names),
        did_you_mean(after->value, names));
    return std::nullopt;
}

std::optional<Fact> read_dropped(Fields& fields, const Reading& reading) {
    const auto text = fields.text("dropped");
    if (!text) { return std::nullopt; }
    const std::vector<std::string> parts = split(text->value, ' ');
    const auto axis = parts.size() == 3 ? axis_of(parts[2]) : std::nullopt;
    if (!axis || (parts[1] != "p1" && parts[1] != "p2")) {
        fields.problems().add(
            text->span, "'" + text->value + "' names no equation; expected \"JOINT p1 x\" or \"JOINT p2 z\"");
        return std::nullopt;
    }
    const auto joint = reading.joint({parts[0], text->span});
    if (!joint) { return std::nullopt; }
    const Role role = parts[1] == "p1" ? Role::axes_parallel : Role::distance_parallel;
    if (!reading.lesson.mechanism.joints[static_cast<std::size_t>(*joint)].type->uses(role)) {
        fields.problems().add(text->span, "joint '" + parts[0] + "' has no " + parts[1] + " equations");
        return std::nullopt;
    }
    return DroppedClaim{*joint, role, *axis};
}

std::optional<Fact> read_quantity(Fields& fields, const Reading& reading) {
    const auto text = fields.text("quantity");
    if (!text) { return std::nullopt; }
    QuantityClaim claim;
    claim.text = text->value;
    const auto quantity = quantity_of(fields, *text, reading);
    if (const auto derivative = fields.integer("derivative")) {
        claim.derivative = derivative->value;
        if (derivative->value < 0 || derivative->value > 2) {
            fields.problems().add(derivative->span, "'derivative' is out of range; expected 0, 1 or 2");
            return std::nullopt;
        }
    }
    if (!fields.at_most_one({"value", "value_deg"})) { return std::nullopt; }
    claim.in_degrees = fields.has("value_deg");
    const double factor = claim.in_degrees ? std::numbers::pi / 180.0 : 1.0;
    const std::string suffix = claim.in_degrees ? "_deg" : "";
    const auto value = fields.number("value" + suffix);
    const auto tolerance = fields.positive("tolerance" + suffix);
    if (!fields.has("value" + suffix)) { fields.missing("value", "the value that the quantity has"); }
    if (!fields.has("tolerance" + suffix)) { fields.missing("tolerance" + suffix, "how far it may be off"); }
    if (!quantity || !value || !tolerance) { return std::nullopt; }
    claim.quantity = quantity->first;
    claim.unit = quantity->second;
    claim.value = factor * value->value;
    claim.tolerance = factor * tolerance->value;
    return claim;
}

void read_claim(Fields& fields, Reading& reading) {
    const auto when = read_moment(fields, reading);
    std::string why;
    if (const auto text = fields.text("why")) { why = text->value; }
    std::vector<std::pair<Fact, SourceSpan>> facts;
    const auto count = [&](const char* key, Count what) {
        if (const auto value = fields.integer(key)) {
            facts.push_back({CountClaim{what, value->value}, value->span});
        }
    };
    count("rank", Count::rank);
    count("rows", Count::rows);
    count("columns", Count::columns);
    count("dof", Count::dof);
    count("redundant", Count::redundant);
    count("mobility_by_counting", Count::mobility_by_counting);
    const auto bound = [&](const char* key, Bound what) {
        if (const auto value = fields.positive(key)) {
            facts.push_back({BoundClaim{what, value->value}, value->span});
        }
    };
    bound("residual_below", Bound::residual_below);
    bound("condition_below", Bound::condition_below);
    bound("condition_above", Bound::condition_above);
    const auto verdict = [&](const char* key, Verdict what) {
        if (const auto value = fields.flag(key)) {
            facts.push_back({VerdictClaim{what, value->value}, value->span});
        }
    };
    verdict("change_point", Verdict::change_point);
    verdict("closes", Verdict::closes);
    if (const auto dropped = read_dropped(fields, reading)) {
        facts.push_back({*dropped, fields.span("dropped")});
    }
    if (const auto quantity = read_quantity(fields, reading)) {
        facts.push_back({*quantity, fields.span("quantity")});
    }
    const bool tried = fields.has("dropped") || fields.has("quantity");
    fields.finish();
    if (facts.empty() && !tried) {
        reading.problems->add(
            fields.span(), "the claim says nothing; expected rank, dof, dropped, quantity or another fact");
    }
    if (!when) { return; }
    for (auto& [fact, span] : facts) { reading.lesson.claims.push_back({*when, fact, span, why}); }
}

}  // namespace

void read_claims(Fields& root, Reading& reading) {
    for (Fields& fields : root.tables("expect")) { read_claim(fields, reading); }
}

}  // namespace jw::reading
