#include <catch2/catch.hpp>

#include <Eigen/LU>
#include <Eigen/QR>

#include "core/motion/reactions.hpp"
#include "tests/support/driven.hpp"
#include "tests/support/random_dynamics.hpp"

using namespace jw;

namespace {

MassProperties rod(double mass) { return {mass, Vec3::Zero(), Mat3::Identity() * mass / 12.0}; }

/// Loads with the same mass for every body, centres of mass at the origins.
Loads weights(const Mechanism& mechanism, double mass, const Vec3& gravity) {
    Loads loads;
    loads.masses.assign(mechanism.bodies.size(), std::nullopt);
    for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
        if (!mechanism.bodies[b].fixed) { loads.masses[b] = rod(mass); }
    }
    loads.gravity = gravity;
    return loads;
}

/// Reactions of a mechanism at rest.
Reactions static_reactions(const Centroidal& scene) {
    const Motion none = zero_motion(scene.mechanism);
    return find_reactions(scene, 0.0, start_state(scene.mechanism), none, none);
}

/// Joint wrenches on body j from Φqᵀ λ of the dense equations, with λ = 0 for rows that are left out.
std::vector<Wrench> wrenches_of_lambda(
    const DenseEquations<OmegaGlobal>& e, const Reactions& reactions, const State& state) {
    std::vector<Wrench> out;
    for (const Reaction& reaction : reactions.reactions) {
        const bool on_j = !e.system().mechanism().bodies[static_cast<std::size_t>(reaction.body_j)].fixed;
        const int body = on_j ? reaction.body_j : reaction.body_i;
        const int column = e.system().body_column(body, 3);
        Eigen::Matrix<double, 6, 1> six = Eigen::Matrix<double, 6, 1>::Zero();
        const auto add_rows = [&](int first, int rows) {
            six += e.jacobian().block(first, column, rows, 6).transpose() * e.lambda().segment(first, rows);
        };
        for (const Constraint& c : e.system().constraints()) {
            if (c.joint == reaction.joint) { add_rows(c.first_row, c.rows()); }
        }
        for (const DriverConstraint& c : e.system().drivers()) {
            if (c.driver == reaction.driver) { add_rows(c.row, 1); }
        }
        const Vec3 force = six.head<3>();
        const Vec3 arm = reaction.point - state.r[static_cast<std::size_t>(body)];
        const double sign = on_j ? 1.0 : -1.0;
        out.push_back({sign * force, sign * (six.tail<3>() - arm.cross(force))});
    }
    return out;
}

/// Forces (x, y) on body j at the joints O, A, B, D of a four-bar and the drive torque on its crank that hold
/// the same weight at the origins of its bodies.
Eigen::Matrix<double, 9, 1> plane_statics(
    const Mechanism& mechanism, const Reactions& found, const Vec3& weight) {
    Eigen::Matrix<double, 9, 9> matrix = Eigen::Matrix<double, 9, 9>::Zero();
    const auto acts = [&](int body, int joint, double sign) {
        const Vec3 arm = found.reactions[static_cast<std::size_t>(joint)].point -
                         mechanism.bodies[static_cast<std::size_t>(body)].r;
        const int row = 3 * (body - 1);
        matrix(row, 2 * joint) = sign;
        matrix(row + 1, 2 * joint + 1) = sign;
        matrix(row + 2, 2 * joint) = -sign * arm.y();
        matrix(row + 2, 2 * joint + 1) = sign * arm.x();
    };
    acts(1, 0, 1.0);
    acts(1, 1, -1.0);
    acts(2, 1, 1.0);
    acts(2, 2, -1.0);
    acts(3, 2, 1.0);
    acts(3, 3, 1.0);
    matrix(2, 8) = 1.0;
    Eigen::Matrix<double, 9, 1> right;
    for (int body = 0; body < 3; ++body) { right.segment<3>(3 * body) << -weight.x(), -weight.y(), 0.0; }
    return matrix.partialPivLu().solve(right);
}

