#include "app/session/wording/explanations.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw {

std::string branch_text(const System& system, const WrongBranch& wrong) {
    const Constraint& c = system.constraints()[at(wrong.constraint)];
    const std::string& joint = system.mechanism().joints[at(c.joint)].name;
    switch (wrong.kind) {
        case WrongBranch::Kind::anti_parallel:
            return tr(
                "the axes sᵢ and sⱼ of joint {0} point in opposite directions (cosine {1})", joint,
                number_text(wrong.measure, 3));
        case WrongBranch::Kind::half_turn:
            return tr("the side vectors of joint {0} are half a turn away from where they started", joint);
        case WrongBranch::Kind::screw_angle: break;
    }
    return tr("θ of joint {0} is half a turn off the angle between its bodies", joint);
}

std::string combination_text(const System& system, const RedundantRow& redundant, std::size_t most_terms) {
    std::string text = row_label(system, redundant.row) + " = ";
    if (redundant.terms.empty()) {
        return tr("{0} = 0: its row is zero here", row_label(system, redundant.row));
    }
    for (std::size_t k = 0; k < redundant.terms.size(); ++k) {
        if (k == most_terms) { return tr("{0} + {1} more", text, redundant.terms.size() - k); }
        const RedundantRow::Term& term = redundant.terms[k];
        const double size = std::abs(term.coefficient);
        const bool negative = term.coefficient < 0.0;
        text += k == 0 ? (negative ? "−" : "") : (negative ? " − " : " + ");
        if (std::abs(size - 1.0) > 1e-9) { text += number_text(size, 3) + " "; }
        text += row_label(system, term.row);
    }
    return text;
}

std::string free_motion_text(const System& system, const FreeMotion& motion) {
    constexpr double kNothing = 1e-9;  // rounding of the elimination that made the basis
    const std::vector<ColumnName> names = column_names(system, CoordinateChoice::omega_local);
    std::vector<std::string> owners;
    bool only_turns = true;
    for (std::size_t k = 0; k < names.size(); ++k) {
        if (std::abs(motion(static_cast<Eigen::Index>(k))) < kNothing) { continue; }
        if (std::ranges::find(owners, names[k].owner) == owners.end()) { owners.push_back(names[k].owner); }
        only_turns = only_turns && names[k].coordinate.starts_with("omega");
    }
    std::string text;
    for (const std::string& owner : owners) {
        std::string entries;
        for (std::size_t k = 0; k < names.size(); ++k) {
            const double value = motion(static_cast<Eigen::Index>(k));
            if (names[k].owner != owner || std::abs(value) < kNothing) { continue; }
            entries += (entries.empty() ? "" : ", ") + names[k].symbol + " " + number_text(value, 3);
        }
        text += (text.empty() ? "" : "; ") + owner + ": " + entries;
    }
    if (owners.size() == 1 && only_turns) { return tr("{0} (it turns on its own)", text); }
    return text;
}

std::string departure_text(const System& system, const Departure& d) {
    static constexpr std::array kPowers{"", "", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸"};
    static_assert(kPowers.size() == kHighestOrder + 1);
    static constexpr std::array kSymbols{"x", "y", "z", "φ"};
    const Mechanism& m = system.mechanism();
    const std::string& missed = d.joint >= 0 ? m.joints[at(d.joint)].name : m.drivers[at(d.driver)].name;
    const std::string symbol = kSymbols[at(d.direction)];
    const std::string term = number_text(d.coefficient, 3) + " " + symbol + kPowers[at(d.order)];
    const std::string& body = m.bodies[at(d.body)].name;
    return d.direction == 3
               ? tr("violates {0} by {1} (order {2}); φ is the rotation of {3}", missed, term, d.order, body)
               : tr("violates {0} by {1} (order {2}); {3} is that of {4}", missed, term, d.order, symbol,
                    body);
}

const char* verdict_text(FreedomVerdict verdict) {
    switch (verdict) {
        case FreedomVerdict::finite: return tr("finite");
        case FreedomVerdict::first_order: return tr("to first order only");
        case FreedomVerdict::cannot_tell: break;
    }
    return tr("cannot tell");
}

std::string leaving_text(const System& system, const FreedomJudgement& judgement) {
    if (!judgement.departure) { return {}; }
    const std::string leaves = departure_text(system, *judgement.departure);
    return judgement.has_motion_beside ? leaves + "; " + tr("a nearby motion is finite") : leaves;
}

/// "Give 0.57735 in 'axis' of revolute joint 'hinge' more digits."
std::string advice_on_digits(const TypedVerdict& typed) {
    return typed.short_of_digits.empty() ? tr("Points, axes and poses need more digits.")
                                         : tr("Give {0} more digits.", typed.short_of_digits);
}

std::string undecided_text(const RankReport& report) {
    if (report.decided) { return {}; }
    if (!report.sound) {
        return tr(
            "The rank is not known: the singular values do not pass their check and may be off by {0}.",
            small_text(report.singular_value_error));
    }
    if (report.typed && !report.typed->is_told) {
        return followed(
            tr("The rank is not known: the numbers as typed give {0}, others that differ in their last "
               "digits may give {1}.",
               report.typed->rank_as_typed, report.typed->rank),
            advice_on_digits(*report.typed));
    }
    const auto last = static_cast<Eigen::Index>(report.rank) - 1;
    const bool may_vanish =
        last >= 0 &&
        report.singular_values(last) - report.pose_error - report.singular_value_error <= report.threshold;
    const Eigen::Index doubtful = may_vanish ? last : last + 1;
    return tr(
        "The rank is not known: a singular value of {0} may or may not be zero, since it is known only to "
        "within {2} at this pose (largest |Φ| {1}).",
        small_text(report.singular_values(doubtful)), small_text(report.residual),
        small_text(std::max(report.threshold, report.pose_error)));
}

std::vector<std::string> doubts_of(const System& system, const RankReport& report) {
    std::vector<std::string> doubts;
    if (!report.decided) { doubts.push_back(undecided_text(report)); }
    if (report.typed && report.typed->is_told && report.typed->rank < report.typed->rank_as_typed) {
        doubts.push_back(followed(
            tr("Overconstrained to the digits typed: the numbers as typed give rank {0}, but violate the "
               "equations by {1} along the motion. Numbers that differ by at most {2} half units of the last "
               "digit give rank {3} and are used.",
               report.typed->rank_as_typed, small_text(report.typed->misfit),
               number_text(report.typed->share, 2), report.typed->rank),
            advice_on_digits(*report.typed)));
    }
    for (const RedundantRow& row : report.redundant_rows) {
        if (row.misfit <= row.bound) { continue; }
        doubts.push_back(
            tr("The combination for {0} is off by {1}; rounding explains only {2}.",
               row_label(system, row.row), small_text(row.misfit), small_text(row.bound)));
    }
    for (std::size_t k = 0; k < report.free_motion_proofs.size(); ++k) {
        const FreeMotionProof& proof = report.free_motion_proofs[k];
        if (proof.holds()) { continue; }
        doubts.push_back(
            tr("Free motion {0} changes the equations by {1}; rounding explains only {2}.", k + 1,
               small_text(proof.residual), small_text(proof.bound)));
    }
    return doubts;
}

}  // namespace jw
