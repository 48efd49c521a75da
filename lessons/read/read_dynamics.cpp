#include <algorithm>

#include "core/motion/tolerances.hpp"
#include "lessons/fields/member_keys.hpp"
#include "lessons/format/motion_keys.hpp"
#include "lessons/read/reading.hpp"

namespace jw::reading {

namespace {

void read_method(Fields& fields, DynamicsPlan& plan) {
    SimulationSettings& settings = plan.settings;
    if (const auto method = fields.word("method")) {
        settings.method = kMethods[*method].method;
        plan.method_given = true;
    }
    if (const auto treatment = fields.word("treatment")) {
        settings.treatment = kTreatments[*treatment].treatment;
    }
    const std::string_view unfit = why_not(settings.method, settings.treatment);
    if (fields.has("treatment") && !unfit.empty()) {
        fields.problems().warn(
            Code::unfit_treatment, fields.span("treatment"), std::string(unfit),
            "'simulate' takes another one with --method");
    }
    const bool is_sound = read_members(fields, format::kAccuracy, settings);
    if (!is_tolerance(settings.tolerance)) {
        fields.report(
            Code::out_of_range, fields.span("tolerance"),
            "a tolerance of " + short_number(settings.tolerance) + "; " + std::string(kToleranceRange));
    }
    if (is_sound && fields.has("step") && plan.duration / settings.step > kMostFixedSteps) {
        fields.report(
            Code::too_much, fields.span("step"),
            "steps of " + short_number(settings.step) + " s are " +
                short_number(plan.duration / settings.step, 3) +
                " in 'duration'; expected at most ten million");
    }
}

void read_point(Fields& fields, const Reading& reading, DynamicsPlan& plan) {
    if (auto table = fields.table("point")) {
        const auto point = read_point_of_body(*table, reading);
        if (!table->has("point")) { table->require("at", "the point, global at the start pose, in m"); }
        table->finish();
        if (point && point->point_local) { plan.point = BodyPoint{point->body, *point->point_local}; }
    }
    const auto at_end = fields.vector("point_at_end");
    if (at_end && !fields.has("point")) {
        fields.report(
            Code::lonely_key, at_end->span,
            "'point_at_end' without 'point'; expected the point that it is the end of");
    } else if (at_end) {
        plan.point_at_end = at_end->value;
        plan.point_at_end_span = at_end->span;
    }
}

/// Warns of masses that nothing needs: they are unusual, but not a mistake.
void warn_of_masses(const Reading& reading) {
    const auto given = std::ranges::find_if(reading.masses, &ReadMass::given);
    if (given == reading.masses.end()) { return; }
    reading.problems->warn(
        Code::idle_mass, given->span, "masses have no effect in a lesson without [dynamics]",
        "[dynamics] needs a 'duration' in s");
}

void take_masses(Reading& reading, DynamicsPlan& plan) {
    const std::vector<Body>& bodies = reading.lesson.mechanism.bodies;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        plan.loads.masses.push_back(reading.masses[b].properties);
        const auto named = reading.names.find(bodies[b].name);
        if (bodies[b].fixed && reading.masses[b].given) {
            reading.problems->warn(
                Code::idle_mass, reading.masses[b].span,
                "body " + in_quotes(bodies[b].name) + " is fixed; its mass and inertia have no effect",
                "leave them out, or 'fixed'");
        }
        if (bodies[b].fixed || reading.masses[b].given || named == reading.names.end()) { continue; }
        reading.report(
            Code::no_mass, named->second.span,
            "body " + in_quotes(bodies[b].name) +
                " has no mass; expected 'mass' and 'inertia' of every body that moves in a lesson of "
                "dynamics",
            "a box of edges a, b, c has inertia = m/12 [b² + c², a² + c², a² + b²]");
    }
}

}  // namespace

std::optional<ReadPoint> read_point_of_body(Fields& fields, const Reading& reading) {
    const auto name = fields.text("body");
    fields.require("body", "the name of a body that moves");
    const auto at = fields.vector("at");
    const auto point = fields.vector("point");
    fields.at_most_one({"at", "point"});
    const Named* named = name ? reading.body(*name) : nullptr;
    if (named == nullptr) { return std::nullopt; }
    if (!reading.moves(named->index, name->span)) { return std::nullopt; }
    const Body& body = reading.body_at(named->index);
    ReadPoint out{named->index, std::nullopt};
    if (at) { out.point_local = rotation_of(body).transpose() * (at->value - body.r); }
    if (point) { out.point_local = point->value; }
    return out;
}

void read_dynamics(Fields& root, Reading& reading) {
    auto fields = root.table("dynamics");
    if (!fields) {
        if (!root.has("dynamics")) { warn_of_masses(reading); }
        return;
    }
    DynamicsPlan plan;
    read_members(*fields, format::kGravity, plan.loads);
    read_members(*fields, format::kDuration, plan);
    read_method(*fields, plan);
    read_point(*fields, reading, plan);
    fields->finish();
    take_masses(reading, plan);
    reading.lesson.dynamics = std::move(plan);
}

}  // namespace jw::reading
