#include <cmath>
#include <sstream>
#include <utility>

#include "lessons/formula/evaluator.hpp"
#include "lessons/formula/value.hpp"
#include "lessons/typed/exact_text.hpp"

namespace jw::formula {

namespace {

using math::Node;
using math::Row;
using math::SignKind;

bool is_equality(const Node& node) { return is_sign(node, "=") || is_sign(node, "≡"); }

/// Number of digits for printing the two sides. If they differ, the entries that are farthest apart are
/// printed differently.
int digits_of(const Value& a, const Value& b, bool differ) {
    const int few = a.is_number() || b.is_number() ? 6 : 4;
    const bool have_entries = a.kind == Value::Kind::matrix && b.kind == Value::Kind::matrix;
    if (!differ || !have_entries) { return few; }
    Eigen::Index row = 0;
    Eigen::Index column = 0;
    (a.d[0] - b.d[0]).cwiseAbs().maxCoeff(&row, &column);
    return writing::digits_apart(a.d[0](row, column), b.d[0](row, column), few);
}

std::string text_of(const Value& value, int digits) {
    if (value.kind != Value::Kind::matrix) { return shape_text(value); }
    if (value.d[0].size() > 12) { return shape_text(value) + " matrix"; }
    std::ostringstream text;
    const Eigen::IOFormat format(digits, Eigen::DontAlignCols, ", ", "; ", "", "", "[", "]");
    if (value.is_number()) {
        text.precision(digits);
        text << value.d[0](0, 0);
    } else {
        text << (value.cols() == 1 ? MatrixX(value.d[0].transpose()) : value.d[0]).format(format);
    }
    return text.str();
}

/// Meanings with definitions added.
class Definitions {
public:
    explicit Definitions(const Meanings& outer) : outer_(&outer) {}

    Meanings meanings() const {
        return {
            [this](const Symbol& symbol) -> std::optional<Value> {
                for (const auto& [name, value] : known_) {
                    if (name == symbol) { return value; }
                }
                return outer_->symbol(symbol);
            },
            outer_->words};
    }

    void add(const Row& definition) {
        const std::vector<Row> sides = sides_of(definition);
        const bool named =
            sides.size() == 2 && sides[0].size() == 1 && is_kind(sides[0][0], SignKind::letter);
        if (!named) { throw NotEvaluated({0, "expected a definition 'symbol = expression'", ""}); }
        const Node& left = sides[0][0];
        Superscript script;
        const Symbol symbol =
            symbol_of(std::get<math::Sign>(left.nucleus).utf8, left.below, left.above, script);
        if (script.transposed || !script.power.empty()) {
            throw NotEvaluated({left.from, "a power is defined; expected a symbol", ""});
        }
        const Meanings now = meanings();
        known_.emplace_back(symbol, evaluate_expression(sides[1], now));
    }

private:
    const Meanings* outer_;
    std::vector<std::pair<Symbol, Value>> known_;
};

}  // namespace

std::vector<Row> sides_of(const Row& equation) {
    std::vector<Row> sides(1);
    for (const Node& node : equation) {
        if (is_equality(node)) {
            sides.emplace_back();
        } else {
            sides.back().push_back(node);
        }
    }
    return sides;
}

Value evaluate_expression(const Row& expression, const Meanings& meanings) {
    return Evaluator<Value>(meanings).expression(expression);
}

Value evaluate_expression(const Row& expression, const std::vector<Row>& where, const Meanings& meanings) {
    Definitions definitions(meanings);
    for (const Row& definition : where) { definitions.add(definition); }
    return evaluate_expression(expression, definitions.meanings());
}

Outcome evaluate_equation(const Row& equation, const std::vector<Row>& where, const Meanings& meanings) {
    Outcome outcome;
    try {
        Definitions definitions(meanings);
        for (const Row& definition : where) {
            ++outcome.definition;
            definitions.add(definition);
        }
        outcome.definition = -1;
        const std::vector<Row> sides = sides_of(equation);
        if (sides.size() < 2) { throw NotEvaluated({0, "there is no '=' in it; expected an equation", ""}); }
        const Meanings known = definitions.meanings();
        std::vector<Value> values;
        for (const Row& side : sides) { values.push_back(evaluate_expression(side, known)); }
        double worst = -1.0;
        for (std::size_t k = 1; k < values.size(); ++k) {
            const Comparison apart = compared(values[k - 1], values[k]);
            const double part = apart.scale > 0.0 ? apart.difference / apart.scale : apart.difference;
            // NaN counts as farthest apart
            if (part <= worst || std::isnan(worst)) { continue; }
            worst = part;
            outcome.apart = apart;
            const int digits = digits_of(values[k - 1], values[k], part > kKnown);
            outcome.left = text_of(values[k - 1], digits);
            outcome.right = text_of(values[k], digits);
        }
    } catch (const NotEvaluated& failed) {
        outcome.problem = failed.problem();
        outcome.misfit = failed.reason() == NotEvaluated::Reason::shapes;
        outcome.no_value = failed.reason() == NotEvaluated::Reason::no_value;
    } catch (const Mismatch& mismatch) {
        outcome.problem = math::Problem{0, mismatch.what(), ""};
        outcome.misfit = true;
    }
    return outcome;
}

}  // namespace jw::formula
