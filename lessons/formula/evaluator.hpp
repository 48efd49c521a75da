#pragma once

#include <algorithm>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/numerics/variants.hpp"
#include "lessons/formula/evaluate_formula.hpp"

/// The grammar of formulas: which operation has which operands. The operations are those of `V`, found by
/// their names: sum, difference, negative, product, quotient, dot, cross, length, transposed, skew,
/// minus_operator, derivative, power, square_root, stacked, component, value_of_function, arc_tangent_of_two.
namespace jw::formula {

template <class V>
class Evaluator {
public:
    explicit Evaluator(const MeaningsOf<V>& meanings) : meanings_(&meanings) {}

    V expression(const math::Row& row) const {
        math::RowCursor cursor(row);
        if (cursor.at_end()) { throw NotEvaluated({0, "there is nothing here; expected an expression", ""}); }
        V value = expression(cursor);
        if (!cursor.at_end()) { fail(cursor.peek(), "this cannot be used here"); }
        return value;
    }

private:
    using Node = math::Node;
    using SignKind = math::SignKind;
    using RowCursor = math::RowCursor;

    [[noreturn]] static void fail(const Node& node, std::string message, std::string hint = {}) {
        throw NotEvaluated({node.from, std::move(message), std::move(hint)});
    }

    /// Runs `f`; shapes that do not fit are reported at `node`.
    template <class F>
    static V at(const Node& node, F&& f) {
        try {
            return f();
        } catch (const NoValue& none) {
            throw NotEvaluated({node.from, none.what(), ""}, NotEvaluated::Reason::no_value);
        } catch (const Mismatch& mismatch) {
            throw NotEvaluated({node.from, mismatch.what(), ""}, NotEvaluated::Reason::shapes);
        }
    }

    V expression(RowCursor& cursor) const {
        bool minus = sign_before(cursor);
        const Node& first = cursor.peek();
        V value = term(cursor);
        if (minus) {
            value = at(first, [&] { return negative(value); });
        }
        while (!cursor.at_end() && (is_sign(cursor.peek(), "+") || is_sign(cursor.peek(), "−"))) {
            const Node& sign = cursor.next();
            minus = is_sign(sign, "−");
            if (cursor.at_end()) { fail(sign, "nothing follows this sign"); }
            const V next = term(cursor);
            value = at(first, [&] { return minus ? difference(value, next) : sum(value, next); });
        }
        return value;
    }

    static bool sign_before(RowCursor& cursor) {
        if (!is_sign(cursor.peek(), "−") && !is_sign(cursor.peek(), "+")) { return false; }
        const Node& sign = cursor.next();
        if (cursor.at_end()) { fail(sign, "nothing follows this sign"); }
        return is_sign(sign, "−");
    }

    static bool ends_term(const Node& node) {
        return is_sign(node, "+") || is_sign(node, "−") || is_kind(node, SignKind::relation) ||
               is_kind(node, SignKind::closing) || is_kind(node, SignKind::punctuation);
    }

    V term(RowCursor& cursor) const {
        V value = factor(cursor);
        while (!cursor.at_end() && !ends_term(cursor.peek()) && !ends_fence(cursor.peek())) {
            const Node& node = cursor.peek();
            refuse_digit_behind(cursor.last(), node);
            const bool is_dot = is_sign(node, "·");
            const bool is_cross = is_sign(node, "×");
            const bool is_ratio = is_sign(node, "/");
            if (is_dot || is_cross || is_ratio) { cursor.next(); }
            if (cursor.at_end()) { fail(node, "nothing follows this sign"); }
            const V next = factor(cursor);
            value = at(node, [&] {
                if (is_cross) { return cross(value, next); }
                if (is_ratio) { return quotient(value, next); }
                return is_dot ? dot(value, next) : product(value, next);
            });
        }
        return value;
    }

    /// Reports a digit after a power, as in 10^12, which is read as 10^1 times 2.
    static void refuse_digit_behind(const Node& before, const Node& node) {
        const bool is_power = before.above.size() == 1 && is_kind(before.above[0], SignKind::number);
        if (is_power && is_kind(node, SignKind::number) && node.from == before.above[0].to) {
            fail(
                node, "this can be read in two ways",
                "write braces around the exponent, or a space before this");
        }
    }