using Vec6 = Eigen::Matrix<double, 6, 1>;
Vec6 six_of(const Wrench& wrench) {
    Vec6 out;
    out << wrench.force, wrench.torque;
    return out;
}

/// Checks that another solution agrees in all that is unique, and that the difference is in the family.
void check_differs_by_family(const Reactions& found, const std::vector<Wrench>& other) {
    MatrixX family(6 * other.size(), found.family.size());
    VectorX differs(6 * other.size());
    double size = 0.0;
    for (const Wrench& wrench : other) { size = std::max(size, six_of(wrench).norm()); }
    for (std::size_t n = 0; n < other.size(); ++n) {
        const Reaction& r = found.reactions[n];
        const auto first = static_cast<Eigen::Index>(6 * n);
        const Vec6 difference = six_of(other[n]) - six_of(r.wrench);
        differs.segment<6>(first) = difference;
        for (std::size_t member = 0; member < found.family.size(); ++member) {
            family.col(static_cast<Eigen::Index>(member)).segment<6>(first) = six_of(found.family[member][n]);
        }
        for (std::size_t k = 0; k < 3; ++k) {
            CAPTURE(n, k);
            const Vec3 axis = r.axes.col(static_cast<Eigen::Index>(k));
            // rounding by a condition of 1e4, and the error of a state by the smallest singular value
            if (r.force_unique[k]) { CHECK(std::abs(axis.dot(difference.head<3>())) < 1e-9 * size); }
            if (r.torque_unique[k]) { CHECK(std::abs(axis.dot(difference.tail<3>())) < 1e-9 * size); }
        }
    }
    if (found.family.empty()) { return; }
    const VectorX share = family.colPivHouseholderQr().solve(differs);
    CHECK((family * share - differs).norm() < 1e-9 * size);
    CHECK(differs.norm() > 1e-3 * size);  // otherwise the solutions are equal, and nothing was tested
}

}  // namespace

TEST_CASE("A swinging rod pulls at its bearing as the closed form says", "[core][dynamics][reactions]") {
    // uniform rod of length 1 and mass 2, pivot at one end, phi from the vertical: phi'' = -3/2 g sin(phi),
    // along the rod m (g cos(phi) + phi'^2 / 2), across it m g sin(phi) / 4
    const double m = 2.0;
    const double g = 9.81;
    const double phi = 0.7;
    const double phi_dot = 3.0;
    const Vec3 along(std::sin(phi), -std::cos(phi), 0.0);
    const Vec3 across(std::cos(phi), std::sin(phi), 0.0);
    test::SceneBuilder builder;
    const int body = builder.add_body("rod", 0.5 * along);
    builder.add_joint("revolute", 0, body, Vec3::Zero(), Vec3::UnitZ());
    const Mechanism& mechanism = builder.mechanism;
    const Centroidal scene = centroidal(mechanism, weights(mechanism, m, Vec3(0.0, -g, 0.0)));
    test::Moment moment{start_state(mechanism), zero_motion(mechanism)};
    moment.motion.r_dot[1] = 0.5 * phi_dot * across;
    moment.motion.omega_local[1] = builder.local(1, phi_dot * Vec3::UnitZ());

    const Motion acceleration = test::dense_accelerations<OmegaLocal>(scene, moment, 0.0);
    const Reactions found = find_reactions(scene, 0.0, moment.state, moment.motion, acceleration);
    REQUIRE(found.reactions.size() == 1);
    CHECK(found.unique());
    CHECK(found.residual < 1e-14);  // rounding
    const Wrench& wrench = found.reactions.front().wrench;
    const Vec3 expected =
        -m * (g * std::cos(phi) + 0.5 * phi_dot * phi_dot) * along + 0.25 * m * g * std::sin(phi) * across;
    CHECK((wrench.force - expected).norm() < 1e-13);  // rounding of 34 N
    CHECK(wrench.torque.norm() < 1e-13);
}

