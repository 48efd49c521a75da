#include "lessons/math/symbols.hpp"

#include <algorithm>

namespace jw::math {

const Symbol* symbol_of_command(std::string_view command) {
    const auto found = std::ranges::find(kSymbols, command, &Symbol::command);
    return found == kSymbols.end() ? nullptr : &*found;
}

const Symbol* symbol_of_character(std::string_view utf8) {
    const auto found = std::ranges::find(kSymbols, utf8, &Symbol::utf8);
    return found == kSymbols.end() ? nullptr : &*found;
}

const AccentCommand& accent_of(AccentKind kind) {
    return *std::ranges::find(kAccents, kind, &AccentCommand::kind);
}

const Environment& environment_of(MatrixKind kind) {
    return *std::ranges::find(kEnvironments, kind, &Environment::kind);
}

bool is_sign(const Node& node, const char* utf8) {
    const Sign* const sign = std::get_if<Sign>(&node.nucleus);
    return sign != nullptr && sign->utf8 == utf8;
}

bool is_kind(const Node& node, SignKind kind) {
    const Sign* const sign = std::get_if<Sign>(&node.nucleus);
    return sign != nullptr && sign->kind == kind;
}

bool precedes_operand(const Node& node) {
    return is_kind(node, SignKind::relation) || is_kind(node, SignKind::operation) ||
           is_kind(node, SignKind::opening) || is_kind(node, SignKind::punctuation);
}

}  // namespace jw::math
