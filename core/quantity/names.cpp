#include "core/quantity/names.hpp"

#include <array>
#include <charconv>

#include "core/model/joint_types.hpp"
#include "core/numerics/variants.hpp"

namespace jw {

namespace {

constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};
constexpr std::array<std::string_view, 3> kDots{"", "_dot", "_ddot"};
constexpr std::array<std::string_view, kBodyVectors> kVectors{"r", "r_dot", "r_ddot", "omega", "omega_dot"};
constexpr std::array<std::string_view, kEnergyParts> kEnergies{"kinetic", "potential", "sum"};

/// "[0.5 0 1e-3]", in the shortest form that reads back as the same numbers.
std::string vector_word(const Vec3& v) {
    std::string text = "[";
    for (int k = 0; k < 3; ++k) {
        std::array<char, 32> digits{};
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), v(k) + 0.0).ptr;
        if (k > 0) { text += ' '; }
        text.append(digits.data(), end);
    }
    return text + "]";
}

class NameOf {
public:
    NameOf(int derivative, const Mechanism& mechanism)
        : dot_(kDots[at(derivative)]), mechanism_(&mechanism) {}

    std::string operator()(const MeasureQuantity& q) const {
        return std::visit(
            Overloaded{
                [&](const CoordinateMeasure& m) { return coordinate(q.body_j, m.coordinate); },
                [&](const SquaredDistanceMeasure& m) {
                    return q.joint < 0 && q.driver < 0
                               ? between(q.body_i, "distance", m.P_i_local, q.body_j, m.P_j_local)
                               : dotted(owner(q.joint, q.driver), "distance");
                },
                [&](const DisplacementMeasure&) { return dotted(owner(q.joint, q.driver), "displacement"); },
                [&](const AngleMeasure&) { return dotted(owner(q.joint, q.driver), "angle"); },
                [&](const ThetaMeasure&) { return dotted(owner(q.joint, q.driver), "angle"); },
            },
            q.measure);
    }
    std::string operator()(const AngularVelocityQuantity& q) const {
        return dotted(body(q.body), q.local ? "omega_local" : "omega") + "." + axis(q.component);
    }
    std::string operator()(const PointQuantity& q) const {
        return dotted(body(q.body), "point") + vector_word(q.s_local) + "." + axis(q.component);
    }
    std::string operator()(const PointSpeedQuantity& q) const {
        return body(q.body) + ".point" + vector_word(q.s_local) + ".speed" + dot_;
    }
    std::string operator()(const BodySizeQuantity& q) const {
        return "|" + body(q.body) + "." + std::string(kVectors[static_cast<std::size_t>(q.vector)]) + "|" +
               dot_;
    }
    std::string operator()(const DirectionsQuantity& q) const {
        return between(q.body_i, "angle", q.a_i_local, q.body_j, q.a_j_local);
    }
    std::string operator()(const EnergyQuantity& q) const {
        return dotted("energy", std::string(kEnergies[static_cast<std::size_t>(q.part)]));
    }
    std::string operator()(const ReactionQuantity& q) const {
        const std::string of =
            owner(q.joint, q.driver) + (q.part == WrenchPart::force ? ".force" : ".torque");
        return q.component > 2 ? "|" + of + "|" : of + "." + axis(q.component);
    }
    std::string operator()(const EffortQuantity& q) const { return owner(-1, q.driver) + ".effort"; }
    std::string operator()(const ParameterErrorQuantity& q) const { return body(q.body) + ".p_error"; }
    std::string operator()(const ResidualQuantity& q) const {
        const std::string of = dotted(owner(q.joint, q.driver), "residual");
        if (q.joint < 0) { return of; }
        const std::string_view component =
            component_word(mechanism_->joints[at(q.joint)], q.role, q.component);
        return of + "." + std::string(word_of(q.role)) + (component.empty() ? "" : ".") +
               std::string(component);
    }
    std::string operator()(const SingularValueQuantity& /*q*/) const {
        return "jacobian.smallest_singular_value";
    }
    std::string operator()(const PairConditionQuantity& q) const {
        return owner(q.joint, -1) + ".condition." + std::string(word_of(q.role));
    }

private:
    const std::string& body(int index) const { return mechanism_->bodies[at(index)].name; }
    const std::string& owner(int joint, int driver) const {
        return joint >= 0 ? mechanism_->joints[at(joint)].name : mechanism_->drivers[at(driver)].name;
    }
    static std::string axis(int component) { return std::string(kAxes[at(component)]); }
    std::string coordinate(int of, int k) const {
        if (k >= 3) { return dotted(body(of), std::string("e").append(std::to_string(k - 3))); }
        const std::string vector = dot_.empty() ? "" : ".r" + dot_;
        return body(of) + vector + "." + std::string(kAxes[at(k)]);
    }
    std::string dotted(const std::string& of, const std::string& word) const {
        return of + "." + word + dot_;
    }
    std::string between(int i, const char* word, const Vec3& on_i, int j, const Vec3& on_j) const {
        return dotted(body(i), word) + vector_word(on_i) + "." + body(j) + vector_word(on_j);
    }

    std::string dot_;
    const Mechanism* mechanism_;
};

/// Adds a quantity with all its derivatives.
void add(std::vector<NamedQuantity>& list, const Quantity& quantity) {
    for (int k = 0; k <= derivatives_of(quantity); ++k) { list.push_back({quantity, k}); }
}