TEST_CASE(
    "Joint forces of a four-bar at rest are those of plane statics, across the plane they are a family",
    "[core][dynamics][reactions]") {
    const double phi = 0.9;
    const double mass = 1.5;
    const Vec3 g(0.4, -9.81, 0.0);
    const Mechanism mechanism = test::driven(test::four_bar_at(phi), 0, 1.0);
    const Centroidal scene = centroidal(mechanism, weights(mechanism, mass, g));
    Centroidal at_rest = scene;
    at_rest.mechanism.drivers.front().function = test::polynomial({phi});
    const Reactions found = static_reactions(at_rest);
    REQUIRE(found.reactions.size() == 5);

    const Eigen::Matrix<double, 9, 1> plane = plane_statics(mechanism, found, mass * g);
    for (int joint = 0; joint < 4; ++joint) {
        const Reaction& reaction = found.reactions[static_cast<std::size_t>(joint)];
        CAPTURE(joint);
        // rounding of 40 N
        CHECK((reaction.wrench.force.head<2>() - plane.segment<2>(2 * joint)).norm() < 1e-12);
        CHECK(reaction.force_unique == std::array{true, true, false});
        CHECK(reaction.torque_unique == std::array{false, false, true});
        // the solution of least norm has no components that the loads do not require
        CHECK(std::abs(reaction.wrench.force.z()) < 1e-12);
        CHECK(reaction.wrench.torque.norm() < 1e-12);
    }
    const Reaction& drive = found.reactions[4];
    CHECK(drive.driver == 0);
    CHECK(drive.unique());
    CHECK(std::abs(drive.effort - plane(8)) < 1e-12);
    CHECK((drive.wrench.torque - plane(8) * Vec3::UnitZ()).norm() < 1e-12);
    CHECK(drive.wrench.force.norm() < 1e-12);
    CHECK(found.family.size() == 3);

    // the drive torque once more, by virtual work: T phi' + sum of m g r' = 0
    const test::Analysis analysis = test::analyse(mechanism, start_state(mechanism));
    double work = 0.0;
    for (const Vec3& r_dot : analysis.velocity.velocity.r_dot) { work += mass * g.dot(r_dot); }
    CHECK(std::abs(drive.effort + work) < 1e-12);
}

TEST_CASE(
    "What is called unique is the same for every choice of rows, the rest differs by the family",
    "[core][dynamics][reactions]") {
    struct Case {
        Mechanism mechanism;
        std::size_t family;
    };
    test::Random random(3);
    const std::vector<Case> cases{
        {test::driven(test::four_bar_at(0.9), 0, 1.0), 3},
        {test::bennett(1.0), 3},
        {test::bricard(1.2), 1},
        {test::cardan(0.5, 0.3), 3},
        {test::rssr(0.7), 0},
        {test::screw(0.7, 0.25, ScrewAngleForm::rotation), 0},
        {test::random_tree(random), 0}};
    for (std::size_t number = 0; number < cases.size(); ++number) {
        CAPTURE(number);
        const Mechanism& mechanism = cases[number].mechanism;
        const Centroidal scene = centroidal(mechanism, test::random_loads(random, mechanism));
        const test::Moment moment = test::random_moment(random, scene, 0.3, 0.02);
        DenseEquations<OmegaGlobal> e(scene);
        std::vector<double> y(static_cast<std::size_t>(e.size()));
        std::vector<double> y_dot(y.size());
        e.pack(moment.state, moment.motion, y.data());
        e.choose_rows(0.3, y.data());
        e.evaluate(0.3, y.data(), y_dot.data());
        const Motion acceleration = test::accelerations_of(e, y, y_dot, moment);
        const Reactions found = find_reactions(scene, 0.3, moment.state, moment.motion, acceleration);
        CHECK(found.residual < 1e-11);  // 1e-16 over the smallest singular value, at least 1e-3
        CHECK(found.holds());
        // accelerations that are wrong by a millionth along a free motion; the driven one has none
        if (mechanism.drivers.empty()) {
            Motion wrong = acceleration;
            for (Vec3& r_ddot : wrong.r_dot) { r_ddot += 1e-6 * random.vector(); }
            CHECK_FALSE(find_reactions(scene, 0.3, moment.state, moment.motion, wrong).holds());
        }
        REQUIRE(found.family.size() == cases[number].family);

        check_differs_by_family(found, wrenches_of_lambda(e, found, moment.state));
    }
}

