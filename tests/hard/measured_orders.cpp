#include <cmath>

#include "core/integrate/explicit_integrator.hpp"
#include "core/integrate/independent_coordinates.hpp"
#include "core/integrate/radau.hpp"
#include "core/integrate/semi_implicit.hpp"
#include "tests/hard/cases.hpp"
#include "tests/hard/dynamic_scene.hpp"

namespace jw::hard {

namespace {

constexpr std::size_t kSample = 25;  // of the reference: 0.5 s of a chain of ball joints

/// Error of the chain's end after so many equal steps.
class Halving {
public:
    explicit Halving(const DynamicScene& scene)
        : scene_(&scene),
          centroidal_(centroidal_of(scene.lesson)),
          start_(flat_start(centroidal_.mechanism)) {}

    template <class Stepper, class... Table>
    double error(int steps, const Table&... table) const {
        const auto equations = block_equations(centroidal_);
        Stepper stepper = make<Stepper>(*equations, steps, table...);
        while (stepper.t() < end() && stepper.step(end())) {}
        return error_of(stepper.y());
    }
    /// Order: log2 of the ratio of the errors with `steps` and with twice as many.
    template <class Stepper, class... Table>
    double order(int steps, const Table&... table) const {
        return std::log2(error<Stepper>(steps, table...) / error<Stepper>(2 * steps, table...));
    }
    double order_of_averaged_turns(int steps) const {
        return std::log2(error_of(by_averaged_turns(steps)) / error_of(by_averaged_turns(2 * steps)));
    }

private:
    double end() const { return scene_->reference.times[kSample]; }
    double error_of(const std::vector<double>& y) const {
        TrajectoryErrors errors(scene_->lesson, scene_->reference);
        errors.look_at(kSample, y);
        return errors.position();
    }
    template <class Stepper, class... Table>
    Stepper make(DrivableEquations& equations, int steps, const Table&... table) const {
        IntegrationOptions options;
        options.fixed_step = end() / steps;
        options.tolerance = 1e-13;  // of the equations that implicit methods solve
        options.length_scale = extent(centroidal_.mechanism);
        if constexpr (std::is_same_v<Stepper, RadauIntegrator>) {
            return Stepper(
                equations, std::make_unique<IndependentCoordinates>(centroidal_, equations), table...,
                options, 0.0, start_);
        } else {
            return Stepper(equations, table..., options, 0.0, start_);
        }
    }
    std::vector<double> by_averaged_turns(int steps) const;

    const DynamicScene* scene_;
    Centroidal centroidal_;
    std::vector<double> start_;
};

/// y + h Σ w k, with every body turned about the average of its ω': as if ω' were the rate of three angles.
std::vector<double> moved(
    const std::vector<double>& y, double h, const std::array<double, 4>& w,
    const std::array<std::vector<double>, 4>& k) {
    std::vector<double> out = y;
    for (std::size_t body = 0; body < y.size(); body += kNumbersPerBody) {
        Vec3 turn = Vec3::Zero();
        for (std::size_t s = 0; s < 4; ++s) {
            if (k[s].empty() || w[s] == 0.0) { continue; }
            for (std::size_t n = 0; n < kNumbersPerBody; ++n) { out[body + n] += h * w[s] * k[s][n + body]; }
            // k holds ω' = 2 L ṗ of the stage in the place of the rate of p
            turn += h * w[s] * vec3(k[s].data() + body + 3);
        }
        vec4(out.data() + body + 3) = turned_local(vec4(y.data() + body + 3), turn);
    }
    return out;
}

/// The classical method of fourth order with these averaged turns.
std::vector<double> Halving::by_averaged_turns(int steps) const {
    const auto equations = block_equations(centroidal_);
    std::vector<double> y = start_;
    equations->choose_rows(0.0, y.data());
    const double h = end() / steps;
    for (int n = 0; n < steps; ++n) {
        std::array<std::vector<double>, 4> k;
        const auto stage = [&](std::size_t s, double share, const std::array<double, 4>& w) {
            const std::vector<double> at = moved(y, share * h, w, k);
            k[s].resize(y.size());
            equations->evaluate((n + share) * h, at.data(), k[s].data());
            for (std::size_t body = 0; body < y.size(); body += kNumbersPerBody) {
                vec3(k[s].data() + body + 3) = vec3(at.data() + body + 10);
            }
        };
        stage(0, 0.0, {});
        stage(1, 0.5, {1.0, 0.0, 0.0, 0.0});
        stage(2, 0.5, {0.0, 1.0, 0.0, 0.0});
        stage(3, 1.0, {0.0, 0.0, 1.0, 0.0});
        y = moved(y, h, {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0}, k);
        equations->project((n + 1) * h, y.data());
    }
    return y;
}

}  // namespace

/// The steps are few enough that rounding has no effect, and many enough that the order shows.
Result orders_measured() {
    const DynamicScene scene = shipped_scene("dynamics/chain-spherical-4.toml");
    const Halving by(scene);
    const auto near = [](double order) { return Bounds{order - 0.3, order + 1.0}; };
    Result result;
    result.naive =
        "a turn by the average of four angular velocities is not the sum of the small turns. The method of "
        "fourth order becomes one of second order, unnoticed.";
    result.ours = "p itself is integrated, by ṗ = ½ Lᵀ ω', and normalised after the step.";
    result.measurements = {
        of_ours("order of euler", by.order<ExplicitIntegrator>(1000, explicit_euler()), near(1)),
        of_ours("order of semi-implicit", by.order<SemiImplicitEuler>(1000), near(1)),
        of_both(
            "order of rk4", by.order_of_averaged_turns(200), at_most(2.5),
            by.order<ExplicitIntegrator>(200, runge_kutta_4()), near(4)),
        of_ours("order of explicit-5", by.order<ExplicitIntegrator>(20, dormand_prince_54()), near(5)),
        of_ours("order of explicit-8", by.order<ExplicitIntegrator>(10, dormand_prince_853()), near(8)),
        of_ours("order of implicit-5", by.order<RadauIntegrator>(32, 3), near(5)),
        of_ours("order of implicit-9", by.order<RadauIntegrator>(8, 5), near(9)),
    };
    return result;
}

}  // namespace jw::hard