/// Adds the reactions of a joint, or of a driver.
void add_reactions(std::vector<NamedQuantity>& list, int joint, int driver) {
    for (const WrenchPart part : {WrenchPart::force, WrenchPart::torque}) {
        for (int k = 0; k < 4; ++k) { add(list, ReactionQuantity{joint, driver, part, k}); }
    }
}

}  // namespace

std::string name_of(const Quantity& quantity, int derivative, const Mechanism& mechanism) {
    return std::visit(NameOf(derivative, mechanism), quantity);
}

std::string_view word_of(Role role) {
    switch (role) {
        case Role::same_point: return "s";
        case Role::axes_parallel: return "p1";
        case Role::distance_parallel: return "p2";
        case Role::axes_perpendicular:
        case Role::sides_perpendicular: return "n1";
        case Role::distance_perpendicular: return "n2";
        case Role::distance_perpendicular_j: return "n2j";
        case Role::length: return "d";
        case Role::formula: return "f";
        case Role::screw_advance:
        case Role::rack_advance: return "r";
        case Role::wheel_i:
        case Role::bevel_i: return "theta_i";
        case Role::wheel_j:
        case Role::bevel_j: return "theta_j";
        case Role::curve_x: return "c_x";
        case Role::curve_y: return "c_y";
        case Role::curve_z: return "c_z";
        case Role::screw_angle:
        case Role::rack_angle: break;
    }
    return "theta";
}

int equations_of(const Joint& joint, Role role) {
    if (role == Role::same_point) { return 3; }
    if (!is_parallel(role)) { return 1; }
    return joint.parallel_form == ParallelForm::pair ? 2 : 3;
}

std::string_view component_word(const Joint& joint, Role role, int component) {
    constexpr std::array<std::string_view, 2> pair{"a", "b"};
    switch (equations_of(joint, role)) {
        case 3: return kAxes[at(component)];
        case 2: return pair[at(component)];
        default: return "";
    }
}

std::vector<MeasureQuantity> measures_of(const Mechanism& mechanism, int joint) {
    const Joint& of = mechanism.joints[at(joint)];
    std::vector<MeasureQuantity> measures;
    const auto add_measure = [&](const Measure& measure) {
        measures.push_back({measure, of.body_i, of.body_j, joint, -1});
    };
    if (of.type->artificial > 0) {
        add_measure(ThetaMeasure{});
    } else if (of.type->has_angle()) {
        add_measure(angle_of(of));
    }
    if (of.type->has_displacement()) { add_measure(displacement_of(of)); }
    if (of.type->uses(Role::length)) {
        add_measure(SquaredDistanceMeasure{of.geometry.P_i_local, of.geometry.P_j_local});
    }
    return measures;
}

MeasureQuantity measure_of_driver(const Mechanism& mechanism, int driver) {
    const Driver& of = mechanism.drivers[at(driver)];
    const bool distance = of.joint < 0 && std::holds_alternative<SquaredDistanceMeasure>(of.measure);
    return {of.measure, of.body_i, of.body_j, of.joint, distance ? driver : -1};
}

std::vector<NamedQuantity> quantities_of_body(int body) {
    std::vector<NamedQuantity> list;
    for (int k = 0; k < 7; ++k) { add(list, MeasureQuantity{CoordinateMeasure{k}, 0, body, -1, -1}); }
    for (const bool local : {false, true}) {
        for (int k = 0; k < 3; ++k) { add(list, AngularVelocityQuantity{body, local, k}); }
    }
    for (int k = 0; k < kBodyVectors; ++k) { add(list, BodySizeQuantity{body, static_cast<BodyVector>(k)}); }
    add(list, ParameterErrorQuantity{body});
    return list;
}

std::vector<NamedQuantity> quantities_of_joint(const Mechanism& mechanism, int joint) {
    std::vector<NamedQuantity> list;
    for (const MeasureQuantity& measure : measures_of(mechanism, joint)) { add(list, measure); }
    const Joint& of = mechanism.joints[at(joint)];
    add_reactions(list, joint, -1);
    for (const Role role : of.type->roles) {
        if (is_parallel(role)) { add(list, PairConditionQuantity{joint, role}); }
    }
    for (const Role role : of.type->roles) {
        for (int k = 0; k < equations_of(of, role); ++k) { add(list, ResidualQuantity{joint, -1, role, k}); }
    }
    return list;
}

std::vector<NamedQuantity> quantities_of_driver(const Mechanism& mechanism, int driver) {
    std::vector<NamedQuantity> list;
    const MeasureQuantity measure = measure_of_driver(mechanism, driver);
    if (measure.driver >= 0) { add(list, measure); }
    add_reactions(list, -1, driver);
    add(list, EffortQuantity{driver, unit_of(mechanism.drivers[at(driver)].measure) == Unit::radian});
    add(list, ResidualQuantity{-1, driver, Role::same_point, 0});
    return list;
}

std::vector<NamedQuantity> quantities_of(const Mechanism& mechanism) {
    std::vector<NamedQuantity> list;
    const auto append = [&](const std::vector<NamedQuantity>& more) {
        list.insert(list.end(), more.begin(), more.end());
    };
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        append(quantities_of_body(static_cast<int>(b)));
    }
    for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
        append(quantities_of_joint(mechanism, static_cast<int>(j)));
    }
    for (std::size_t d = 0; d < mechanism.drivers.size(); ++d) {
        append(quantities_of_driver(mechanism, static_cast<int>(d)));
    }
    for (int k = 0; k < kEnergyParts; ++k) { add(list, EnergyQuantity{static_cast<EnergyPart>(k)}); }
    add(list, SingularValueQuantity{});
    return list;
}

}  // namespace jw
