
#include <algorithm>
#include <cmath>

#include "app/session/output/describe.hpp"
#include "app/session/view/view_equations.hpp"
#include "app/session/wording/explanations.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "app/session/wording/text_table.hpp"
#include "app/session/wording/text_width.hpp"

namespace jw {

namespace {

constexpr int kEntryWidth = 10;

std::string entry_text(double value) {
    // a dot makes an exact zero visible at once; a value that is only rounding is not an exact zero
    return value == 0.0 ? "·" : number_text(value, 4);
}

std::vector<std::string> labels_of(const Inspection& inspection) {
    std::vector<std::string> labels;
    for (int row = 0; row < static_cast<int>(inspection.phi.size()); ++row) {
        labels.push_back(row_label(*inspection.system, row));
    }
    return labels;
}

int widest_of(const std::vector<std::string>& labels) {
    int widest = 4;
    for (const std::string& label : labels) { widest = std::max(widest, displayed_width(label)); }
    return widest;
}

/// Columns for the number and label of a row, and `numbers` columns of width `width`.
std::vector<TextColumn> columns_for_rows(int widest, std::size_t numbers, int width) {
    std::vector<TextColumn> columns(numbers + 2, {true, width, 0});
    columns[0] = {false, 3, 2};
    columns[1] = {false, widest, 0};
    return columns;
}

std::string right_sides(const Inspection& inspection, const std::vector<std::string>& labels, int widest) {
    TextRows table{{"", "", "Φ", "ν", "γ"}};
    for (std::size_t k = 0; k < labels.size(); ++k) {
        const auto row = static_cast<Eigen::Index>(k);
        table.push_back(
            {std::to_string(k), labels[k], number_text(inspection.phi(row), 6),
             number_text(inspection.nu(row), 6), number_text(inspection.gamma(row), 6)});
    }
    return text_table(table, columns_for_rows(widest, 3, 13));
}

/// A nonzero entry of a column.
struct Entry {
    std::size_t row = 0;
    double value = 0.0;
};

std::vector<std::vector<Entry>> columns_of(const SparseRows& jacobian) {
    std::vector<std::vector<Entry>> columns(static_cast<std::size_t>(jacobian.columns));
    for (std::size_t row = 0; row < jacobian.rows.size(); ++row) {
        jacobian.for_each_entry(jacobian.rows[row], [&](int column, double value) {
            if (value != 0.0) { columns[at(column)].push_back({row, value}); }
        });
    }
    return columns;
}

/// Rows with an entry in one of the columns from `first` to before `end`, ascending.
std::vector<std::size_t> rows_of(
    const std::vector<std::vector<Entry>>& columns, std::size_t first, std::size_t end) {
    std::vector<std::size_t> rows;
    for (std::size_t k = first; k < end; ++k) {
        for (const Entry& entry : columns[k]) { rows.push_back(entry.row); }
    }
    std::ranges::sort(rows);
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    return rows;
}

/// Φq in blocks of columns that fit the width, owner by owner, without the rows that are zero in the block.
std::string matrix_text(
    const Inspection& inspection, const std::vector<std::string>& labels, int widest, int width) {
    const std::vector<ColumnName> names = column_names(*inspection.system, inspection.choice);
    const auto fitting = static_cast<std::size_t>(std::max(1, (width - widest - 5) / kEntryWidth));
    const std::vector<std::vector<Entry>> columns = columns_of(inspection.jacobian);
    std::string text;
    for (std::size_t first = 0; first < names.size();) {
        std::size_t end = first;
        while (end < names.size() && end - first < fitting && names[end].owner == names[first].owner) {
            ++end;
        }
        TextRows table{{"", ""}};
        for (std::size_t k = first; k < end; ++k) { table.front().push_back(names[k].symbol); }
        for (const std::size_t row : rows_of(columns, first, end)) {
            table.push_back({std::to_string(row), labels[row]});
            for (std::size_t k = first; k < end; ++k) {
                const auto entry = std::ranges::find(columns[k], row, &Entry::row);
                table.back().push_back(entry_text(entry == columns[k].end() ? 0.0 : entry->value));
            }
        }
        text += "\n  " + tr("Φq, columns of {0}", names[first].owner) + '\n' +
                text_table(table, columns_for_rows(widest, end - first, kEntryWidth));
        first = end;
    }
    return text;
}

std::string values_text(const VectorX& values) {
    return values.size() == 0 ? tr("none")
                              : joined(values, " ", [](double value) { return number_text(value, 4); });
}

std::string choices_text(const Inspection& inspection, int width) {
    std::string text;
    const System& system = *inspection.system;
    for (std::size_t k = 0; k < system.constraints().size(); ++k) {
        const Constraint& c = system.constraints()[k];
        if (!is_parallel(c.role)) { continue; }
        const Joint& joint = system.mechanism().joints[at(c.joint)];
        const ChoiceView view =
            choice_view_of(explain_choice(system, static_cast<int>(k), inspection.state, -1));
        text += "  " +
                wrapped(
                    joint.name + " · " + name_of_role(c.role, joint.parallel_form) + ": " + view.reason,
                    width - 2, 4) +
                '\n';
    }
    return text;
}

std::string redundant_lines(const Inspection& inspection, int width) {
    std::string text;
    for (const RedundantRow& row : inspection.rank.redundant_rows) {
        text += labelled(tr("redundant:"), combination_text(*inspection.system, row), width);
    }
    return text;
}

/// Text for a large system: its extreme singular values, and how to get the full spectrum.
std::string without_spectrum_text(const RankReport& rank) {
    return tr(
        "largest singular value about {0}, smallest nonzero one about {1}; up to {2} they count as zero. The "
        "others and the free motions take long with so many columns: --spectrum computes them.",
        number_text(rank.first_value(), 3), small_text(rank.last_value()), small_text(rank.threshold));
}

std::string rank_lines(const Inspection& inspection, int width) {
    const RankReport& rank = inspection.rank;
    const System& system = *inspection.system;
    std::string text = "  " +
                       tr("rank {0} of {1} and {2} (r, ω′): {3}, {4}, mobility by counting {5}", rank.rank,
                          tr_count(rank.rows, "{0} equation", "{0} equations"),
                          tr_count(rank.columns, "{0} column", "{0} columns"),
                          tr_count(rank.dof, "{0} freedom", "{0} freedoms"),
                          tr_count(rank.redundant(), "{0} redundant equation", "{0} redundant equations"),
                          rank.mobility_by_counting) +
                       '\n';
    if (!rank.assembled) {
        text +=
            "  " +
            tr("The largest scaled residual is {0}: not assembled, so this is the rank of the matrix only.",
               small_text(rank.residual)) +
            '\n';
    }
    if (!rank.has_spectrum) {
        return text + "  " + wrapped(without_spectrum_text(rank), width - 2, 4) + '\n' +
               redundant_lines(inspection, width);
    }
    const std::string values =
        tr("singular values (r, ω′): {0}; up to {1} they count as zero", values_text(rank.singular_values),
           small_text(rank.threshold));
    const std::string above = tr("singular values of Φq above: {0}", values_text(inspection.singular_values));
    text += "  " + wrapped(values, width - 2, 4) + "\n  " + wrapped(above, width - 2, 4) + '\n';
    if (!inspection.sound) {
        text += "  " +
                tr("The singular values of Φq do not pass their check: they may be off by {0}.",
                   small_text(inspection.singular_value_error)) +
                '\n';
    }
    for (const std::string& doubt : doubts_of(system, rank)) {
        text += "  " + wrapped(doubt, width - 2, 2) + '\n';
    }
    text += redundant_lines(inspection, width);
    for (const ListedMotion& motion : listed_motions(system, rank.free_motions, judgements_of(inspection))) {
        text += labelled(tr("free:"), motion.told, width);
    }
    return text;
}

constexpr const char* kSlide24 =
    "    | M   Φqᵀ | |  q̈ |   | Q |\n"
    "    | Φq   0  | | −λ | = | γ |,   M = diag(m I, J′),   Q = [f; n′ − ω̃′J′ω′]\n\n";

std::string mass_text(const DynamicsView& dynamics) {
    TextRows table{{tr("body"), "m [kg]", "J′ [kg m²]", "f [N]", "n′ − ω̃′J′ω′ [N m]"}};
    TextRows motions{{tr("body"), "r̈ [m/s²]", "ω̇′ [rad/s²]"}};
    for (const DynamicsView::Body& body : dynamics.bodies) {
        for (Eigen::Index row = 0; row < 3; ++row) {
            const Vec3 line = body.J_local.row(row);
            const bool first = row == 0;
            table.push_back(
                {first ? body.name : "", first ? number_text(body.mass, 6) : "", vector_text(line),
                 first ? vector_text(body.f, 6) : "", first ? vector_text(body.n_local, 6) : ""});
        }
        motions.push_back({body.name, vector_text(body.r_ddot, 6), vector_text(body.omega_local_dot, 6)});
    }
    return text_table(table, columns_of_numbers(5, 2)) + '\n' + text_table(motions, columns_of_numbers(3, 2));
}

std::string lambda_text(const DynamicsView& dynamics) {
    if (dynamics.multipliers.empty()) { return {}; }
    TextRows table{{tr("λ of"), "", "", ""}};
    const std::string* owner = nullptr;
    for (const DynamicsView::Multiplier& m : dynamics.multipliers) {
        const bool same = owner != nullptr && *owner == m.owner;
        owner = &m.owner;
        table.push_back(
            {same ? "" : m.owner, m.row, number_text(m.lambda, 6), m.left_out ? tr("redundant") : ""});
    }
    std::vector<TextColumn> columns = columns_of_numbers(4, 2);
    columns[1].right = false;
    return '\n' + text_table(table, columns);
}

std::string energy_text(const DynamicsView& dynamics) {
    const Energy& energy = dynamics.energy;
    const std::string energies =
        tr("kinetic energy {0} J, potential energy {1} J, together {2} J", number_text(energy.kinetic, 8),
           number_text(energy.potential, 8), number_text(energy.kinetic + energy.potential, 8));
    const std::string momenta =
        tr("momentum {0} kg m/s, angular momentum about the origin {1} kg m²/s",
           vector_text(dynamics.momentum, 6), vector_text(dynamics.angular_momentum, 6));
    const std::string proof = tr("|M q̈ − Φqᵀ λ − Q| is {0} of |M q̈| + |Q|", small_text(dynamics.residual));
    return "\n  " + energies + "\n  " + momenta + "\n  " + proof + '\n';
}

}  // namespace

std::string describe(const Inspection& inspection, const Lesson& lesson, int width) {
    const std::vector<std::string> labels = labels_of(inspection);
    const int widest = widest_of(labels) + 1;
    std::string text = lesson.title + " · " + inspection.moment + " · " +
                       tr("coordinates {0}", name_of_choice(inspection.choice)) + "\n\n";
    text += right_sides(inspection, labels, widest);
    text += matrix_text(inspection, labels, widest, width);
    const std::string choices = choices_text(inspection, width);
    if (!choices.empty()) { text += '\n' + choices; }
    text += '\n' + rank_lines(inspection, width);
    return inspection.dynamics ? text + '\n' + describe(*inspection.dynamics) : text;
}

std::string describe(const DynamicsView& dynamics) {
    const std::string head = tr("Equations of motion in (r, ω′), bodies at their centres of mass:");
    return "  " + head + "\n" + kSlide24 + mass_text(dynamics) + lambda_text(dynamics) +
           energy_text(dynamics);
}

}  // namespace jw