    bool ends_fence(const Node& node) const { return fences_ > 0 && is_kind(node, SignKind::fence); }

    V factor(RowCursor& cursor) const {
        const Node& node = cursor.next();
        if (is_kind(node, SignKind::opening) || is_kind(node, SignKind::fence)) {
            return enclosed(cursor, node);
        }
        if (is_kind(node, SignKind::function)) { return function(cursor, node); }
        if (const auto* const fraction = std::get_if<math::Fraction>(&node.nucleus)) {
            if (const int order = order_of_operator(node, *fraction); order > 0) {
                return differentiated(cursor, node, order);
            }
        }
        return nucleus(node);
    }

    /// The expression in parentheses, or the length of the one between fences.
    V enclosed(RowCursor& cursor, const Node& open) const {
        const bool fences = is_kind(open, SignKind::fence);
        Evaluator inside(*meanings_);
        inside.fences_ = fences ? 1 : 0;
        if (cursor.at_end()) { fail(open, "this is not closed"); }
        V value = inside.expression(cursor);
        if (cursor.at_end() || (!fences && !is_kind(cursor.peek(), SignKind::closing))) {
            fail(open, "this is not closed");
        }
        const Node& close = cursor.next();
        if (fences) {
            value = at(open, [&] { return length(value); });
        }
        return with_superscript(value, close);
    }

    /// Order of d/dt or d²/dt²; 0 for a fraction that is not such an operator.
    static int order_of_operator(const Node& node, const math::Fraction& f) {
        const bool over = f.above.size() == 1 && is_sign(f.above[0], "d");
        const bool under = f.below.size() == 2 && is_sign(f.below[0], "d") && is_sign(f.below[1], "t");
        if (!over || !under) { return 0; }
        const math::Row& order = f.above[0].above;
        if (order.empty() && f.below[1].above.empty()) { return 1; }
        if (order == f.below[1].above && order.size() == 1 && is_sign(order[0], "2")) { return 2; }
        fail(node, "this derivative is not known", "write \\frac{d}{dt} or \\frac{d^2}{dt^2}");
    }

    static bool in_brackets(const Node& node) {
        const auto* const group = std::get_if<math::Group>(&node.nucleus);
        return is_kind(node, SignKind::opening) || (group != nullptr && !group->open.empty());
    }

    /// Derivative of the expression in parentheses, or of the whole product that follows.
    V differentiated(RowCursor& cursor, const Node& node, int order) const {
        if (cursor.at_end()) { fail(node, "nothing follows this operator"); }
        V value = in_brackets(cursor.peek()) ? factor(cursor) : term(cursor);
        return at(node, [&] {
            for (int k = 0; k < order; ++k) { value = derivative(value); }
            return value;
        });
    }

    V function(RowCursor& cursor, const Node& node) const {
        const std::string& name = std::get<math::Sign>(node.nucleus).utf8;
        if (cursor.at_end()) { fail(node, "nothing follows this function"); }
        if (name == "atan2") { return angle_of_two(cursor, node); }
        Superscript script;
        if (read_superscript(node.above, script) && script.power.size() == 2 &&
            is_sign(script.power[0], "−") && is_sign(script.power[1], "1") && name != "det") {
            const std::string inverse = name == "cos" || name == "tan" ? "\\arc" + name + " or " : "";
            fail(node, "this can be read in two ways", "write " + inverse + "\\frac{1}{\\" + name + " ...}");
        }
        const V x = argument(cursor, node);
        return at(node, [&] {
            const std::optional<V> value = value_of_function(name, x);
            if (!value) { fail(node, "the function " + name + " cannot be evaluated"); }
            return with_superscript(*value, node);
        });
    }

    static bool is_numeral(const Node& node) {
        const auto* const fraction = std::get_if<math::Fraction>(&node.nucleus);
        return is_kind(node, SignKind::number) ||
               (fraction != nullptr && are_numerals(fraction->above) && are_numerals(fraction->below));
    }
    static bool are_numerals(const math::Row& row) { return std::ranges::all_of(row, is_numeral); }

