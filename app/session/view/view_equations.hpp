#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/session/story/story.hpp"

/// The equations of a joint or driver with their live values.
namespace jw {

struct EquationRow {
    enum class Status {
        kept,
        dropped,
        redundant,
        open,  ///< the joint is not added yet: a question asks which rows are kept
    };
    std::string component;  ///< "x", empty for a single equation
    double value = 0.0;     ///< Φ, as it is
    int row = -1;           ///< of the system, -1 if left out
    Status status = Status::kept;
    int equation = -1;  ///< number among all equations of its joint; -1: of a driver
};

/// Which of the three equations of p1 / p2 are kept, and why.
struct ChoiceView {
    std::string form;                   ///< "rule", "drop x", ...
    std::array<double, 3> axis_size{};  ///< |s_x|, |s_y|, |s_z| of the unit global axis s_i
    std::array<double, 3>
        pair_condition{};         ///< of the two rows left when x, y, z is left out; may be infinite
    int dropped = -1;             ///< 0, 1, 2; -1: none
    bool switched = false;        ///< differs from the choice before
    double form_condition = 0.0;  ///< of the rows in use
    std::string reason;           ///< one sentence
};

/// The equations of one primitive of the joint (or of the driver) that the step is about.
struct EquationGroup {
    std::string primitive;  ///< "p1"
    std::string formula;    ///< as docs/mathematics.md says
    std::string plain;      ///< one line of Unicode
    std::string unit;       ///< "m", "m²", "rad" or "-"
    std::vector<EquationRow> rows;
    std::optional<ChoiceView> choice;  ///< p1 and p2 only
    int joint = -1;                    ///< index in the mechanism, -1 for a driver
    std::optional<Role> role = {};     ///< of the joint's primitive
    std::string owner = {};            ///< name of the joint where those of several are shown; else empty
};

/// @param report of the step's pose: which rows are redundant. May be nullptr
/// @param choices of the joint's p1 and p2, in the order of its primitives; may be empty
std::vector<EquationGroup> equations_of_joint(
    const Step& step, int joint, const std::vector<RowChoice>& choices, const RankReport* report);
/// Equations of a joint that `after` adds, at the pose of `now`, without saying which of them are kept.
std::vector<EquationGroup> open_equations(const Step& now, const Step& after, int joint);
EquationGroup equation_of_driver(const Step& step, int driver, const RankReport* report);

/// Reasons for the rows of p1 and p2 that are kept, at the step's state.
/// @param before the system of the previous step, which may have another choice; may be nullptr
std::vector<RowChoice> choices_of_joint(
    const System& system, int joint, const State& state, const System* before);

ChoiceView choice_view_of(const RowChoice& choice);

}  // namespace jw
