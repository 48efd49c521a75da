#include <array>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "core/kinematics/manifold.hpp"
#include "tests/support/driven_loops.hpp"

using namespace jw;
using namespace jw::test;

namespace {

/// A loop without a driver, pulled by hand. The angle of its former crank determines where the compared point
/// is on the branch of the start.
class PulledLoop {
public:
    explicit PulledLoop(DrivenLoop loop)
        : loop_(std::move(loop)), dragger_(system_, start_state(mechanism_), 0.0) {}

    /// Pulls any point of a body by up to three sizes.
    void pull_anywhere(Random& random) {
        const int body = 1 + static_cast<int>(random.number(0.0, bodies() - 1e-9));
        const Vec3 point_local = random.vector(0.7 * loop_.size);
        const double far = std::pow(10.0, random.number(-2.0, 0.5)) * loop_.size;
        dragger_.pull(body, point_local, global(body, point_local) + random.vector(far));
    }
    /// Pulls the crank on by up to 0.6 rad. @return the share of it that it turns
    double pull_round(Random& random, double sense) {
        const Vec3 point_local = random.vector(0.7 * loop_.size);
        const JointGeometry& hinge = mechanism_.joints[0].geometry;
        const Vec3 centre = global(0, hinge.P_i_local);
        const Vec3 axis = (global(0, hinge.s_i_local) - global(0, Vec3::Zero())).normalized();
        const double turn = sense * random.number(0.05, 0.6);
        const Vec3 arm = global(1, point_local) - centre;
        const double before = crank_angle();
        dragger_.pull(
            1, point_local, centre + rotation_matrix(turned_global(Vec4::Unit(0), turn * axis)) * arm);
        return std::remainder(crank_angle() - before, 2.0 * std::numbers::pi) / turn;
    }

    /// Distance from the branch of the start, in sizes.
    double off_branch() const {
        const std::vector<double>& angle = loop_.mechanism.drivers[0].function.polynomial;
        const double t = (crank_angle() - angle[0]) / angle[1];
        return (global(loop_.body, loop_.point_local) - loop_.expected(t)).norm() / loop_.size;
    }
    const DrivenLoop& loop() const { return loop_; }

private:
    double crank_angle() const { return relative_angle(mechanism_.joints[0], dragger_.state()); }
    int bodies() const { return static_cast<int>(mechanism_.bodies.size()) - 1; }
    Vec3 global(int body, const Vec3& point_local) const {
        const State& state = dragger_.state();
        return state.r[at(body)] + rotation_matrix(state.p[at(body)]) * point_local;
    }
    static Mechanism without_drivers(Mechanism mechanism) {
        mechanism.drivers.clear();
        return mechanism;
    }

    DrivenLoop loop_;
    Mechanism mechanism_ = without_drivers(loop_.mechanism);
    System system_{mechanism_, everything(mechanism_)};
    Dragger dragger_;
};

}  // namespace

TEST_CASE("Loops that are pulled by hand stay on their branch, however near to folding", "[branches]") {
    // 162,000 pulls were tested once
    constexpr unsigned kLoops = 40;
    constexpr int kPulls = 15;
    constexpr std::array classes{driven_four_bar, driven_slider_crank, driven_spatial_loop, driven_row};
    double turned = 0.0;
    for (unsigned k = 0; k < kLoops; ++k) {
        const unsigned seed = 9000 + k;
        Random random(seed);
        const double margin = std::pow(10.0, random.number(-9.0, -3.0));
        PulledLoop pulled(classes[k % classes.size()](random, margin));
        const bool goes_round = k < kLoops / 2;
        CAPTURE(seed, pulled.loop().name, pulled.loop().margin, pulled.loop().size);
        for (int n = 0; n < kPulls; ++n) {
            if (goes_round) {
                turned += pulled.pull_round(random, k % 8 < 4 ? 1.0 : -1.0);
            } else {
                pulled.pull_anywhere(random);
            }
            // branches are 2 sqrt(margin) apart where they come nearest; a pose with a residual of 1e-13 is
            // known to 1e-13 / sqrt(margin) there
            REQUIRE(pulled.off_branch() < 0.3 * std::sqrt(pulled.loop().margin));
        }
    }
    // the hand is followed: only past a fold more than one pull may be needed
    CHECK(turned > 0.9 * kPulls * kLoops / 2);
}
