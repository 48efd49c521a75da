#include <algorithm>
#include <cmath>

#include "app/session/output/describe.hpp"
#include "app/session/output/json.hpp"
#include "app/session/rest/rest.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "app/session/wording/quantity_text.hpp"
#include "app/session/wording/text_table.hpp"

namespace jw {

namespace {

constexpr std::size_t kMostJointsOfMode = 4;
// a joint that moves less is not named, and a smaller phase or decay is not mentioned: four digits are shown
constexpr double kTooLittle = 1e-4;
// of the largest number of its kind: rounding, times the condition number of the constraints
constexpr double kRounding = 1e-12;

double without_rounding(double value, double size) {
    return std::abs(value) <= kRounding * size ? 0.0 : value;
}
Vec3 without_rounding(const Vec3& v, double size) {
    return v.unaryExpr([&](double value) { return without_rounding(value, size); });
}

/// Largest of all reaction forces, and of their torques divided by the extent [N].
double largest_reaction(const RestView& view) {
    double largest = 0.0;
    for (const Reaction& reaction : view.instant.reactions().reactions) {
        const Wrench& wrench = reaction.wrench;
        largest = std::max({largest, wrench.force.norm(), wrench.torque.norm() / extent(*view.mechanism)});
    }
    return largest;
}

/// Size of a quantity: values below kRounding times this size are rounding.
double size_of(const Quantity& quantity, const RestView& view) {
    switch (dimension_of(quantity).unit) {
        case Unit::radian: return 1.0;
        case Unit::metre: return extent(*view.mechanism);
        case Unit::newton: return largest_reaction(view);
        case Unit::newton_metre: return largest_reaction(view) * extent(*view.mechanism);
        case Unit::none:
        case Unit::joule: break;
    }
    return 0.0;
}

std::string value_cell(const Quantity& quantity, const RestView& view) {
    const QuantityValue value = evaluate(quantity, view.instant, 0);
    if (value.absences[0] != Absence::none) { return absence_text(value.absences[0]); }
    return number_text(
        without_rounding(value.value(), size_of(quantity, view)) * factor_of_unit(quantity), 6);
}

/// Name, value and unit of a quantity.
std::vector<std::string> cells_of(const NamedQuantity& named, const RestView& view) {
    return {
        name_of(named.quantity, 0, *view.mechanism), value_cell(named.quantity, view),
        unit_text(named.quantity, 0)};
}

std::string quantities_text(const RestView& view) {
    TextRows table{{tr("quantity"), tr("value"), ""}};
    for (const NamedQuantity& named : view.quantities) { table.push_back(cells_of(named, view)); }
    return text_table(table, columns_of_numbers(3, 2));
}

const std::string& owner_of(const Reaction& reaction, const Mechanism& mechanism) {
    return reaction.joint >= 0 ? mechanism.joints[at(reaction.joint)].name
                               : mechanism.drivers[at(reaction.driver)].name;
}

std::string reactions_text(const RestView& view) {
    TextRows table{{tr("joint or driver"), tr("force [N]"), tr("torque [N m]"), ""}};
    const double length = extent(*view.mechanism);
    const double largest = largest_reaction(view);
    for (const Reaction& reaction : view.instant.reactions().reactions) {
        table.push_back(
            {owner_of(reaction, *view.mechanism),
             vector_text(without_rounding(reaction.wrench.force, largest), 6),
             vector_text(without_rounding(reaction.wrench.torque, largest * length), 6),
             reaction.unique() ? "" : tr("not unique")});
    }
    if (table.size() == 1) { return {}; }
    return std::string("\n  ") + tr("Reactions on the second body, at the joint's point, in global axes:") +
           '\n' + text_table(table, columns_of_numbers(4, 2));
}

/// Name of a movement: "hinge.angle", or "top about z" for a rotation.
std::string name_of_movement(const NamedQuantity& named, const Mechanism& mechanism) {
    const auto* rotation = std::get_if<AngularVelocityQuantity>(&named.quantity);
    if (rotation == nullptr) { return name_of(named.quantity, 0, mechanism); }
    return tr("{0} about {1}", mechanism.bodies[at(rotation->body)].name, axis_name(rotation->component));
}

/// The joints that move most: "hinge.angle 1 rad, knee.angle -1.414 rad"
std::string joints_text(const std::vector<ModeOfJoint>& joints, const Mechanism& mechanism) {
    std::string text;
    for (std::size_t k = 0; k < std::min(joints.size(), kMostJointsOfMode); ++k) {
        const auto& [named, amplitude] = joints[k];
        if (std::abs(amplitude) < kTooLittle) { break; }
        const bool in_phase = std::abs(amplitude.imag()) < kTooLittle * std::abs(amplitude);
        const double size = in_phase ? amplitude.real() : std::abs(amplitude);
        text += (text.empty() ? "" : ", ") + name_of_movement(named, mechanism) + ' ' + number_text(size) +
                ' ' + std::string(symbol_of(dimension_of(named.quantity).unit));
        if (!in_phase) {
            text += ' ' + tr("with phase {0}°", number_text(std::arg(amplitude) * kDegreesPerRadian));
        }
    }
    return text;
}

/// How a small motion develops in time.
std::string rate_text(std::complex<double> s) {
    if (s == 0.0) { return tr("neutral: forces unchanged to first order"); }
    const auto per_e = number_text(1.0 / std::abs(s.real()));
    const std::string growth = s.real() > 0.0 ? tr("grows: a factor of e in {0} s", per_e)
                                              : tr("decays: a factor of e in {0} s", per_e);
    if (s.imag() == 0.0) { return growth; }
    const std::string frequency = tr("{0} Hz", number_text(s.imag() * 0.5 * std::numbers::inv_pi, 6));
    if (std::abs(s.real()) < kTooLittle * s.imag()) { return frequency; }
    if (s.real() > 0.0) { return frequency + ", " + growth; }
    return frequency + ", " + growth + ", " + tr("damping ratio {0}", number_text(-s.real() / std::abs(s)));
}

std::string verdict_of(const RestView& view) {
    std::string verdict = stability_text(view.outcome);
    if (view.outcome.motions.stability == Stability::unstable && view.seek == Seek::where_it_rests) {
        verdict +=
            std::string(" ") +
            tr("The mechanism starts exactly there. Start near this pose to see where it comes to rest.");
    }
    if (view.without_friction) {
        verdict += std::string(" ") +
                   tr("Dry friction is neglected: with it, the mechanism can also stop near this pose.");
    }
    return verdict;
}

std::vector<RestWords::SmallMotion> motions_of(const RestView& view) {
    std::vector<RestWords::SmallMotion> motions;
    for (std::size_t k = 0; k < view.modes.size(); ++k) {
        motions.push_back(
            {rate_text(view.outcome.motions.modes[k].s), joints_text(view.modes[k], *view.mechanism)});
    }
    return motions;
}

std::string modes_text(const RestView& view) {
    if (view.modes.empty()) { return {}; }
    TextRows table{{tr("mode"), tr("in time"), tr("joints that move most")}};
    for (const auto& [in_time, joints] : motions_of(view)) {
        table.push_back({std::to_string(table.size()), in_time, joints});
    }
    std::vector<TextColumn> columns = columns_of_numbers(3, 2);
    columns[1].right = false;
    return std::string("\n  ") + tr("Small motions about it:") + '\n' + text_table(table, columns);
}

Json complex_json(std::complex<double> value) { return {number(value.real()), number(value.imag())}; }

Json modes_json(const RestView& view) {
    Json modes = Json::array();
    for (std::size_t k = 0; k < view.modes.size(); ++k) {
        const Mode& mode = view.outcome.motions.modes[k];
        Json joints = Json::array();
        for (const auto& [named, amplitude] : view.modes[k]) {
            joints.push_back(
                {{"name", name_of(named.quantity, 0, *view.mechanism)},
                 {"amplitude", complex_json(amplitude)}});
        }
        modes.push_back(
            {{"s", complex_json(mode.s)},
             {"frequency_hz", number(mode.s.imag() * 0.5 * std::numbers::inv_pi)},
             {"joints", joints}});
    }
    return modes;
}

Json reactions_json(const RestView& view) {
    Json reactions = Json::array();
    for (const Reaction& reaction : view.instant.reactions().reactions) {
        reactions.push_back(
            {{"name", owner_of(reaction, *view.mechanism)},
             {"point", json_of(reaction.point)},
             {"force", json_of(reaction.wrench.force)},
             {"torque", json_of(reaction.wrench.torque)},
             {"unique", reaction.unique()}});
    }
    return reactions;
}

Json quantities_json(const RestView& view) {
    Json quantities = Json::array();
    for (const NamedQuantity& named : view.quantities) {
        quantities.push_back(
            {{"name", name_of(named.quantity, 0, *view.mechanism)},
             {"value", number(evaluate(named.quantity, view.instant, 0).value())},
             {"unit", std::string(symbol_of(dimension_of(named.quantity).unit))}});
    }
    return quantities;
}

const char* word_of(Stability stability) {
    switch (stability) {
        case Stability::stable: return "stable";
        case Stability::unstable: return "unstable";
        case Stability::cannot_tell: break;
    }
    return "cannot tell";
}

}  // namespace

std::string describe(const RestView& view) {
    const std::string head =
        tr("Equilibrium, found in {0} steps from the start pose. Drivers and loads are fixed at t = 0.",
           view.outcome.steps);
    return "  " + head + "\n  " + verdict_of(view) + "\n\n" + quantities_text(view) + reactions_text(view) +
           modes_text(view);
}

RestWords words_of(const RestView& view) {
    RestWords words{verdict_of(view), {}, motions_of(view)};
    for (const NamedQuantity& named : view.quantities) {
        const std::vector<std::string> cells = cells_of(named, view);
        words.quantities.push_back(cells[0] + " = " + cells[1] + ' ' + cells[2]);
    }
    return words;
}

Json json_of(const RestView& view, const Lesson& lesson) {
    const bool is_found = view.failure.empty();
    const RestOutcome& outcome = view.outcome;
    return {
        {"format", "jointwise rest"},
        {"version", kJsonVersion},
        {"lesson", {{"file", lesson.file_name}, {"title", lesson.title}}},
        {"steps", outcome.steps},
        {"freedoms", outcome.freedoms},
        {"residual", number(outcome.residual)},
        {"friction_left_out", view.without_friction},
        {"stability", is_found ? Json(word_of(outcome.motions.stability)) : Json()},
        {"singular", is_found ? Json(outcome.motions.is_singular) : Json()},
        {"conservative", is_found ? Json(outcome.motions.is_conservative) : Json()},
        {"damped", is_found ? Json(outcome.motions.is_damped) : Json()},
        {"bodies", json_of(*view.mechanism, view.instant.state, view.instant.velocity)},
        {"quantities", quantities_json(view)},
        {"reactions", is_found ? reactions_json(view) : Json()},
        {"modes", modes_json(view)},
        {"failure", is_found ? Json() : Json(view.failure)}};
}

}  // namespace jw