    /// Argument of a function: one factor, or a product that begins with a number, as in \sin 2\theta.
    V argument(RowCursor& cursor, const Node& of) const {
        const Node& first = cursor.peek();
        V value = factor(cursor);
        const auto goes_on = [&](const Node& node) {
            return is_numeral(first) && !ends_term(node) && !ends_fence(node) &&
                   !is_kind(node, SignKind::operation) && !is_kind(node, SignKind::function) &&
                   !is_sign(node, "/");
        };
        while (!cursor.at_end() && goes_on(cursor.peek())) {
            const Node& node = cursor.peek();
            const V next = factor(cursor);
            value = at(node, [&] { return product(value, next); });
        }
        if (is_kind(first, SignKind::opening) && !cursor.last().above.empty()) {
            const std::string name = std::get<math::Sign>(of.nucleus).utf8;
            fail(
                cursor.last(), "this can be read in two ways",
                "write \\" + name + "^2(...) or \\" + name + "((...)^2)");
        }
        if (!cursor.at_end() && is_sign(cursor.peek(), "/") && !in_brackets(first)) {
            fail(
                cursor.peek(), "this can be read in two ways",
                "write parentheses after " + std::get<math::Sign>(of.nucleus).utf8 + ", or \\frac");
        }
        return value;
    }

    V angle_of_two(RowCursor& cursor, const Node& node) const {
        const auto expect = [&](bool holds) {
            if (!holds) { fail(node, "expected atan2(y, x)"); }
        };
        expect(is_kind(cursor.next(), SignKind::opening));
        const Evaluator inside(*meanings_);
        const V y = as_number(inside.expression(cursor));
        expect(!cursor.at_end() && is_sign(cursor.next(), ",") && !cursor.at_end());
        const V x = as_number(inside.expression(cursor));
        expect(!cursor.at_end() && is_kind(cursor.next(), SignKind::closing));
        return at(node, [&] { return arc_tangent_of_two(y, x); });
    }

    V nucleus(const Node& node) const {
        return std::visit(
            Overloaded{
                [&](const math::Sign& sign) { return sign_value(node, sign); },
                [&](const math::Words& words) { return with_superscript(quantity(node, words.utf8), node); },
                [&](const math::Space&) -> V { fail(node, "a space has no value"); },
                [&](const math::Fraction& f) {
                    return with_superscript(
                        at(node, [&] { return quotient(expression(f.above), expression(f.below)); }), node);
                },
                [&](const math::Root& root) {
                    const V x = expression(root.inner);
                    return with_superscript(at(node, [&] { return square_root(x); }), node);
                },
                [&](const math::Accent&) { return accented(node); },
                [&](const math::Group& group) { return group_value(node, group); },
                [&](const math::Matrix& matrix) {
                    return with_superscript(matrix_value(node, matrix), node);
                },
            },
            node.nucleus);
    }

    V group_value(const Node& node, const math::Group& group) const {
        const V value = expression(group.inner);
        const bool bars = group.open == "|" || group.open == "‖";
        return with_superscript(bars ? at(node, [&] { return length(value); }) : value, node);
    }

    V matrix_value(const Node& node, const math::Matrix& matrix) const {
        std::vector<std::vector<V>> blocks;
        for (const auto& row : matrix.rows) {
            blocks.emplace_back();
            for (const math::Row& cell : row) { blocks.back().push_back(expression(cell)); }
        }
        return at(node, [&] { return stacked(blocks); });
    }

    V quantity(const Node& node, const std::string& name) const {
        return at(node, [&] {
            const std::optional<V> value = meanings_->words ? meanings_->words(name) : std::nullopt;
            if (!value) {
                fail(node, "'" + name + "' is not a quantity here", "docs/quantities.md lists them");
            }
            return *value;
        });
    }

    V sign_value(const Node& node, const math::Sign& sign) const {
        if (sign.kind == SignKind::number) {
            const double x = std::strtod(sign.utf8.c_str(), nullptr);
            return with_superscript(V::written(x), node);
        }
        if (sign.kind != SignKind::letter) { fail(node, "'" + sign.utf8 + "' cannot be used here"); }
        return symbol_value(node, sign.utf8, {});
    }

    /// Value of a symbol with accents, of which the innermost is the last.
    V symbol_value(
        const Node& node, const std::string& letter, const std::vector<math::AccentKind>& accents) const {
        Superscript script;
        const Symbol symbol = symbol_of(letter, node.below, node.above, script);
        const V value = meaning_of(node, symbol);
        return at(node, [&] { return with(marked(value, accents), script, node); });
    }

