#pragma once

#include <array>
#include <string_view>

/// Names of what an integration can be asked for; the texts are those of lessons and the command line.
namespace jw {

enum class Method {
    euler,          ///< explicit, order 1
    semi_implicit,  ///< velocities first, positions with the new ones; order 1
    rk4,            ///< classical Runge-Kutta, order 4
    explicit_5,     ///< Dormand-Prince 5(4), adaptive
    explicit_8,     ///< Dormand-Prince 8(5,3), adaptive
    implicit_5,     ///< Radau IIA of three stages, adaptive, for stiff scenes
    implicit_9,     ///< Radau IIA of five stages
};

/// How the constraints are kept.
enum class Treatment {
    none,        ///< only Φq q̈ = γ: the drift is there to be seen
    baumgarte,   ///< γ - 2 α Φ̇ - β² Φ instead of γ
    projection,  ///< back onto Φ = 0 and Φ̇ = 0 after a step
    tangent,     ///< coordinates of the tangent space: nothing to stabilise
};

struct MethodName {
    Method method;
    std::string_view name;
    int order;
    bool adaptive;
};

inline constexpr std::array kMethods{
    MethodName{Method::euler, "euler", 1, false},
    MethodName{Method::semi_implicit, "semi-implicit", 1, false},
    MethodName{Method::rk4, "rk4", 4, false},
    MethodName{Method::explicit_5, "explicit-5", 5, true},
    MethodName{Method::explicit_8, "explicit-8", 8, true},
    MethodName{Method::implicit_5, "implicit-5", 5, true},
    MethodName{Method::implicit_9, "implicit-9", 9, true},
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

}  // namespace jw
