#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include "core/integrate/sampler.hpp"
#include "tests/bench/peers/sundials_solver.hpp"
#include "tests/bench/peers/sweep.hpp"

/// SUNDIALS on our own equations of motion: the numbers of evaluations are compared.
namespace jw::peers {
namespace {

/// Source of the states at the sample times.
enum class Samples {
    own,    ///< its own polynomial
    stops,  ///< steps end at them
    ours,   ///< the polynomial through four ends of steps that our explicit methods use
};

constexpr int kSamples = 100;

using MakeSolver = std::unique_ptr<SundialsSolver> (*)(CountedEquations&);
struct Choice {
    const char* name;
    MakeSolver make;
    Held held;
    Samples samples;
};

template <ARKODE_ERKTableID table, int order>
std::unique_ptr<SundialsSolver> erk(CountedEquations& equations) {
    return erk_solver(equations, table, order);
}
template <ARKODE_DIRKTableID table, int order>
std::unique_ptr<SundialsSolver> dirk(CountedEquations& equations) {
    return dirk_solver(equations, table, order);
}

constexpr MakeSolver kFehlberg = erk<ARKODE_FEHLBERG_13_7_8, 8>;
constexpr MakeSolver kVerner = erk<ARKODE_VERNER_8_5_6, 6>;
constexpr MakeSolver kDormandPrince = erk<ARKODE_DORMAND_PRINCE_7_4_5, 5>;
constexpr MakeSolver kKvaerno = dirk<ARKODE_KVAERNO_7_4_5, 5>;
constexpr MakeSolver kArk548 = dirk<ARKODE_ARK548L2SA_DIRK_8_4_5, 5>;
constexpr MakeSolver kEsdirk547 = dirk<ARKODE_ESDIRK547L2SA2_7_4_5, 5>;

constexpr std::array kChoices{
    Choice{"Fehlberg 8(7)", kFehlberg, Held::after_steps, Samples::own},
    Choice{"Fehlberg 8(7) stops", kFehlberg, Held::after_steps, Samples::stops},
    Choice{"Fehlberg 8(7) with our samples", kFehlberg, Held::after_steps, Samples::ours},
    Choice{"Verner 6(5)", kVerner, Held::after_steps, Samples::own},
    Choice{"Verner 6(5) stops", kVerner, Held::after_steps, Samples::stops},
    Choice{"Verner 6(5) with our samples", kVerner, Held::after_steps, Samples::ours},
    Choice{"Dormand-Prince 5(4)", kDormandPrince, Held::after_steps, Samples::own},
    Choice{"Dormand-Prince 5(4) with our samples", kDormandPrince, Held::after_steps, Samples::ours},
    Choice{"CVODE Adams", adams_solver, Held::within, Samples::own},
    Choice{"CVODE Adams drifting", adams_solver, Held::in_samples, Samples::own},
    Choice{"CVODE BDF", bdf_solver, Held::after_steps, Samples::own},
    Choice{"CVODE BDF within", bdf_solver, Held::within, Samples::own},
    Choice{"IDA", ida_solver, Held::within, Samples::own},
    Choice{"Kvaerno 5(4)", kKvaerno, Held::after_steps, Samples::own},
    Choice{"Kvaerno 5(4) stops", kKvaerno, Held::after_steps, Samples::stops},
    Choice{"ARK548L2SA 5(4)", kArk548, Held::after_steps, Samples::own},
    Choice{"ARK548L2SA 5(4) stops", kArk548, Held::after_steps, Samples::stops},
    Choice{"ESDIRK547L2SA2 5(4)", kEsdirk547, Held::after_steps, Samples::own},
    Choice{"ESDIRK547L2SA2 5(4) stops", kEsdirk547, Held::after_steps, Samples::stops}};

/// A solver as a time stepper, from which samples are taken as from our own.
class SundialsStepper final : public TimeStepper {
public:
    SundialsStepper(CountedEquations& equations, const Choice& choice)
        : equations_(&equations),
          solver_(choice.make(equations)),
          samples_(choice.samples),
          y_(equations.start()),
          y_dot_(y_.size()) {
        find_rates();
    }

