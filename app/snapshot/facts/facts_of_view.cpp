#include "app/snapshot/facts/fact_list.hpp"

namespace jw::snapshot {

namespace {

constexpr double kNoEntry = 1e-14;  // of Φq: rounding of a zero, where entries are about 1

void add_texts(const View& view, FactList& facts) {
    if (view.steps > 0) {
        facts.count(Weight::detail, kStepFact, view.step + 1);
        facts.count(Weight::detail, kStepsFact, view.steps);
    }
    facts.text(Weight::failure, "failure", view.failure);
    facts.text(Weight::text, "title", view.title);
    facts.text(Weight::text, "sentence", view.sentence);
    facts.text(Weight::text, "text of the author", view.author_text);
    facts.text(Weight::text, "source", view.source);
    facts.text(Weight::text, "velocities", view.velocity_note);
    facts.number(Weight::quantity, "time", view.t, "s");
    if (!view.question) { return; }
    facts.text(Weight::text, "question", view.question->ask);
    facts.text(Weight::text, "answer", view.question->answer);
    facts.text(Weight::text, "reason of the answer", view.question->why);
    for (const std::string& choice : view.question->choices) { facts.text(Weight::text, "choice", choice); }
}

void add_rank(const RankView& rank, FactList& facts) {
    facts.count(Weight::rank, "rank", rank.rank);
    facts.count(Weight::rank, "degrees of freedom", rank.dof);
    facts.count(Weight::count, "equations", rank.rows);
    facts.count(Weight::count, "columns", rank.columns);
    facts.count(Weight::count, "mobility by counting", rank.mobility_by_counting);
    if (rank.rank_before >= 0) { facts.count(Weight::rank, "rank before", rank.rank_before); }
    if (rank.once_assembled) { facts.count(Weight::rank, "rank once assembled", *rank.once_assembled); }
    facts.text(Weight::rank, "assembled", rank.assembled ? "yes" : "no");
    facts.text(Weight::rank, "near a singular position", rank.near_singular ? "yes" : "no");
    facts.text(Weight::rank, "rank decided", rank.decided ? "yes" : "no");
    for (const std::string& row : rank.redundant_rows) { facts.text(Weight::rank, "repeats others", row); }
    for (const std::string& text : rank.combinations) { facts.text(Weight::detail, "combination", text); }
    for (const std::string& text : rank.free_motions) { facts.text(Weight::rank, "free motion", text); }
    for (const std::string& text : rank.doubts) { facts.text(Weight::rank, "doubt", text); }
    for (std::size_t k = 0; k < rank.singular_values.size(); ++k) {
        facts.number(Weight::detail, "σ" + std::to_string(k + 1), rank.singular_values[k], "of σ");
    }
}

const char* word_for(EquationRow::Status status) {
    switch (status) {
        case EquationRow::Status::kept: return "kept";
        case EquationRow::Status::dropped: return "left out";
        case EquationRow::Status::redundant: return "repeats others";
        case EquationRow::Status::open: break;
    }
    return "open";
}

void add_equations(const View& view, FactList& facts) {
    for (const EquationGroup& group : view.equations) {
        const std::string name = (group.owner.empty() ? "" : group.owner + " · ") + group.primitive;
        facts.text(Weight::text, name + " · formula", group.plain);
        for (const EquationRow& row : group.rows) {
            const std::string of = name + (row.component.empty() ? "" : " · " + row.component);
            facts.text(Weight::rank, of + " · row", word_for(row.status));
            facts.number(Weight::detail, "Φ of " + of, row.value, group.unit == "-" ? "" : group.unit);
        }
        if (!group.choice) { continue; }
        facts.text(Weight::rank, name + " · choice", group.choice->form);
        facts.text(Weight::text, name + " · reason of the choice", group.choice->reason);
    }
}

/// Adds the entries that are not zero; most are zero.
void add_matrix(const MatrixView& matrix, FactList& facts) {
    for (std::size_t i = 0; i < matrix.rows.size(); ++i) {
        for (std::size_t k = 0; k < matrix.columns.size(); ++k) {
            const double value = matrix.values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k));
            if (std::abs(value) < kNoEntry) { continue; }
            facts.number(
                Weight::detail,
                "Φq(" + matrix.rows[i].owner + " · " + matrix.rows[i].label + ", " + matrix.columns[k].owner +
                    " · " + matrix.columns[k].symbol + ")",
                value, "of Φq");
        }
    }
}

