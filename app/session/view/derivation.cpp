#include "app/session/view/derivation.hpp"

#include "app/session/view/quantities.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "lessons/formula/block_formulas.hpp"
#include "lessons/formula/symbol_values.hpp"
#include "lessons/formula/text_symbols.hpp"
#include "lessons/math/write_math.hpp"

namespace jw {

namespace {

constexpr int kDigits = 3;

/// The body and the kind of a column; nothing for an artificial coordinate.
struct ColumnPlace {
    int body = -1;
    bool of_orientation = false;
    int offset = 0;  ///< within r or the orientation
};

std::optional<ColumnPlace> place_of(const System& system, int column, int angular) {
    for (const int body : system.moving_bodies()) {
        const int within = column - system.body_column(body, angular);
        if (within < 0 || within >= 3 + angular) { continue; }
        return ColumnPlace{body, within >= 3, within >= 3 ? within - 3 : within};
    }
    return std::nullopt;
}

std::string numbers(const MatrixX& values) {
    return "(" + joined(values.reshaped(), ", ", [](double x) { return number_text(x, kDigits); }) + ")";
}

/// Entry of a value, which may be 0 or I.
double entry_of(const formula::Value& value, int row, int column) {
    switch (value.kind) {
        case formula::Value::Kind::zero: return 0.0;
        case formula::Value::Kind::identity: return row == column ? value.d[0](0, 0) : 0.0;
        case formula::Value::Kind::matrix: break;
    }
    return value.d[0](row, column);
}

math::Row substituted(const math::Row& row, const formula::Meanings& meanings);

/// A symbol, replaced by the matrix of its numbers; 0, I and symbols without a value stay.
math::Node number_of(const math::Node& node, const formula::Meanings& meanings) {
    if (const auto* const group = std::get_if<math::Group>(&node.nucleus)) {
        math::Node inner = node;
        inner.nucleus = math::Group{group->open, group->close, substituted(group->inner, meanings)};
        return inner;
    }
    if (!formula::text_symbol_of(node)) { return node; }
    try {
        const formula::Value value = formula::evaluate_expression({node}, meanings);
        if (value.kind != formula::Value::Kind::matrix) { return node; }
        return math::own_math(matrix_markup(value.d[0], kDigits)).front();
    } catch (const formula::NotEvaluated&) { return node; }
}

math::Row substituted(const math::Row& row, const formula::Meanings& meanings) {
    math::Row numbers;
    for (const math::Node& node : row) { numbers.push_back(number_of(node, meanings)); }
    return numbers;
}

}  // namespace

std::optional<Derivation> derivation_of(const Step& step, CoordinateChoice coordinates, int row, int column) {
    const System& system = *step.system;
    if (row >= system.rows()) { return std::nullopt; }
    const Constraint* const constraint = constraint_of(system, row);
    if (constraint == nullptr) { return std::nullopt; }
    const Constraint& c = *constraint;
    const int component = system.origin(row).component;
    const Joint& joint = system.mechanism().joints[at(c.joint)];
    const bool of_p = coordinates == CoordinateChoice::true_euler_parameters ||
                      coordinates == CoordinateChoice::modified_euler_parameters;
    const std::optional<ColumnPlace> place = place_of(system, column, of_p ? 4 : 3);
    const bool is_pair = joint.parallel_form == ParallelForm::pair && is_parallel(c.role);
    if (!place || is_pair || (place->body != c.body_i && place->body != c.body_j)) { return std::nullopt; }

    const formula::Block block{c.role, coordinates, place->of_orientation, place->body == c.body_i};
    const std::optional<std::string> source = formula::block_formula(block);
    if (!source) { return std::nullopt; }
    const Instant instant = instant_of(step);
    formula::Subject subject;
    subject.joint = c.joint;
    subject.role = c.role;
    const formula::Meanings meanings = formula::meanings_of(subject, instant);
    const math::Row right = math::own_math(*source);

    Derivation derivation;
    derivation.formula = formula::block_name(block) + " = " + *source;
    derivation.numbers = math::write_latex(substituted(right, meanings));
    const formula::Value value =
        formula::evaluate_expression(math::own_math(formula::block_name(block)), meanings);
    if (value.kind == formula::Value::Kind::matrix && component < value.rows()) {
        derivation.block = matrix_markup(value.d[0], kDigits);
        derivation.entry = entry_of(formula::evaluate_expression(right, meanings), component, place->offset);
        derivation.row = (value.rows() == 3 ? tr("row {0}", axis_name(component)) : std::string(tr("row"))) +
                         ": " + numbers(value.d[0].row(component));
    }
    return derivation;
}

}  // namespace jw
