#include "lessons/read/scalar_formula.hpp"

namespace jw::reading {

std::optional<ScalarFormula> read_formula(
    Fields& fields, const std::string& key, const FormulaReader& read, const char* made_of) {
    const auto source = fields.formula(key);
    if (!source) { return std::nullopt; }
    try {
        return read(source->value);
    } catch (const formula::NotEvaluated& failed) {
        const auto& [at, message, hint] = failed.problem();
        fields.problems().add(
            Code::unreadable_formula, fields.place_in(key, at), message,
            hint.empty() || hint.starts_with("docs/") ? std::string("write it of ") + made_of : hint);
    }
    return std::nullopt;
}

std::optional<ScalarFormula> read_scalar_formula(
    Fields& fields, const std::string& key, std::span<const formula::Variable> variables,
    const char* made_of) {
    const auto read = [&](const std::string& source) { return formula::scalar_formula(source, variables); };
    return read_formula(fields, key, read, made_of);
}

}  // namespace jw::reading