/// Adds those numbers of the iterations that are the same on every machine: the last residuals are rounding.
void add_newton(const std::vector<NewtonRow>& rows, FactList& facts) {
    if (!rows.empty()) { facts.count(Weight::count, "iterations", static_cast<int>(rows.size())); }
    for (const NewtonRow& row : rows) {
        const std::string name = "iteration " + std::to_string(row.iteration);
        facts.number(Weight::detail, name + " · ‖Φ‖", row.phi_norm, "of ‖Φ‖");
        facts.text(Weight::text, name + " · note", row.note);
        if (!row.stepped) { continue; }
        facts.number(Weight::detail, name + " · ‖Δq‖", row.delta_norm, "of ‖Δq‖");
        facts.number(Weight::detail, name + " · fraction", row.fraction, "");
        facts.count(Weight::rank, name + " · rank", row.rank);
    }
}

void add_bodies(const std::vector<BodyMotion>& bodies, FactList& facts) {
    for (const BodyMotion& body : bodies) {
        facts.vector(Weight::pose, body.body + " · r", body.r, "m");
        for (Eigen::Index k = 0; k < 4; ++k) {
            facts.number(Weight::pose, body.body + " · e" + std::to_string(k), body.p[k], "");
        }
        facts.vector(Weight::quantity, body.body + " · ṙ", body.r_dot, "m/s");
        facts.vector(Weight::quantity, body.body + " · ω", body.omega, "rad/s");
        facts.vector(Weight::quantity, body.body + " · r̈", body.r_ddot, "m/s²");
        facts.vector(Weight::quantity, body.body + " · ω̇", body.omega_dot, "rad/s²");
    }
}

void add_quantities(const std::vector<QuantityMotion>& quantities, FactList& facts) {
    for (const QuantityMotion& quantity : quantities) {
        facts.number(Weight::quantity, quantity.name, quantity.value, quantity.unit);
        facts.number(Weight::quantity, "rate of " + quantity.name, quantity.rate, quantity.unit + "/s");
        facts.number(
            Weight::quantity, "acceleration of " + quantity.name, quantity.acceleration,
            quantity.unit + "/s²");
    }
}

void add_dynamics(const DynamicsView& dynamics, FactList& facts) {
    facts.number(Weight::quantity, "kinetic energy", dynamics.energy.kinetic, "J");
    facts.number(Weight::quantity, "potential energy", dynamics.energy.potential, "J");
    facts.vector(Weight::quantity, "momentum", dynamics.momentum, "kg m/s");
    facts.vector(Weight::quantity, "angular momentum", dynamics.angular_momentum, "kg m²/s");
    for (const DynamicsView::Body& body : dynamics.bodies) {
        facts.vector(Weight::quantity, body.name + " · f", body.f, "N");
        facts.vector(Weight::quantity, body.name + " · n′", body.n_local, "N m");
    }
    for (const DynamicsView::Multiplier& m : dynamics.multipliers) {
        facts.number(Weight::quantity, "λ of " + m.owner + " · " + m.row, m.lambda, "of λ");
    }
}

}  // namespace

std::vector<Fact> facts_of(const View& view) {
    FactList facts;
    add_texts(view, facts);
    add_rank(view.rank, facts);
    add_equations(view, facts);
    add_newton(view.newton, facts);
    add_bodies(view.bodies, facts);
    add_quantities(view.quantities, facts);
    if (view.dynamics) { add_dynamics(*view.dynamics, facts); }
    add_matrix(view.matrix, facts);
    return facts.take();
}

}  // namespace jw::snapshot