    V meaning_of(const Node& node, const Symbol& symbol) const {
        if (symbol == Symbol{"I", 0, {}, {}}) {
            return at(node, [] { return V::unit_matrix(); });
        }
        if (symbol == Symbol{"π", 0, {}, {}}) { return V::written(std::numbers::pi); }
        try {
            if (const std::optional<V> value = meanings_->symbol(symbol)) { return *value; }
            if (const std::optional<V> value = component_of(symbol)) { return *value; }
        } catch (const Mismatch& mismatch) { fail(node, mismatch.what()); }
        fail(
            node, "'" + name_of(symbol) + "' has no meaning here",
            "docs/writing-a-lesson.md lists the symbols");
    }

    /// Component of a vector: s_{xi} and s_{(x)i} are the first component of s_i.
    std::optional<V> component_of(const Symbol& symbol) const {
        constexpr std::string_view axes = "xyz";
        const bool spelt = symbol.index.size() >= 3 && symbol.index[0] == '(' && symbol.index[2] == ')';
        const std::size_t at = spelt ? 1 : 0;
        if (symbol.index.size() <= at) { return std::nullopt; }
        const std::size_t axis = axes.find(symbol.index[at]);
        if (axis == std::string_view::npos) { return std::nullopt; }
        Symbol vector = symbol;
        vector.index = symbol.index.substr(spelt ? 3 : 1);
        const std::optional<V> value = meanings_->symbol(vector);
        if (!value || !value->is_vector()) { return std::nullopt; }
        return component(*value, static_cast<Eigen::Index>(axis));
    }

    V accented(const Node& node) const {
        std::vector<math::AccentKind> accents;
        const math::Row* inner = nullptr;
        for (const auto* accent = std::get_if<math::Accent>(&node.nucleus); accent != nullptr;) {
            accents.push_back(accent->kind);
            inner = &accent->inner;
            const bool nested = inner->size() == 1 && (*inner)[0].below.empty() && (*inner)[0].above.empty();
            accent = nested ? std::get_if<math::Accent>(&(*inner)[0].nucleus) : nullptr;
        }
        const bool letter = inner->size() == 1 && is_kind((*inner)[0], SignKind::letter) &&
                            (*inner)[0].below.empty() && (*inner)[0].above.empty();
        if (letter) { return symbol_value(node, std::get<math::Sign>((*inner)[0].nucleus).utf8, accents); }
        const V value = expression(*inner);
        return with_superscript(at(node, [&] { return marked(value, accents); }), node);
    }

    static V marked(V value, const std::vector<math::AccentKind>& accents) {
        for (auto accent = accents.rbegin(); accent != accents.rend(); ++accent) {
            value = marked(value, *accent);
        }
        return value;
    }

    static V marked(const V& value, math::AccentKind accent) {
        switch (accent) {
            case math::AccentKind::tilde: return skew(value);
            case math::AccentKind::bar: return minus_operator(value);
            case math::AccentKind::dot: return derivative(value);
            case math::AccentKind::two_dots: return derivative(derivative(value));
            case math::AccentKind::hat:
            case math::AccentKind::arrow: break;
        }
        throw Mismatch("this accent means nothing in a formula that is evaluated");
    }

    V with(const V& value, const Superscript& script, const Node& node) const {
        if (script.power.empty()) { return script.transposed ? transposed(value) : value; }
        const Evaluator inside(*meanings_);
        const V n = as_number(inside.expression(script.power));
        if (!n.is_number() || !n.is_literal) {
            fail(
                node, "this exponent is not a number",
                "write numbers such as 2, -1, 0.5 or \\frac{1}{2}; \\exp(x) for a power of e");
        }
        const V raised = n.written_number() == 1.0 ? value : power(value, n.written_number());
        return script.transposed ? transposed(raised) : raised;
    }

    /// Value with the superscript of a node that is not a symbol: only transposes and powers are allowed.
    V with_superscript(const V& value, const Node& node) const {
        Superscript script;
        if (!node.below.empty()) { fail(node, "a subscript cannot be used here"); }
        if (!read_superscript(node.above, script)) {
            fail(node, "this exponent is neither T nor a number", "write \\exp(x) for a power of e");
        }
        return at(node, [&] { return with(value, script, node); });
    }

    const MeaningsOf<V>* meanings_;
    int fences_ = 0;
};

}  // namespace jw::formula
