#include "tests/app/panels/views.hpp"

#include <cmath>
#include <limits>

namespace jw::panels::test {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

EquationGroup group_of(const char* primitive, const char* formula, std::vector<EquationRow> rows) {
    EquationGroup group;
    group.primitive = primitive;
    group.formula = formula;
    group.unit = "m";
    group.rows = std::move(rows);
    return group;
}

EquationGroup same_point() {
    return group_of(
        "s",
        "\\boldsymbol{\\Phi}^{(s,3)} \\equiv \\mathbf{r}_i + \\mathbf{A}_i \\mathbf{s}'_i^P - \\mathbf{A}_j "
        "\\mathbf{s}'_j^P - \\mathbf{r}_j = \\mathbf{0}",
        {{"x", -0.0651, 0, EquationRow::Status::kept},
         {"y", 1.25e-7, 1, EquationRow::Status::kept},
         {"z", -3.4e-12, 2, EquationRow::Status::redundant}});
}

EquationGroup parallel(const char* name, const char* formula) {
    EquationGroup group = group_of(
        name, formula,
        {{"x", 0.1, 3, EquationRow::Status::kept},
         {"y", -0.2, 4, EquationRow::Status::redundant},
         {"z", 0.3, -1, EquationRow::Status::dropped}});
    ChoiceView choice;
    choice.form = "rule";
    choice.axis_size = {0.0, 0.6, 0.8};
    choice.pair_condition = {kInfinity, 1.7, 1.25};
    choice.dropped = 2;
    choice.reason =
        "The z equation is left out, because no component of sᵢ is larger than z (0.8): both equations kept "
        "contain it, and their condition number is 1.25.";
    group.choice = choice;
    return group;
}

void fill_matrix(View& view, int joints, int bodies, int rows_each) {
    MatrixView& matrix = view.matrix;
    constexpr const char* labels[] = {"s x", "s y", "s z", "p1 x", "p1 y", "θ"};
    constexpr const char* symbols[] = {"x", "y", "z", "ω′x", "ω′y", "ω′z"};
    for (int j = 0; j < joints; ++j) {
        for (int k = 0; k < rows_each; ++k) {
            const bool last = j + 1 == joints;
            matrix.rows.push_back({"joint " + std::to_string(j), labels[k], last && k > 1, last});
        }
    }
    for (int b = 0; b < bodies; ++b) {
        for (const char* symbol : symbols) {
            matrix.columns.push_back({"body " + std::to_string(b), symbol});
        }
    }
    const auto m = static_cast<Eigen::Index>(matrix.rows.size());
    const auto n = static_cast<Eigen::Index>(matrix.columns.size());
    matrix.values = MatrixX::NullaryExpr(m, n, [](Eigen::Index i, Eigen::Index j) {
        return (i + j) % 3 == 0 ? std::sin(static_cast<double>(i * j)) : 0.0;
    });
}

void fill_rank(View& view, int rank) {
    view.rank.rows = static_cast<int>(view.matrix.rows.size());
    view.rank.columns = static_cast<int>(view.matrix.columns.size());
    view.rank.rank = rank;
    view.rank.dof = view.rank.columns - rank;
    view.rank.mobility_by_counting = view.rank.columns - view.rank.rows;
    view.rank.threshold = 2.5e-9;
    for (int k = 0; k < std::min(view.rank.rows, view.rank.columns); ++k) {
        view.rank.singular_values.push_back(k < rank ? 2.0 / (1.0 + k) : 1e-17);
    }
}

void fill_newton(View& view, int iterations) {
    for (int k = 0; k < iterations; ++k) {
        NewtonRow row;
        row.iteration = k;
        row.phi_norm = std::pow(10.0, -k);
        row.largest_row = "D · s · x";
        row.largest_value = -0.5 * row.phi_norm;
        row.stepped = k + 1 < iterations;
        row.delta_norm = row.phi_norm;
        row.turn_deg = 12.5 / (1.0 + k);
        row.rank = 17;
        if (!row.stepped) { row.note = "closed"; }
        view.newton.push_back(row);
    }
}

void fill_bodies(View& view, int count) {
    for (int b = 0; b < count; ++b) {
        BodyMotion motion;
        motion.body = "body " + std::to_string(b);
        motion.r = Vec3(-0.5, 12.25, 0.001);
        motion.r_dot = Vec3(-15.3, 2.5, 0.0);
        motion.omega = Vec3(0.0, -123.4, 6.28);
        view.bodies.push_back(motion);
        view.quantities.push_back(
            {"joint " + std::to_string(b) + ".angle", "deg", b == 0, -122.5, 360.0, -1342.0});
    }
}

View titled(Step::Kind kind) {
    View view;
    view.kind = kind;
    view.step = 16;
    view.steps = 50;
    view.t = 0.25;
    view.lesson_title = "A four-bar of four revolutes";
    view.source = "slide 8";
    view.title = "Joint D · revolute · rocker – ground";
    view.sentence = "Joint D adds 5 equations, the rank grows by 2 (15 → 17). One freedom is left.";
    view.author_text = "The loop closes. Watch the rank.";
    if (kind == Step::Kind::failed) { view.failure = "D · s · x is off by -2.3e-01 at t = 0 s."; }
    return view;
}

}  // namespace

