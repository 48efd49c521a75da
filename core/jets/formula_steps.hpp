#pragma once

#include <span>
#include <string>
#include <vector>

/// A formula that an author writes, as a program.
namespace jw {

/// Step of a formula, for a stack of numbers: it pops its operands and pushes its result.
struct FormulaStep {
    enum class Kind {
        number,    ///< pushes `number`
        variable,  ///< pushes the variable with the index `number`
        sum,
        difference,
        product,
        quotient,
        negative,
        power,  ///< to the power of `number`, at most kHighestPower in magnitude
        sine,
        cosine,
        tangent,
        arc_sine,
        arc_cosine,
        arc_tangent,
        exponential,
        logarithm,
        square_root,
        absolute
    };
    static constexpr double kHighestPower = 100.0;

    Kind kind = Kind::number;
    double number = 0.0;

    bool operator==(const FormulaStep&) const = default;
};

/// Formula in the notation of docs/mathematics.md, and its steps in the order of evaluation; after the last
/// one, the stack holds one number.
struct ScalarFormula {
    /// Most numbers on the stack at once.
    static constexpr std::size_t kDeepest = 32;
    /// Most variables of a formula that is evaluated by `at`.
    static constexpr std::size_t kMostVariables = 17;
    /// Errors of poses are smaller.
    static constexpr double kBeside = 1e-9;

    std::string source;
    std::vector<FormulaStep> steps;

    /// Value of a formula of at most kMostVariables variables; not finite where it has none.
    double at(std::span<const double> variables) const;
    /// Size of the terms that make up the value: the rounding error of the value is relative to this size.
    double size_at(std::span<const double> variables) const;
    /// True if a step pushes the variable with this index.
    bool uses(int variable) const { return uses_any(variable, variable + 1); }
    /// True if a step pushes a variable whose index is at least `first` and below `last`.
    bool uses_any(int first, int last) const;

    /// The formula as a function of the variable with index `k` alone, which gets the index 0.
    /// @param variables  numbers that replace the others
    ScalarFormula along(std::span<const double> variables, std::size_t k) const;
    /// Slope of a formula of x.
    double slope_at(double x) const;
    /// True if the slope by x is proved to exist at x and at all points beside it: by default, at those that
    /// differ from x only by rounding.
    /// @param beside  distance of the points, relative to x beyond 1
    bool is_smooth_at(double x, double beside = kBeside) const;
    /// Integral over x, where all other variables are 0; NaN if a value in between does not exist, or if too
    /// many parts are needed.
    double integral(double from, double to) const;

    bool operator==(const ScalarFormula&) const = default;
};

/// Operands that a step takes: 0, 1 or 2.
int operands_of(FormulaStep::Kind kind);

}  // namespace jw
