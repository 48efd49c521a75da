#include "app/session/wording/labels.hpp"

#include <algorithm>
#include <array>

#include "core/numerics/variants.hpp"
#include "lessons/lesson/enum_words.hpp"
#include "lessons/lesson/things.hpp"
#include "lessons/math/read_math.hpp"
#include "lessons/math/write_math.hpp"

namespace jw {

namespace {

std::string combined(const std::string& name, const std::string& body) {
    return R"(\boldsymbol{\Phi}^{()" + name + R"()} \equiv )" + body;
}

/// Equation of a wheel's angle, from the line e to u about s.
std::string wheel_formula(
    const std::string& name, const std::string& e, const std::string& body, const std::string& angle) {
    const std::string u = R"(\mathbf{u}_)" + body;
    const bool is_product = e.find("tilde") != std::string::npos;
    const std::string row = (is_product ? "(" + e + ")" : e) + "^T ";
    return combined(
        name, "(" + e + R"( \times )" + u + R"()^T \mathbf{s}_)" + body + R"( \cos )" + angle + " - " + row +
                  u + R"( \sin )" + angle + " = 0");
}

/// Equation of a component of a point on a curve.
std::string curve_formula(const std::string& axis) {
    return combined(
        "c " + axis + ",1",
        R"(\mathbf{e}_)" + axis + R"(^T \mathbf{A}_i^T \mathbf{d} - c_)" + axis + R"((\theta) = 0)");
}

/// The formula of an author as an equation; the author may leave out "= 0".
std::string as_equation(const std::string& source) {
    const bool is_one = std::ranges::any_of(std::array{"=", "≡", R"(\equiv)"}, [&](const char* sign) {
        return source.find(sign) != std::string::npos;
    });
    return is_one ? source : source + " = 0";
}

/// Formula of a primitive; the number in its superscript counts the independent equations, as on the slides.
std::string formula_of(Role role, const Joint& joint) {
    const bool pair = joint.parallel_form == ParallelForm::pair;
    switch (role) {
        case Role::same_point:
            return combined(
                "s,3",
                R"(\mathbf{r}_i + \mathbf{A}_i \mathbf{s}'_i^P - \mathbf{A}_j \mathbf{s}'_j^P - \mathbf{r}_j = \mathbf{0})");
        case Role::axes_parallel:
            return pair ? combined(
                              "n1,1",
                              R"(\mathbf{a}_i^T \mathbf{s}_j = 0,\quad \mathbf{b}_i^T \mathbf{s}_j = 0)")
                        : combined("p1,2", R"(\tilde{\mathbf{s}}_i \mathbf{s}_j = \mathbf{0})");
        case Role::distance_parallel:
            return pair ? combined(
                              "n2,1", R"(\mathbf{a}_i^T \mathbf{d} = 0,\quad \mathbf{b}_i^T \mathbf{d} = 0)")
                        : combined("p2,2", R"(\tilde{\mathbf{s}}_i \mathbf{d} = \mathbf{0})");
        case Role::axes_perpendicular: return combined("n1,1", R"(\mathbf{s}_i^T \mathbf{s}_j = 0)");
        case Role::distance_perpendicular: return combined("n2,1", R"(\mathbf{s}_i^T \mathbf{d} = 0)");
        case Role::distance_perpendicular_j: return combined("n2,1", R"(\mathbf{s}_j^T \mathbf{d} = 0)");
        case Role::sides_perpendicular: return combined("n1,1", R"(\mathbf{h}_i^T \mathbf{h}_j = 0)");
        case Role::length: return combined("d,1", R"(\mathbf{d}^T \mathbf{d} - L^2 = 0)");
        case Role::formula: return combined("f,1", as_equation(joint.geometry.formula.source));
        case Role::screw_advance: return combined("r,1", R"((d - d^0) - \alpha\,(\theta - \theta^0) = 0)");
        case Role::curve_x: return curve_formula("x");
        case Role::curve_y: return curve_formula("y");
        case Role::curve_z: return curve_formula("z");
        case Role::rack_advance: return combined("r,1", R"((d - d^0) - r\,(\theta - \theta^0) = 0)");
        case Role::rack_angle: return wheel_formula(R"(\theta,1)", R"(\mathbf{s}_i)", "j", R"(\theta)");
        case Role::wheel_i: return wheel_formula(R"(\theta i,1)", R"(\mathbf{d})", "i", R"(\theta)");
        case Role::wheel_j: return wheel_formula(R"(\theta j,1)", R"(\mathbf{d})", "j", R"((n\,\theta))");
        case Role::bevel_i:
            return wheel_formula(R"(\theta i,1)", R"(\tilde{\mathbf{s}}_i \mathbf{s}_j)", "i", R"(\theta)");
        case Role::bevel_j:
            return wheel_formula(
                R"(\theta j,1)", R"(\tilde{\mathbf{s}}_i \mathbf{s}_j)", "j", R"((n\,\theta))");
        case Role::screw_angle: break;
    }
    switch (joint.geometry.screw_angle_form) {
        case ScrewAngleForm::cosine:
            return combined(R"(\theta,1)", R"(\mathbf{u}_i^T \mathbf{u}_j - \cos\theta = 0)");
        case ScrewAngleForm::sine:
            return combined(
                R"(\theta,1)", R"((\mathbf{u}_i \times \mathbf{u}_j)^T \mathbf{s}_i - \sin\theta = 0)");
        case ScrewAngleForm::rotation: break;
    }
    return combined(
        R"(\theta,1)",
        R"((\mathbf{u}_i \times \mathbf{u}_j)^T \mathbf{s}_i \cos\theta - \mathbf{u}_i^T \mathbf{u}_j \sin\theta = 0)");
}

const char* unit_of_role(Role role) {
    switch (traits_of(role).dimension) {
        case Dimension::none:
        case Dimension::of_author: return "-";
        case Dimension::length: return "m";
        case Dimension::square: break;
    }
    return "m²";
}

/// Parts of the label of a row.
struct RowNames {
    const std::string& owner;
    std::string equation;
    std::string component;  ///< mostly empty
};

RowNames names_of(const System& system, int row) {
    const RowOrigin origin = system.origin(row);
    const Mechanism& mechanism = system.mechanism();
    switch (origin.kind) {
        case RowOrigin::Kind::constraint: {
            const Constraint& c = system.constraints()[at(origin.index)];
            const Joint& joint = mechanism.joints[at(c.joint)];
            return {
                joint.name, name_of_role(c.role, joint.parallel_form), component_name(c, origin.component)};
        }
        case RowOrigin::Kind::driver:
            return {mechanism.drivers[at(system.drivers()[at(origin.index)].driver)].name, "f(t)", ""};
        case RowOrigin::Kind::normalisation: break;
    }
    return {mechanism.bodies[at(origin.index)].name, "pᵀp", ""};
}

/// Euler parameters: "e₀".
std::string euler_parameter(int k) {
    constexpr std::array digits{"₀", "₁", "₂", "₃"};
    return std::string("e") + digits[at(k)];
}

std::string in_unicode(const std::string& latex) { return math::write_plain(math::own_math(latex)); }

}  // namespace

const char* axis_name(int component) {
    constexpr std::array names{"x", "y", "z"};
    return names[at(component)];
}

const char* name_of_choice(CoordinateChoice choice) { return word_of(kChoices, choice); }

const char* name_of_form(ParallelForm form) { return word_of(kParallelForms, form); }

std::string name_of_role(Role role, ParallelForm form) { return primitive_name(role, form); }

EquationText equation_text(const System& system, const Constraint& constraint) {
    const Joint& joint = system.mechanism().joints[at(constraint.joint)];
    EquationText text;
    text.primitive = name_of_role(constraint.role, joint.parallel_form);
    text.formula = formula_of(constraint.role, joint);
    text.plain = in_unicode(text.formula);
    text.unit = unit_of_role(constraint.role);
    return text;
}

EquationText driver_text(const Driver& driver) {
    const auto of = [](const std::string& formula, const char* unit) {
        EquationText text;
        text.primitive = "driver";
        text.formula = combined("drive,1", formula);
        text.plain = in_unicode(text.formula);
        text.unit = unit;
        return text;
    };
    const std::string of_angle = R"(\theta - f(t) = 0)";
    return std::visit(
        Overloaded{
            [&](const AngleMeasure&) { return of(of_angle, "rad"); },
            [&](const ThetaMeasure&) { return of(of_angle, "rad"); },
            [&](const DisplacementMeasure&) { return of(R"(\mathbf{s}_i^T \mathbf{d} - f(t) = 0)", "m"); },
            [&](const SquaredDistanceMeasure&) {
                return of(R"(\mathbf{d}^T \mathbf{d} - f(t)^2 = 0)", "m²");
            },
            [&](const CoordinateMeasure& m) {
                const int k = m.coordinate;
                const std::string symbol = k < 3 ? axis_name(k) : "e_" + std::to_string(k - 3);
                return of(symbol + " - f(t) = 0", k < 3 ? "m" : "-");
            },
        },
        driver.measure);
}

const Constraint* constraint_of(const System& system, int row) {
    const RowOrigin origin = system.origin(row);
    return origin.kind == RowOrigin::Kind::constraint ? &system.constraints()[at(origin.index)] : nullptr;
}

std::string component_name(const Constraint& constraint, int component) {
    return component_name(constraint.equations, component);
}

std::string short_row_label(const System& system, int row) {
    const auto [owner, equation, component] = names_of(system, row);
    return equation + (component.empty() ? "" : " " + component);
}

std::string row_owner(const System& system, int row) { return names_of(system, row).owner; }

std::string row_label(const System& system, int row) {
    const auto [owner, equation, component] = names_of(system, row);
    switch (system.origin(row).kind) {
        case RowOrigin::Kind::constraint:
            return owner + " · " + equation + (component.empty() ? "" : " · " + component);
        case RowOrigin::Kind::driver: return owner;
        case RowOrigin::Kind::normalisation: break;
    }
    return owner + " · pᵀp − 1";
}

std::vector<ColumnName> column_names(const System& system, CoordinateChoice choice) {
    std::vector<ColumnName> names;
    const Mechanism& mechanism = system.mechanism();
    const bool euler = choice == CoordinateChoice::true_euler_parameters ||
                       choice == CoordinateChoice::modified_euler_parameters;
    const bool local = choice == CoordinateChoice::omega_local;
    for (const int body : system.moving_bodies()) {
        const std::string& owner = mechanism.bodies[at(body)].name;
        for (int k = 0; k < 3; ++k) { names.push_back({owner, axis_name(k), axis_name(k)}); }
        for (int k = 0; euler && k < 4; ++k) {
            names.push_back({owner, "e" + std::to_string(k), euler_parameter(k)});
        }
        for (int k = 0; !euler && k < 3; ++k) {
            names.push_back(
                {owner, std::string(local ? "omega_local." : "omega.") + axis_name(k),
                 std::string(local ? "ω′" : "ω") + axis_name(k)});
        }
    }
    const std::vector<int> thetas = mechanism.theta_indices();
    for (const int theta : system.active_thetas()) {
        for (std::size_t k = 0; k < thetas.size(); ++k) {
            if (thetas[k] == theta) { names.push_back({mechanism.joints[k].name, "theta", "θ"}); }
        }
    }
    return names;
}

}  // namespace jw
