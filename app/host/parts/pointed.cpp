#include "app/host/parts/pointed.hpp"

#include <algorithm>
#include <iterator>

#include "app/session/output/describe.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw::host {

namespace {

std::vector<std::string> tip_of_cell(const Session& session, int row, int column) {
    const MatrixView& matrix = session.view().matrix;
    if (row >= matrix.values.rows() || column >= matrix.values.cols()) { return {}; }
    const MatrixView::Row& r = matrix.rows[static_cast<std::size_t>(row)];
    const MatrixView::Column& c = matrix.columns[static_cast<std::size_t>(column)];
    std::vector<std::string> lines{
        "∂(" + r.owner + " · " + r.label + ") / ∂(" + c.owner + " · " + c.symbol +
        ") = " + number_text(matrix.values(row, column), 6)};
    if (const auto derivation = derivation_of(session.step(), matrix.choice, row, column)) {
        std::ranges::move(derivation_tip(*derivation), std::back_inserter(lines));
    }
    return lines;
}

std::string tip_of_row(const Session& session, int row) {
    const View& view = session.view();
    for (const EquationGroup& group : view.equations) {
        for (const EquationRow& r : group.rows) {
            if (r.row == row) {
                return row_label(*session.step().system, row) + " = " + number_text(r.value, 6) +
                       (group.unit == "-" ? "" : " " + group.unit);
            }
        }
    }
    return row < session.step().system->rows(true) ? row_label(*session.step().system, row) : std::string();
}

std::string tip_of_link(const Session& session, const Pointable& link) {
    const Mechanism& mechanism = session.lesson().mechanism;
    const auto k = static_cast<std::size_t>(link.index);
    switch (link.kind) {
        case Pointable::Kind::body:
            return mechanism.bodies[k].fixed ? tr("{0} (fixed)", mechanism.bodies[k].name)
                                             : mechanism.bodies[k].name;
        case Pointable::Kind::joint: {
            const Joint& joint = mechanism.joints[k];
            return joint.name + ": " + std::string(joint.type->name) + ", " +
                   mechanism.bodies[static_cast<std::size_t>(joint.body_i)].name + " – " +
                   mechanism.bodies[static_cast<std::size_t>(joint.body_j)].name;
        }
        case Pointable::Kind::vector: {
            const Joint& joint = mechanism.joints[k];
            if (link.part == Pointable::kVectorD) {
                return tr("d of {0}, from body i to body j", joint.name);
            }
            const int body = link.part == Pointable::kVectorI ? joint.body_i : joint.body_j;
            return tr(
                "fixed in body {0}: {1}", link.part == Pointable::kVectorI ? "i" : "j",
                mechanism.bodies[static_cast<std::size_t>(body)].name);
        }
        default: return {};
    }
}

}  // namespace

Pointed pointed_at(const std::vector<panels::HotSpot>& spots, panels::Point mouse) {
    Pointed found;
    for (const panels::HotSpot& spot : spots) {
        if (!spot.box.contains(mouse)) { continue; }
        const Pointable::Kind kind = spot.link.kind;
        if (kind == Pointable::Kind::symbol) {
            found.symbol = spot.link;
            continue;
        }
        Pointable& under = kind == Pointable::Kind::row      ? found.row
                           : kind == Pointable::Kind::column ? found.column
                                                             : found.other;
        under = spot.link;
    }
    return found;
}

std::vector<std::string> tip_of(const Session& session, const Pointed& pointed, const Pointable& link) {
    const std::vector<SymbolView>& symbols = session.view().symbols;
    const Pointable symbol = link.kind == Pointable::Kind::symbol ? link : pointed.symbol;
    if (symbol && static_cast<std::size_t>(symbol.index) < symbols.size()) {
        return symbol_tip(symbols[static_cast<std::size_t>(symbol.index)]);
    }
    if (pointed.row && pointed.column) {
        return tip_of_cell(session, pointed.row.index, pointed.column.index);
    }
    const std::string line =
        pointed.row ? tip_of_row(session, pointed.row.index) : tip_of_link(session, link);
    return line.empty() ? std::vector<std::string>() : std::vector<std::string>{line};
}

}  // namespace jw::host
