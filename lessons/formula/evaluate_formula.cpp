#include "lessons/formula/evaluate_formula.hpp"

#include "lessons/formula/evaluator.hpp"
#include "lessons/formula/functions.hpp"

namespace jw::formula {

Value evaluate_expression(const math::Row& expression, const Meanings& meanings) {
    return Evaluator<Value>(meanings).expression(expression);
}

}  // namespace jw::formula
