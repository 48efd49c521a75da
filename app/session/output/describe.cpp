#include "app/session/output/describe.hpp"

#include <cmath>
#include <ranges>

#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "app/session/wording/text_table.hpp"
#include "app/session/wording/text_width.hpp"
#include "lessons/math/text_parts.hpp"

namespace jw {

namespace {

std::string status_text(EquationRow::Status status) {
    switch (status) {
        case EquationRow::Status::kept: return tr("kept");
        case EquationRow::Status::dropped: return tr("left out");
        case EquationRow::Status::open: return {};
        case EquationRow::Status::redundant: break;
    }
    return tr("redundant");
}

std::string equations_text(const View& view, int width) {
    std::string text;
    for (const EquationGroup& group : view.equations) {
        text += "  " + group.plain + '\n';
        for (const EquationRow& row : group.rows) {
            text += "      " + padded(row.component, 2) + padded(small_text(row.value), 10, true) + " " +
                    padded(group.unit == "-" ? "" : group.unit, 4) + status_text(row.status) + '\n';
        }
        if (group.choice) {
            TextRows table{{"", "x", "y", "z"}, {"|sᵢ|"}, {tr("condition number without it")}};
            for (std::size_t k = 0; k < 3; ++k) {
                table[1].push_back(number_text(group.choice->axis_size[k], 3));
                table[2].push_back(number_text(group.choice->pair_condition[k], 3));
            }
            text += text_table(table, columns_of_numbers(4, 6)) + "      " +
                    wrapped(group.choice->reason, width - 6, 6) + '\n';
        }
    }
    return text;
}

std::string newton_text(const View& view) {
    TextRows table{{"", "‖Φ‖", tr("largest"), "‖Δq‖", tr("turn"), tr("rank"), tr("equation")}};
    for (const NewtonRow& row : view.newton) {
        table.push_back(
            {std::to_string(row.iteration), small_text(row.phi_norm), small_text(row.largest_value),
             row.stepped ? small_text(row.delta_norm) : "",
             row.stepped ? number_text(row.turn_deg * row.fraction, 3) + "°" : "",
             row.stepped ? std::to_string(row.rank) : "",
             row.largest_row + (row.note.empty() ? "" : "   " + row.note)});
    }
    return text_table(table, columns_of_numbers(table.front().size(), 2));
}

std::string rank_text(const View& view, int width) {
    const RankView& rank = view.rank;
    std::string text = "  " +
                       tr("{0}, {1} (r, ω′), rank {2}, {3}, {4}, mobility by counting {5}",
                          tr_count(rank.rows, "{0} equation", "{0} equations"),
                          tr_count(rank.columns, "{0} column", "{0} columns"), rank.rank,
                          tr_count(rank.dof, "{0} freedom", "{0} freedoms"),
                          tr_count(rank.redundant(), "{0} redundant equation", "{0} redundant equations"),
                          rank.mobility_by_counting) +
                       '\n';
    if (!rank.singular_values.empty()) {
        const std::string values =
            joined(rank.singular_values, " ", [](double s) { return number_text(s, 3); });
        const std::string line =
            tr("singular values: {0}; up to {1} they count as zero", values, small_text(rank.threshold));
        text += "  " + wrapped(line, width - 2, 4) + '\n';
    }
    if (rank.near_singular) {
        text +=
            std::string("  ") +
            tr("The smallest nonzero one is small compared with the others: the pose is nearly singular.") +
            '\n';
    }
    for (const std::string& doubt : rank.doubts) { text += "  " + wrapped(doubt, width - 2, 2) + '\n'; }
    for (const std::string& combination : rank.combinations) {
        text += labelled(tr("redundant:"), combination, width);
    }
    for (const std::string& motion : rank.told_motions()) { text += labelled(tr("free:"), motion, width); }
    return text;
}

/// A number as text; 0 if it is only rounding in a solution of size 1 in m and degrees.
std::string clean_text(double value) {
    constexpr double kRounding = 1e-10;
    return number_text(std::abs(value) < kRounding ? 0.0 : value, 6);
}

std::string motion_text(const View& view) {
    TextRows quantities{{tr("quantity"), tr("value"), tr("rate"), tr("acceleration"), ""}};
    for (const QuantityMotion& q : view.quantities) {
        quantities.push_back(
            {q.name, clean_text(q.value), clean_text(q.rate), clean_text(q.acceleration),
             (q.unit == "-" ? "" : q.unit) + (q.driven ? " " + std::string(tr("driven")) : "")});
    }
    TextRows bodies{{tr("body"), "r [m]", "ṙ [m/s]", "ω [rad/s]"}};
    for (const BodyMotion& b : view.bodies) {
        bodies.push_back({b.body, vector_text(b.r), vector_text(b.r_dot), vector_text(b.omega)});
    }
    return (view.quantities.empty() ? "" : text_table(quantities, columns_of_numbers(5, 2))) +
           text_table(bodies, columns_of_numbers(4, 2));
}

/// The first of many names: "a, b, c, ..."
std::string some_of(const std::vector<std::string>& names) {
    constexpr std::size_t most = 24;
    return joined(names | std::views::take(most), ", ") + (names.size() > most ? ", ..." : "");
}

/// The question with its choices, or its answer with the reason.
std::string question_text(const QuestionView& question, int width) {
    std::string text = "  ? " + wrapped(math::plain_words(question.ask), width - 4, 4) + '\n';
    if (!question.answered) {
        for (std::size_t k = 0; k < question.choices.size(); ++k) {
            const std::string choice = std::to_string(k + 1) + ") " + math::plain_words(question.choices[k]);
            text += "    " + wrapped(choice, width - 4, 7) + '\n';
        }
        if (!question.how.empty()) { text += "    " + wrapped(question.how, width - 4, 4) + '\n'; }
        if (!question.names.empty()) {
            text += "    " + wrapped(some_of(question.names), width - 4, 4) + '\n';
        }
        return text;
    }
    text += "  ! " + wrapped(math::plain_words(question.answer), width - 4, 4) + '\n';
    if (question.why.empty()) { return text; }
    return text + "  » " + wrapped(math::plain_words(question.why), width - 4, 4) + '\n';
}

void join(std::string& text, const std::string& more) {
    if (!more.empty()) { text += (text.empty() ? "" : " · ") + more; }
}

std::string meaning_line(const SymbolView& symbol, const SymbolMeaning& meaning, bool several) {
    const std::string owner = several && !meaning.owner.empty() ? meaning.owner + ":  " : "";
    std::string line = owner + "$" + meaning.source + " = " + matrix_markup(meaning.value) + "$";
    if (!symbol.unit.empty()) { line += " " + symbol.unit; }
    return meaning.frame.empty() ? line : line + "  " + meaning.frame;
}

}  // namespace

std::string describe(const View& view, int width) {
    std::string text = "[" + std::to_string(view.step) + "] " + view.title;
    if (view.kind == Step::Kind::iteration) { text += " · " + std::string(tr("iteration")); }
    if (view.kind == Step::Kind::assembled) { text += " · " + std::string(tr("assembled")); }
    text += '\n';
    if (!view.sentence.empty()) { text += "  " + wrapped(view.sentence, width - 2, 2) + '\n'; }
    if (!view.author_text.empty() && view.kind != Step::Kind::iteration &&
        view.kind != Step::Kind::assembled) {
        text += "  » " + wrapped(math::plain_words(view.author_text), width - 4, 4) + '\n';
    }
    switch (view.kind) {
        case Step::Kind::bodies:
        case Step::Kind::iteration: break;
        case Step::Kind::question:
        case Step::Kind::answer: text += question_text(*view.question, width); break;
        case Step::Kind::equations: text += equations_text(view, width); break;
        case Step::Kind::assembled: text += newton_text(view) + rank_text(view, width); break;
        case Step::Kind::failed:
            text += "  " + wrapped(view.failure, width - 2, 2) + '\n' + newton_text(view);
            break;
        case Step::Kind::motion:
            text += motion_text(view);
            if (!view.velocity_note.empty()) {
                text += "  " + wrapped(view.velocity_note, width - 2, 2) + '\n';
            }
            if (!view.failure.empty()) { text += "  " + wrapped(view.failure, width - 2, 2) + '\n'; }
            break;
    }
    return text;
}

std::vector<std::string> symbol_tip(const SymbolView& symbol) {
    std::string head = symbol.what;
    const bool several = symbol.meanings.size() > 1;
    if (!several) { join(head, symbol.meanings.front().owner); }
    join(head, symbol.defined);
    std::vector<std::string> lines;
    if (!head.empty()) { lines.push_back(head); }
    for (const SymbolMeaning& meaning : symbol.meanings) {
        lines.push_back(meaning_line(symbol, meaning, several));
    }
    if (symbol.more > 0) { lines.push_back(tr("and {0} more", symbol.more)); }
    return lines;
}

std::vector<std::string> derivation_tip(const Derivation& derivation) {
    std::vector<std::string> lines{"$" + derivation.formula + "$"};
    if (!derivation.numbers.empty()) { lines.push_back("$= " + derivation.numbers + "$"); }
    if (!derivation.block.empty()) { lines.push_back("$= " + derivation.block + "$"); }
    if (!derivation.row.empty()) { lines.push_back(derivation.row); }
    return lines;
}

}  // namespace jw