View four_bar(Step::Kind kind) {
    View view = titled(kind);
    view.equations = {
        same_point(),
        parallel(
            "p1", "\\boldsymbol{\\Phi}^{(p1,2)} \\equiv \\tilde{\\mathbf{s}}_i \\mathbf{s}_j = \\mathbf{0}")};
    fill_matrix(view, 4, 3, 5);
    fill_rank(view, 17);
    view.rank.rank_before = 15;
    view.rank.combinations = {"D · s · z = -A · s · z - 1.2 A · p1 · y", "D · p1 · x = -A · p1 · x"};
    view.rank.free_motions = {"crank: ω′z 1; rocker: ω′z 0.258"};
    fill_newton(view, 5);
    fill_bodies(view, 3);
    return view;
}

View screw(Step::Kind kind) {
    View view = titled(kind);
    view.equations = {
        parallel(
            "p1", "\\boldsymbol{\\Phi}^{(p1,2)} \\equiv \\tilde{\\mathbf{s}}_i \\mathbf{s}_j = \\mathbf{0}"),
        parallel(
            "p2", "\\boldsymbol{\\Phi}^{(p2,2)} \\equiv \\tilde{\\mathbf{s}}_i \\mathbf{d} = \\mathbf{0}"),
        group_of(
            "r", "\\boldsymbol{\\Phi}^{(r,1)} \\equiv (d - d^0) - \\alpha\\,(\\theta - \\theta^0) = 0",
            {{"", 0.0497, 5, EquationRow::Status::kept}}),
        group_of(
            "θ",
            "\\boldsymbol{\\Phi}^{(\\theta,1)} \\equiv (\\mathbf{u}_i \\times \\mathbf{u}_j)^T \\mathbf{s}_i "
            "\\cos \\theta - \\mathbf{u}_i^T \\mathbf{u}_j \\sin \\theta = 0",
            {{"", -1.5e-9, 6, EquationRow::Status::redundant}})};
    fill_matrix(view, 1, 1, 6);
    view.matrix.columns.push_back({"thread of the jack", "θ"});
    view.matrix.values.conservativeResize(Eigen::NoChange, 7);
    view.matrix.values.col(6).setConstant(-0.0032);
    fill_rank(view, 6);
    fill_newton(view, 1);
    fill_bodies(view, 1);
    return view;
}

View only_bodies(Step::Kind kind) {
    View view = titled(kind);
    fill_matrix(view, 0, 1, 0);
    fill_rank(view, 0);
    fill_bodies(view, 1);
    return view;
}

View overlong(Step::Kind kind) {
    const std::string words =
        "Words and more words, so many that nobody would read them all on a frame of a lesson; and then "
        "some. ";
    const std::string name =
        "a-body-with-a-name-that-is-as-long-as-names-may-be-and-that-has-no-space-in-it-anywhere";
    View view = screw(kind);
    for (std::string* text : {&view.lesson_title, &view.source, &view.title}) { *text = words + words; }
    for (int k = 0; k < 12; ++k) {
        view.sentence += " " + words;
        view.author_text += name + " " + words;
        view.failure += kind == Step::Kind::failed || kind == Step::Kind::motion ? words : "";
    }
    for (EquationGroup& group : view.equations) {
        if (group.choice) { group.choice->reason += words + words + words; }
    }
    view.matrix = {};
    view.rank = {};
    fill_matrix(view, 60, 70, 5);
    fill_rank(view, 290);
    for (MatrixView::Row& row : view.matrix.rows) { row.owner = name + row.owner; }
    for (MatrixView::Column& column : view.matrix.columns) { column.owner = name + column.owner; }
    view.rank.combinations.assign(40, words + words + words);
    view.rank.free_motions.assign(40, name + ": " + words + words);
    view.rank.assembled = false;
    view.rank.near_singular = true;
    view.rank.residual = 0.3;
    fill_newton(view, 60);
    for (NewtonRow& row : view.newton) {
        row.largest_row = name;
        row.note = "wrong branch: leaving it " + words;
    }
    fill_bodies(view, 70);
    for (BodyMotion& body : view.bodies) { body.body = name; }
    for (QuantityMotion& quantity : view.quantities) { quantity.name = name; }
    view.velocity_note = words + words;
    return view;
}

}  // namespace jw::panels::test
