#pragma once

#include <algorithm>
#include <array>
#include <string_view>

/// Options of an integration and their names, as in lessons and on the command line.
namespace jw {

/// Methods of integration.
enum class Method {
    euler,          ///< explicit, order 1
    semi_implicit,  ///< symplectic Euler: velocities first, positions with the new ones; order 1
    rk4,            ///< classical Runge-Kutta, order 4
    explicit_5,     ///< Dormand-Prince 5(4), adaptive
    explicit_8,     ///< Dormand-Prince 8(5,3), adaptive
    implicit_5,     ///< Radau IIA of three stages, adaptive, for stiff scenes
    implicit_9,     ///< Radau IIA of five stages
};

/// Treatment of the constraints.
enum class Treatment {
    none,        ///< only Φq q̈ = γ: the drift is visible
    baumgarte,   ///< γ - 2 α Φ̇ - β² Φ instead of γ
    projection,  ///< projection onto Φ = 0 and Φ̇ = 0 after a step
    tangent,     ///< coordinates of the freedoms only: nothing to stabilise
};

/// Coordinates that are integrated.
enum class Formulation {
    /// joint coordinates for adaptive methods that keep the constraints, where they are cheaper; for implicit
    /// methods only if no loop is left
    automatic,
    bodies,  ///< r, p, ṙ, ω' of every body, block-sparse: shows everything that the slides discuss
    joints,  ///< coordinates of a tree of joints
};

struct FormulationName {
    Formulation formulation;
    std::string_view name;
};

inline constexpr std::array kFormulations{
    FormulationName{Formulation::joints, "joints"},
    FormulationName{Formulation::bodies, "bodies"},
};

/// Family of a method: determines the equations and treatments that it supports.
enum class MethodKind { runge_kutta, semi_implicit, radau };

struct MethodName {
    Method method;
    std::string_view name;
    MethodKind kind;
    bool adaptive;
};

inline constexpr std::array kMethods{
    MethodName{Method::euler, "euler", MethodKind::runge_kutta, false},
    MethodName{Method::semi_implicit, "semi-implicit", MethodKind::semi_implicit, false},
    MethodName{Method::rk4, "rk4", MethodKind::runge_kutta, false},
    MethodName{Method::explicit_5, "explicit-5", MethodKind::runge_kutta, true},
    MethodName{Method::explicit_8, "explicit-8", MethodKind::runge_kutta, true},
    MethodName{Method::implicit_5, "implicit-5", MethodKind::radau, true},
    MethodName{Method::implicit_9, "implicit-9", MethodKind::radau, true},
};

struct TreatmentName {
    Treatment treatment;
    std::string_view name;
};

inline constexpr std::array kTreatments{
    TreatmentName{Treatment::none, "none"},
    TreatmentName{Treatment::baumgarte, "baumgarte"},
    TreatmentName{Treatment::projection, "projection"},
    TreatmentName{Treatment::tangent, "tangent"},
};

/// Entry of a method in kMethods.
constexpr const MethodName& entry_of(Method method) {
    return *std::ranges::find(kMethods, method, &MethodName::method);
}
/// Entry of a treatment in kTreatments.
constexpr const TreatmentName& entry_of(Treatment treatment) {
    return *std::ranges::find(kTreatments, treatment, &TreatmentName::treatment);
}

/// True if the state may leave the constraints, a little more with every step.
constexpr bool drifts(Treatment treatment) {
    return treatment == Treatment::none || treatment == Treatment::baumgarte;
}

/// Reason why a method does not support a treatment; empty if it does.
constexpr std::string_view why_not(Method method, Treatment treatment) {
    if (entry_of(method).kind == MethodKind::radau) {
        return drifts(treatment)
                   ? "implicit methods keep the constraints by themselves; expected treatment projection or "
                     "tangent"
                   : "";
    }
    if (treatment != Treatment::tangent) { return ""; }
    return "treatment tangent needs an implicit method; expected implicit-5 or implicit-9, or treatment "
           "projection";
}

}  // namespace jw
