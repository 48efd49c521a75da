#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/session/answers/question_view.hpp"
#include "app/session/view/dynamics_view.hpp"
#include "app/session/view/free_motions.hpp"
#include "app/session/view/quantities.hpp"
#include "app/session/view/symbols.hpp"
#include "app/session/view/view_equations.hpp"

/// Contents of a step as plain values. The terminal, the JSON, the panels and the pictures all read them, so
/// a number shown in two places is computed once. Formulas are written as in docs/mathematics.md.
namespace jw {

struct MatrixView {
    struct Row {
        std::string owner;       ///< joint, driver or body (normalisation)
        std::string label;       ///< "p1 y"
        bool redundant = false;  ///< implied by the others
        bool subject = false;    ///< belongs to the joint or driver of the step
    };
    struct Column {
        std::string owner;   ///< body, or joint for θ
        std::string symbol;  ///< "x", "e₀", "ω′x", "θ"
    };
    CoordinateChoice choice = CoordinateChoice::omega_local;
    std::vector<Row> rows;
    std::vector<Column> columns;
    MatrixX values;  ///< Φq [rows x columns]
};

struct RankView {
    int rows = 0;
    int columns = 0;
    int rank = 0;
    int dof = 0;
    int mobility_by_counting = 0;
    int rank_before = -1;  ///< -1: nothing to compare with
    /// Before assembly: the rank that the same equations have once they hold. Rows become redundant only at
    /// the solution, so the rank of an unassembled pose may be larger.
    std::optional<int> once_assembled;
    bool has_spectrum = true;             ///< false: singular_values and free_motions were not computed
    std::vector<double> singular_values;  ///< largest first, of the (r, ω′) matrix
    double threshold = 0.0;
    double residual = 0.0;
    bool assembled = true;
    bool near_singular = false;
    double singular_value_error = 0.0;        ///< bound on the error of each of them
    bool decided = true;                      ///< false: it is not known what the rank is; `doubts` says why
    std::vector<std::string> doubts;          ///< what is not proved, one sentence each; mostly empty
    std::vector<std::string> redundant_rows;  ///< labels
    std::vector<std::string> combinations;  ///< "D · p1 · x = −1 A · p1 · x + ...", one per redundant row
    std::vector<std::string> free_motions;  ///< "rod turns about its own axis", "crank: ω′z 1; ..."
    MotionsWhenAsked judged_motions;        ///< the same with verdicts; none where they are not listed
    std::optional<TypedVerdict> typed;      ///< where digits of the lesson decide the rank

    int redundant() const { return rows - rank; }
    /// Free motions as lists show them, with their verdicts if there are any.
    std::vector<std::string> told_motions() const;
    /// True if the rank at the pose differs from the rank that the equations have once they hold.
    bool differs_once_assembled() const { return once_assembled && *once_assembled != rank; }
};

struct NewtonRow {
    int iteration = 0;
    double phi_norm = 0.0;
    std::string largest_row;  ///< label
    double largest_value = 0.0;
    bool stepped = false;  ///< false: the members below are meaningless
    double delta_norm = 0.0;
    double turn_deg = 0.0;  ///< largest turn of a body in the full step
    double fraction = 1.0;  ///< of the full step taken
    int rank = 0;
    std::string note;  ///< "closed", "step limited", "wrong branch: leaving it", may be empty
};

struct BodyMotion {
    std::string body;
    Vec3 r = Vec3::Zero();          ///< [m]
    Vec4 p{1.0, 0.0, 0.0, 0.0};     ///< (e0, e1, e2, e3)
    Vec3 r_dot = Vec3::Zero();      ///< [m/s]
    Vec3 r_ddot = Vec3::Zero();     ///< [m/s²]
    Vec3 omega = Vec3::Zero();      ///< global [rad/s]
    Vec3 omega_dot = Vec3::Zero();  ///< global [rad/s²]
};

struct View {
    Step::Kind kind = Step::Kind::bodies;
    int step = 0;   ///< index into the story
    int steps = 0;  ///< of the story; 0: this is not a step of a story
    double t = 0.0;
    std::string lesson_title;
    std::string source;                    ///< of the joint's type where there is one, else of the lesson
    std::string title;                     ///< "Joint C · revolute · coupler – rocker"
    std::string sentence;                  ///< what happened, with the real numbers
    std::string author_text;               ///< may be empty
    std::optional<QuestionView> question;  ///< of a question and its answer
    std::vector<EquationGroup> equations;
    std::vector<SymbolView> symbols;  ///< of the texts above and of the formulas of `equations`
    MatrixView matrix;
    RankView rank;
    std::vector<NewtonRow> newton;  ///< of this solve, up to this step
    std::vector<BodyMotion> bodies;
    std::vector<QuantityMotion> quantities;  ///< motion only
    std::optional<DynamicsView> dynamics;    ///< motion by masses and forces only
    std::string velocity_note;               ///< "not unique: ..." or empty
    std::string failure;                     ///< joint, row, time, residual, cause, remedy; empty if none
};

/// Parts of a view to compute: text and JSON do not show the matrix and the equations of motion, which are
/// most of the work for a large system.
enum class ViewParts { all, without_matrix };

/// @param index of the step in the story
View view_of(const Story& story, int index, ViewParts parts = ViewParts::all);

/// View of a step that takes the place of step `index` of the story, such as a pose moved by hand.
View view_of(const Story& story, const Step& step, int index, ViewParts parts = ViewParts::all);

}  // namespace jw
