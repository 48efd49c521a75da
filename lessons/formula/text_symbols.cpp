#include "lessons/formula/text_symbols.hpp"

#include <utility>
#include <vector>

#include "core/numerics/variants.hpp"
#include "lessons/math/write_math.hpp"

namespace jw::formula {

namespace {

void append_row(math::Row& to, const math::Row& more) { to.insert(to.end(), more.begin(), more.end()); }

/// Keeps primes and marks, removes transposes and powers.
math::Row superscripts_of_name(const math::Row& above) {
    math::Row kept;
    int depth = 0;
    for (const math::Node& node : above) {
        if (is_sign(node, "(")) { ++depth; }
        const bool arranges = is_sign(node, "T") || is_sign(node, "−") || is_sign(node, "-") ||
                              (is_kind(node, math::SignKind::number) && !is_sign(node, "0"));
        if (depth > 0 || !arranges) { kept.push_back(node); }
        if (is_sign(node, ")")) { --depth; }
    }
    return kept;
}

struct Bared {
    math::Node letter;
    std::vector<math::AccentKind> dots;
};

/// Removes the accents of a letter; nothing if they are above something else.
std::optional<Bared> bared(const math::Node& node) {
    if (is_kind(node, math::SignKind::letter)) { return Bared{node, {}}; }
    const auto* const accent = std::get_if<math::Accent>(&node.nucleus);
    if (accent == nullptr || accent->inner.size() != 1) { return std::nullopt; }
    std::optional<Bared> inner = bared(accent->inner[0]);
    if (!inner) { return std::nullopt; }
    append_row(inner->letter.below, node.below);
    append_row(inner->letter.above, node.above);
    using enum math::AccentKind;
    if (accent->kind == hat || accent->kind == arrow) { return std::nullopt; }
    if (accent->kind == dot || accent->kind == two_dots) { inner->dots.push_back(accent->kind); }
    return inner;
}

}  // namespace

std::optional<TextSymbol> text_symbol_of(const math::Node& node) {
    std::optional<Bared> bare = bared(node);
    if (!bare) { return std::nullopt; }
    const auto& sign = std::get<math::Sign>(bare->letter.nucleus);
    if (sign.alphabet == math::Alphabet::upright || sign.utf8 == "I") { return std::nullopt; }
    TextSymbol symbol;
    symbol.bold = sign.alphabet == math::Alphabet::bold;
    bare->letter.above = superscripts_of_name(bare->letter.above);
    Superscript script;
    symbol.name = symbol_of(sign.utf8, bare->letter.below, bare->letter.above, script);
    symbol.node.below = std::exchange(bare->letter.below, {});
    symbol.node.above = std::exchange(bare->letter.above, {});
    bare->letter.from = bare->letter.to = 0;
    symbol.node.nucleus = bare->letter.nucleus;
    for (const math::AccentKind dot : bare->dots) {
        math::Node inner;
        inner.nucleus = symbol.node.nucleus;
        symbol.node.nucleus = math::Accent{dot, {inner}};
        symbol.dots += dot == math::AccentKind::two_dots ? 2 : 1;
    }
    symbol.source = math::write_latex({symbol.node});
    return symbol;
}

void for_each_symbol(const math::Row& row, const std::function<void(const TextSymbol&)>& found) {
    for (const math::Node& node : row) {
        if (const std::optional<TextSymbol> symbol = text_symbol_of(node)) {
            found(*symbol);
            continue;
        }
        const auto inside = [&](const math::Row& inner) { for_each_symbol(inner, found); };
        std::visit(
            Overloaded{
                [](const math::Sign&) {}, [](const math::Words&) {}, [](const math::Space&) {},
                [&](const math::Fraction& f) {
                    inside(f.above);
                    inside(f.below);
                },
                [&](const math::Root& root) { inside(root.inner); },
                [&](const math::Accent& accent) { inside(accent.inner); },
                [&](const math::Group& group) { inside(group.inner); },
                [&](const math::Matrix& matrix) {
                    for (const auto& cells : matrix.rows) {
                        for (const math::Row& cell : cells) { inside(cell); }
                    }
                }},
            node.nucleus);
    }
}

}  // namespace jw::formula
