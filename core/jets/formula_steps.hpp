#pragma once

#include <span>
#include <string>
#include <vector>

/// A formula of a few variables that an author writes, as a program.
namespace jw {

/// Step of a formula, for a stack of numbers: it takes its operands from the top and leaves its result there.
struct FormulaStep {
    enum class Kind {
        number,    ///< leaves `number`
        variable,  ///< leaves the variable with the index `number`
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

/// A formula in the notation of docs/mathematics.md, and its steps in the order in which they are done; the
/// last one leaves one number.
struct ScalarFormula {
    /// Numbers on the stack at once.
    static constexpr std::size_t kDeepest = 32;

    std::string source;
    std::vector<FormulaStep> steps;

    /// Value, not finite where the formula has none.
    double at(std::span<const double> variables) const;
    /// Size of the terms of which the value is made: its rounding is relative to it.
    double size_at(std::span<const double> variables) const;
    /// True if a step takes the variable with this index.
    bool uses(int variable) const { return uses_any(variable, variable + 1); }
    /// True if a step takes a variable with an index from `first` to before `last`.
    bool uses_any(int first, int last) const;

    /// Value and first derivatives of a formula of x and its rate, at rate 0.
    struct Slopes {
        double value = 0.0;
        double by_x = 0.0;
        double by_rate = 0.0;
    };
    Slopes slopes_at(double x) const;
    /// True if the slope by x is proved to exist at x and so near to it that rounding hides the difference.
    bool is_smooth_at(double x) const;
    /// Integral over x at rate 0; NaN if there is no value between both, or too many parts are needed.
    double integral(double from, double to) const;

    bool operator==(const ScalarFormula&) const = default;
};

/// Operands that a step takes: 0, 1 or 2.
int operands_of(FormulaStep::Kind kind);

}  // namespace jw
