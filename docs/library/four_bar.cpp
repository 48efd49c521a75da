#include <exception>
#include <iostream>
#include <numbers>

#include <jointwise/analysis.hpp>
#include <jointwise/lesson.hpp>
#include <jointwise/picture.hpp>

using namespace jointwise;

/// A four-bar in the plane z = 0 with four hinges about z: 20 equations, of which 17 are independent.
Mechanism four_bar() {
    const Vector3 A{0, 0, 0}, B{0, 1, 0}, C{2, 2, 0}, D{3, 0, 0};
    Mechanism m;
    const int crank = m.add_body("crank", 0.5 * (A + B));
    const int coupler = m.add_body("coupler", 0.5 * (B + C));
    const int rocker = m.add_body("rocker", 0.5 * (C + D));
    const int hinge = m.add_joint("A", "revolute", 0, crank, {.at = A});
    m.add_joint("B", "revolute", crank, coupler, {.at = B});
    m.add_joint("C", "revolute", coupler, rocker, {.at = C});
    m.add_joint("D", "revolute", 0, rocker, {.at = D});
    m.add_driver("motor", hinge, {0.0, 2.0 * std::numbers::pi});  // one turn in a second
    return m;
}

int main(int argc, char** argv) try {
    const Mechanism m = four_bar();
    const Pose pose = assemble(m);
    const Rank rank = rank_at(m, pose);
    std::cout << rank.rows << " equations, rank " << rank.rank << ", " << rank.redundant << " redundant:";
    for (const std::string& row : rank.redundant_rows) { std::cout << ' ' << row; }
    std::cout << '\n';

    const Rates velocities = velocities_at(m, pose);
    const Equations e = equations_at(m, pose, velocities, Coordinates::omega_local);
    std::cout << "Jacobian " << e.jacobian.rows() << " x " << e.jacobian.cols() << ", largest |Phi| "
              << (e.phi.cwiseAbs().maxCoeff() < 1e-12 ? "below 1e-12" : "too large") << '\n';
    for (const Moment& moment : follow(m, {0.0, 0.25, 0.5})) {
        std::cout << "t = " << moment.pose.t << " s: rocker turns at " << moment.velocity.omega_local[3].z()
                  << " rad/s\n";
    }
    if (argc > 1) {
        const Lesson lesson = read_lesson(argv[1]);
        std::cout << lesson.title() << '\n';
        write_png(draw(lesson, assemble(lesson.mechanism()), 640, 360), "lesson.png");
        write_png(draw(m, pose, 640, 360), "four_bar.png");
    }
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
