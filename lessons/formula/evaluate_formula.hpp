#pragma once

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "lessons/formula/symbol.hpp"
#include "lessons/formula/value.hpp"
#include "lessons/math/read_math.hpp"

/// Evaluates formulas as they stand on a slide. docs/writing-a-lesson.md says what can be written.
namespace jw::formula {

/// Meanings of symbols, and of the words in \text, which name quantities; nothing for unknown ones.
template <class V>
struct MeaningsOf {
    std::function<std::optional<V>(const Symbol&)> symbol;
    std::function<std::optional<V>(const std::string&)> words;
};
using Meanings = MeaningsOf<Value>;
using Lookup = decltype(Meanings::symbol);

/// Difference between the sides of an equation; in a chain, the largest difference.
struct Outcome {
    std::optional<math::Problem> problem;  ///< why it cannot be evaluated, and at which byte of its source
    bool misfit = false;                   ///< its symbols are known, but their shapes do not fit
    bool no_value = false;                 ///< the shapes fit, but a function has no value in this state
    int definition = -1;                   ///< which definition is wrong, -1: the equation itself
    Comparison apart;
    std::string left;   ///< value of the side before the relation with the largest difference, for messages
    std::string right;  ///< of the side after it
};

/// Evaluates an equation "a = b = c".
/// @param where  definitions "symbol = expression", each may use those before it
Outcome evaluate_equation(
    const math::Row& equation, const std::vector<math::Row>& where, const Meanings& meanings);

/// Why a formula does not have a value, and at which byte of its source.
class NotEvaluated : public std::runtime_error {
public:
    enum class Reason { text, shapes, no_value };
    explicit NotEvaluated(math::Problem problem, Reason reason = Reason::text)
        : std::runtime_error(problem.message), problem_(std::move(problem)), reason_(reason) {}
    const math::Problem& problem() const { return problem_; }
    Reason reason() const { return reason_; }

private:
    math::Problem problem_;
    Reason reason_;
};

/// Evaluates an expression without a relation.
/// @throws NotEvaluated
Value evaluate_expression(const math::Row& expression, const Meanings& meanings);
/// The same, with the definitions `where`.
Value evaluate_expression(
    const math::Row& expression, const std::vector<math::Row>& where, const Meanings& meanings);

/// Sides of an equation "a = b = c".
std::vector<math::Row> sides_of(const math::Row& equation);

}  // namespace jw::formula
