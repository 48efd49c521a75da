#include "app/session/output/describe_inspection.hpp"

#include <algorithm>
#include <cmath>

#include "app/session/output/describe.hpp"
#include "app/session/view/view_equations.hpp"
#include "app/session/wording/explanations.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/numbers.hpp"
#include "app/session/wording/text_table.hpp"
#include "app/session/wording/text_width.hpp"

namespace jw {

namespace {

constexpr int kEntryWidth = 10;

std::string entry_text(double value) {
    // an empty place is seen at once; a zero that is only rounding is no zero
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

/// Number and label of a row, and `numbers` columns as wide as `width`.
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

/// An entry of a column that is not zero.
struct Entry {
    std::size_t row = 0;
    double value = 0.0;
};

std::vector<std::vector<Entry>> columns_of(const SparseRows& jacobian) {
    std::vector<std::vector<Entry>> columns(static_cast<std::size_t>(jacobian.columns));
    for (std::size_t row = 0; row < jacobian.rows.size(); ++row) {
        jacobian.for_each_entry(jacobian.rows[row], [&](int column, double value) {
            if (value != 0.0) { columns[static_cast<std::size_t>(column)].push_back({row, value}); }
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

/// Φq in blocks of columns that fit the width, owner by owner, without the rows that are zero there.
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
        text += "\n  Φq, columns of " + names[first].owner + '\n' +
                text_table(table, columns_for_rows(widest, end - first, kEntryWidth));
        first = end;
    }
    return text;
}

std::string values_text(const VectorX& values) {
    std::string text;
    for (const double value : values) { text += (text.empty() ? "" : " ") + number_text(value, 4); }
    return text.empty() ? "none" : text;
}

std::string choices_text(const Inspection& inspection, int width) {
    std::string text;
    const System& system = *inspection.system;
    for (std::size_t k = 0; k < system.constraints().size(); ++k) {
        const Constraint& c = system.constraints()[k];
        if (!is_parallel(c.role)) { continue; }
        const Joint& joint = system.mechanism().joints[static_cast<std::size_t>(c.joint)];
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
        text += "  redundant: " + wrapped(combination_text(*inspection.system, row), width - 13, 13) + '\n';
    }
    return text;
}

/// Says of a large system how certain the rank is and how to get the full spectrum.
std::string without_spectrum_text(const RankReport& rank) {
    return "largest singular value about " + number_text(rank.first_value(), 3) +
           ", smallest one above zero about " + small_text(rank.last_value()) + "; zero up to " +
           small_text(rank.threshold) +
           ". The others and the free motions of so many columns take long: --spectrum computes them.";
}

std::string rank_lines(const Inspection& inspection, int width) {
    const RankReport& rank = inspection.rank;
    const System& system = *inspection.system;
    std::string text = "  rank " + std::to_string(rank.rank) + " of " + count_text(rank.rows, "equation") +
                       " and " + count_text(rank.columns, "column") +
                       " (r, ω′): " + count_text(rank.dof, "freedom", "freedoms") + ", " +
                       count_text(rank.redundant(), "redundant equation") + ", mobility by counting " +
                       std::to_string(rank.mobility_by_counting) + '\n';
    if (!rank.assembled) {
        text += "  The largest scaled residual is " + small_text(rank.residual) +
                ": not assembled, so this is the rank of the matrix only.\n";
    }
    if (!rank.has_spectrum) {
        return text + "  " + wrapped(without_spectrum_text(rank), width - 2, 4) + '\n' +
               redundant_lines(inspection, width);
    }
    text += "  " +
            wrapped(
                "singular values (r, ω′): " + values_text(rank.singular_values) + "; zero up to " +
                    small_text(rank.threshold),
                width - 2, 4) +
            '\n';
    text += "  " +
            wrapped("singular values of Φq above: " + values_text(inspection.singular_values), width - 2, 4) +
            '\n';
    if (!inspection.sound) {
        text += "  The singular values of Φq do not pass their check: they may be off by " +
                small_text(inspection.singular_value_error) + ".\n";
    }
    for (const std::string& doubt : doubts_of(system, rank)) {
        text += "  " + wrapped(doubt, width - 2, 2) + '\n';
    }
    text += redundant_lines(inspection, width);
    for (const std::string& motion : free_motion_texts(system, rank.free_motions)) {
        text += "  free: " + wrapped(motion, width - 8, 8) + '\n';
    }
    return text;
}

}  // namespace

std::string describe(const Inspection& inspection, const Lesson& lesson, int width) {
    const std::vector<std::string> labels = labels_of(inspection);
    const int widest = widest_of(labels) + 1;
    std::string text = lesson.title + " · " + inspection.moment + " · coordinates " +
                       name_of_choice(inspection.choice) + "\n\n";
    text += right_sides(inspection, labels, widest);
    text += matrix_text(inspection, labels, widest, width);
    const std::string choices = choices_text(inspection, width);
    if (!choices.empty()) { text += '\n' + choices; }
    text += '\n' + rank_lines(inspection, width);
    return inspection.dynamics ? text + '\n' + describe(*inspection.dynamics) : text;
}

}  // namespace jw
