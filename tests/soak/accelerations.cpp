#include <cstdio>

#include "tests/soak/forms.hpp"
#include "tests/soak/motions.hpp"
#include "tests/soak/property.hpp"
#include "tests/support/generators/to_model.hpp"

namespace jw::test {

namespace {

namespace general = reference::general;

// core treats rows whose squared pivot is below 1e-9 as redundant (docs/dynamics.md): pivots stay far from
// that
constexpr long double kSound = 1e3L;

/// Tolerance for rounding: the equations of the bodies form Φq M⁻¹ Φqᵀ, which squares the condition, and the
/// condition may be some ten times the ratio of pivots. 1e-9 is for the products before that.
double allowed(long double condition) {
    const auto c = static_cast<double>(condition);
    return 1e-9 + 1e-12 * c * c;
}

/// Tolerance in joint coordinates. Heavy bodies add their inertia to light ones that carry them, and the
/// light ones' own inertia is lost below the rounding of that; arms also square the ratio of lengths.
double allowed_in_joints(const Loads& loads) {
    double heaviest = 0.0;
    double lightest = HUGE_VAL;
    for (const auto& own : loads.masses) {
        if (!own) { continue; }
        heaviest = std::max(heaviest, own->mass);
        lightest = std::min(lightest, own->mass);
    }
    return 1e-12 * heaviest / lightest;
}

std::string off_by(const char* what, double difference, double limit) {
    char text[200];
    std::snprintf(
        text, sizeof text,
        "accelerations %s differ from the long double reference by %.2g of their size (allowed %.2g)", what,
        difference, limit);
    return text;
}

/// Compares everything at one state with the reference there.
class AtState {
public:
    AtState(const Generated& generated, const Centroidal& scene, general::Mechanics& reference)
        : generated_(generated), scene_(scene), reference_(reference) {}

    Verdict look(double t, const std::vector<double>& flat) {
        const general::PlacedBodies before = reference_.bodies_at(reference_.start());
        const general::PlacedBodies placed = placed_of(scene_, flat, before);
        const reference::VecX y = reference_.state_of(placed, t);
        const general::Accelerations a = reference_.accelerations_at(y);
        if (!(a.condition < kSound)) { return not_asked("too near to a singular pose"); }
        // the state is on a branch with more freedoms than the start, or off the constraints
        if (!(a.contradiction < 1e-8L)) { return not_asked("its rows contradict each other"); }
        expected_ = motion_of(a, placed);
        size_ = size_of(a, generated_.length);
        // redundant rows contradict each other slightly: the result depends on which of them are kept
        limit_ = allowed(a.condition) + static_cast<double>(10.0L * a.contradiction * a.condition);
        t_ = t;
        return holds();
    }

    std::string block(const std::vector<double>& flat) const {
        const auto equations = block_equations(scene_);
        std::vector<double> rate(flat.size());
        equations->choose_rows(t_, flat.data());
        equations->evaluate(t_, flat.data(), rate.data());
        return judged("of the block equations", accelerations_in(scene_, rate));
    }

    std::string tree(TreeEquations& tree, const std::vector<double>& y) const {
        std::vector<double> rate(y.size());
        tree.evaluate(t_, y.data(), rate.data());
        return judged(
            "in joint coordinates", accelerations_in_joints(tree, scene_, t_, y, rate),
            allowed_in_joints(scene_.loads));
    }

    template <class C>
    std::string dense(const char* what, const Moment& moment) const {
        return judged(what, dense_accelerations<C>(scene_, moment, t_));
    }

private:
    std::string judged(const char* what, const Motion& found, double more = 0.0) const {
        const double difference = difference_of(found, expected_, generated_.length) / size_;
        return difference <= limit_ + more ? "" : off_by(what, difference, limit_ + more);
    }

    const Generated& generated_;
    const Centroidal& scene_;
    general::Mechanics& reference_;
    Motion expected_;
    double size_ = 1.0;
    double limit_ = 0.0;
    double t_ = 0.0;
};

/// Failure with the first message that is not empty; success if all are empty.
Verdict first_of(const std::vector<std::string>& all) {
    for (const std::string& wrong : all) {
        if (!wrong.empty()) { return fails(wrong); }
    }
    return holds();
}

}  // namespace

Verdict accelerations_agree(const Generated& generated) {
    Centroidal scene = centroidal(generated.mechanism, generated.loads);
    // turns of springs are counted on from the start, as the reference does
    count_turns(scene.loads, kinematics_of(start_state(scene.mechanism)));
    general::Mechanics reference(model_of(generated.mechanism, generated.loads));
    AtState here(generated, scene, reference);
    const Moment moment{start_state(scene.mechanism), start_motion(scene.mechanism)};
    const std::vector<double> flat = flat_of(scene, moment);
    if (const Verdict asked = here.look(0.0, flat); asked.kind != Verdict::Kind::holds) { return asked; }

    // at the pose at which the tree is made
    TreeEquations tree(scene, flat);
    std::vector<double> y(at(tree.size()));
    tree.from_flat(flat.data(), y.data());
    tree.choose_rows(0.0, y.data());
    const Verdict at_start = first_of(
        {here.block(flat), here.tree(tree, y), here.dense<OmegaLocal>("in (r, omega')", moment),
         here.dense<OmegaGlobal>("in (r, omega)", moment),
         here.dense<TrueEulerParameters>("in (r, p)", moment),
         here.dense<ModifiedEulerParameters>("in modified (r, p)", moment)});
    if (at_start.kind == Verdict::Kind::fails) { return at_start; }

    // and away from there
    Random random(static_cast<unsigned>(generated.recipe.seed));
    const std::vector<NumberScale> scales = tree.scales();
    for (std::size_t k = 0; k < y.size(); ++k) {
        const bool along =
            scales[k].kind == NumberScale::Kind::way || scales[k].kind == NumberScale::Kind::velocity;
        y[k] += random.number(-0.05, 0.05) * (along ? generated.length : 1.0);
    }
    const double t = 0.05;
    for (int iteration = 0; iteration < 6; ++iteration) { tree.project(t, y.data()); }
    const auto [off, rate_off] = tree.violation(t, y.data());
    if (!(off + rate_off < 1e-10)) { return holds(); }
    std::vector<double> away(flat.size());
    tree.to_flat(y.data(), away.data());
    if (here.look(t, away).kind != Verdict::Kind::holds) { return holds(); }
    return first_of({here.block(away), here.tree(tree, y)});
}

}  // namespace jw::test