TEST_CASE("Every joint of a Bricard linkage takes part in its one family", "[core][dynamics][reactions]") {
    const Mechanism mechanism = test::bricard(1.2);
    const Centroidal scene = centroidal(mechanism, weights(mechanism, 1.0, Vec3(0.0, 0.0, -9.81)));
    const Reactions found = static_reactions(scene);
    REQUIRE(found.family.size() == 1);
    for (const Reaction& reaction : found.reactions) { CHECK(!reaction.unique()); }
    // members are in equilibrium at every link
    for (std::size_t n = 0; n + 1 < found.reactions.size(); ++n) {
        const Wrench& a = found.family[0][n];
        const Wrench& b = found.family[0][n + 1];
        const Vec3 arm = found.reactions[n].point - found.reactions[n + 1].point;
        CHECK((a.force - b.force).norm() < 1e-13);
        CHECK((a.torque + arm.cross(a.force) - b.torque).norm() < 1e-13);
        // a revolute carries no torque about its axis
        CHECK(std::abs(found.reactions[n].axes.col(2).dot(a.torque)) < 1e-13);
    }
}

TEST_CASE(
    "Effort times rate of a driver is the power that the bodies take up", "[core][dynamics][reactions]") {
    for (unsigned seed = 1; seed <= 4; ++seed) {
        test::Random random(seed);
        Mechanism mechanism = test::random_tree(random);
        test::drive_angle(mechanism, 2, test::polynomial({0.1, 1.3}));
        const SquaredDistanceMeasure ends{Vec3(0.1, 0.2, 0.3), Vec3(0.5, 0.0, 0.2)};
        const Body& last = mechanism.bodies.back();
        const double distance = (last.r + rotation_matrix(last.p) * ends.P_j_local - mechanism.bodies[0].r -
                                 rotation_matrix(mechanism.bodies[0].p) * ends.P_i_local)
                                    .norm();
        const int j = static_cast<int>(mechanism.bodies.size()) - 1;
        mechanism.drivers.push_back({"stretch", -1, 0, j, ends, test::polynomial({distance, -0.7})});
        const Centroidal scene = centroidal(mechanism, test::random_loads(random, mechanism));
        const test::Moment moment = test::random_moment(random, scene, 0.0, 0.02);
        const Motion acceleration = test::dense_accelerations<OmegaLocal>(scene, moment, 0.0);
        const Reactions found = find_reactions(scene, 0.0, moment.state, moment.motion, acceleration);
        double delivered = 0.0;
        for (const Reaction& r : found.reactions) {
            if (r.driver < 0) { continue; }
            const Driver& driver = mechanism.drivers[static_cast<std::size_t>(r.driver)];
            delivered += r.effort * driver.function.at(0.0).f_dot;
        }

        const std::vector<BodyForce> forces = test::forces_of(scene.loads, moment);
        double taken = 0.0;
        double size = 0.0;
        for (std::size_t b = 1; b < forces.size(); ++b) {
            const MassProperties& m = *scene.loads.masses[b];
            const double power =
                moment.motion.r_dot[b].dot(m.mass * acceleration.r_dot[b] - forces[b].f) +
                moment.motion.omega_local[b].dot(m.J_local * acceleration.omega_local[b] - forces[b].n_local);
            taken += power;
            size += std::abs(power);
        }
        CHECK(std::abs(delivered) > 1e-3 * size);
        CHECK(std::abs(delivered - taken) < 1e-11 * size);  // rounding by a condition of 1e4
    }
}