    bool step(double t_end) override {
        if (!solver_->step(t_end) || !(solver_->t() > t())) { return false; }
        t_ = solver_->t();
        y_.assign(solver_->y(), solver_->y() + y_.size());
        equations_->follow(t_, y_);
        find_rates();
        return std::ranges::all_of(y_, [](double x) { return std::isfinite(x); });
    }
    bool interpolate(double t, double* y) override {
        if (!solver_->interpolate(t, y)) { return false; }
        equations_->project_drifted(t, y);
        return true;
    }

    double t() const override { return t_; }
    const std::vector<double>& y() const override { return y_; }
    const std::vector<double>& y_dot() const override { return y_dot_; }
    const IntegrationCounts& counts() const override { return counts_; }
    bool has_polynomial() const override { return samples_ != Samples::ours; }
    const StateScales* scales() const override { return &equations_->scales(); }

private:
    void find_rates() {
        if (samples_ == Samples::ours) { equations_->evaluate(t_, y_.data(), y_dot_.data()); }
    }

    CountedEquations* equations_;
    std::unique_ptr<SundialsSolver> solver_;
    Samples samples_;
    double t_ = 0.0;
    std::vector<double> y_;
    std::vector<double> y_dot_;
    IntegrationCounts counts_;
};

/// Integrates from stop to stop. @return false if it did not reach the end
bool integrate(SundialsStepper& stepper, Sampler& sampler, const Run& run, Samples samples) {
    constexpr long steps_between_looks = 50;
    long steps = 0;
    for (int k = samples == Samples::stops ? 1 : kSamples; k <= kSamples; ++k) {
        while (stepper.t() < run.sample_time(k)) {
            if (!stepper.step(run.sample_time(k))) { return false; }
            sampler.take(stepper);
            if (sampler.ended() || (++steps % steps_between_looks == 0 && run.out_of_time())) {
                return false;
            }
        }
    }
    sampler.finish();
    return true;
}

Outcome simulate(const PeerScene& scene, const Choice& choice, double tolerance, double limit) {
    CountedEquations equations(*scene.lesson, tolerance, choice.held);
    SundialsStepper stepper(equations, choice);
    Run run(scene, limit);
    std::vector<double> times;
    for (int k = 1; k <= kSamples; ++k) { times.push_back(run.sample_time(k)); }
    const auto& point = *scene.lesson->dynamics->point;
    int sample = 0;
    const auto receive = [&](double, const std::vector<double>& y) {
        run.at_sample(++sample, equations.simulation().point(y, point.body, point.point_local));
    };
    Sampler sampler(equations.equations(), times, receive, tolerance);
    sampler.take(stepper);
    Outcome outcome;
    if (!integrate(stepper, sampler, run, choice.samples)) { outcome.remark = "ended early"; }
    outcome.milliseconds = run.milliseconds();
    outcome.error = run.error();
    outcome.evaluations = equations.evaluations();
    outcome.projections = equations.projections();
    outcome.out_of_time = run.out_of_time();
    return outcome;
}

void measure(const PeerScene& scene, double limit, Report& report) {
    for (const Choice& choice : kChoices) {
        for (double tolerance = 1e-2; tolerance > 1e-13; tolerance *= kTighter) {
            // once: only counts are compared
            const Outcome outcome = simulate(scene, choice, tolerance, limit);
            char setting[30];
            std::snprintf(setting, sizeof setting, "tolerance %.1e", tolerance);
            report.add(choice.name, setting, outcome);
            if (outcome.out_of_time || outcome.error < kEnough) { break; }
        }
    }
}

}  // namespace
}  // namespace jw::peers

int main(int count, char** arguments) {
    using namespace jw::peers;
    return for_every_scene(count, arguments, "sundials", measure, Compared::evaluations);
}
