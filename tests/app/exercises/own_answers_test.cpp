#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "app/exercises/random.hpp"
#include "app/exercises/task.hpp"
#include "lessons/exercise/read_exercises.hpp"

// Answers of exercises from the values on a sheet, by formulas that are written here independently: none is a
// formula of the exercise file.

using namespace jw;

namespace {

using std::numbers::pi;
using Given = std::vector<MatrixX>;

MatrixX as_number(double x) { return MatrixX::Constant(1, 1, x); }
double number_of(const Given& given, std::size_t k) { return given[k](0, 0); }
Vec3 vector_of(const Given& given, std::size_t k) { return {given[k](0), given[k](1), given[k](2)}; }

Mat3 turned(double angle, const Vec3& axis) { return Eigen::AngleAxisd(angle, axis).toRotationMatrix(); }

/// Change of dᵀd as the rocker turns by small angles about its axes.
MatrixX row_of_a_rod(const Given& given) {
    constexpr double kSmall = 1e-6;
    const Vec3 d = vector_of(given, 0);
    const Mat3 A = given[1];
    const Vec3 s = vector_of(given, 2);
    MatrixX row(1, 3);
    for (int k = 0; k < 3; ++k) {
        const auto size = [&](double angle) {
            return (d + A * (turned(angle, Vec3::Unit(k)) * s - s)).squaredNorm();
        };
        row(0, k) = (size(kSmall) - size(-kSmall)) / (2.0 * kSmall);
    }
    return row;
}

/// Three hinges, one after the other.
MatrixX chain_turns(const Given& given) {
    const Mat3 first = turned(number_of(given, 0), Vec3::UnitZ());
    const Mat3 second = first * turned(number_of(given, 1), Vec3::UnitY());
    return number_of(given, 2) * Vec3::UnitZ() + number_of(given, 3) * first.col(1) +
           number_of(given, 4) * second.col(2);
}

/// Torque of a spring, computed in the global frame and transformed into that of the plate.
MatrixX spring_torque(const Given& given) {
    const Mat3 A = given[3];
    const Vec3 d = vector_of(given, 4);
    const Vec3 force = d.normalized() * number_of(given, 0) * (d.norm() - number_of(given, 1));
    return A.transpose() * (A * vector_of(given, 2)).cross(force);
}

/// Component by component, as Euler wrote them.
MatrixX box_turns_over(const Given& given) {
    const Vec3 J = Mat3(given[0]).diagonal();
    const Vec3 w = vector_of(given, 1);
    return Vec3(
        (J.y() - J.z()) * w.y() * w.z() / J.x(), (J.z() - J.x()) * w.z() * w.x() / J.y(),
        (J.x() - J.y()) * w.x() * w.y() / J.z());
}

/// The angle of B at two moments.
MatrixX breathing_ring(const Given& given) {
    constexpr double kSmall = 1e-5;
    const auto beta = [&](double t) {
        return std::asin(1.0 / (1.0 + std::sin(number_of(given, 0) + number_of(given, 1) * t)) - 1.0);
    };
    return as_number((beta(kSmall) - beta(-kSmall)) / (2.0 * kSmall));
}

/// A turn of π − φ about −y, and the foot twice as far as the end of the crank.
MatrixX bar_of_scott_russell(const Given& given) {
    const double phi = number_of(given, 0);
    MatrixX pose = MatrixX::Zero(7, 1);
    pose(0) = 2.0 * 0.4 * std::cos(phi);
    pose(3) = std::cos(0.5 * (pi - phi));
    pose(5) = -std::sin(0.5 * (pi - phi));
    return pose;
}

/// The sphere about the second hinge cut with the line at x and y, seen from the upper hinge.
MatrixX bob_height(const Given& given) {
    const double x = number_of(given, 3);
    const double reach = number_of(given, 1) +
                         std::cos(std::asin(number_of(given, 4) / number_of(given, 2))) * number_of(given, 2);
    return as_number(number_of(given, 0) - reach * std::cos(std::asin(x / reach)));
}

MatrixX chain_pull(const Given& given) {
    const double w = number_of(given, 0);
    return as_number(-w * w * (1.0 * 2.5 + number_of(given, 1) * 3.5));
}

MatrixX one_pendulum(const Given& given) {
    const double inertia = 2.0 * 1.0 / 3.0 + number_of(given, 0);  // two rods about their ends, and a coupler
    return as_number(-number_of(given, 1) * (2.0 * 0.5 + number_of(given, 0)) / inertia);
}

MatrixX ring_lets_go(const Given& given) {
    const Vec3 velocities =
        Vec3(0, 0, -0.5) + Vec3(-0.5, 0, -1) + Vec3(-0.5, -0.5, -1) + Vec3(0, -0.5, -1) + Vec3(0, 0, -0.5);
    const Vec3 gravity(number_of(given, 0), number_of(given, 1), number_of(given, 2));
    return as_number(velocities.dot(gravity) / (2.0 * number_of(given, 3)));
}

MatrixX missing_piece(const Given& given) {
    return as_number(
        0.25 * (number_of(given, 3) - (number_of(given, 0) + number_of(given, 1) + number_of(given, 2))));
}

/// The singular values of the two rows that are kept.
MatrixX condition_of_the_wrong_two(const Given& given) {
    const Vec3 s = vector_of(given, 0);
    // a turn δ changes s_i × s_j by s_i × (δ × s_j)
    const Mat3 change = Mat3::Identity() - s * s.transpose();
    const Eigen::JacobiSVD<MatrixX> svd(MatrixX(change.topRows(2)));
    return as_number(svd.singularValues()(0) / svd.singularValues()(1));
}

MatrixX screw_rise(const Given& given) {
    return as_number(number_of(given, 0) * (number_of(given, 1) + number_of(given, 2) / (2.0 * pi)));
}

MatrixX bead_off_the_wire(const Given& given) {
    const Vec3 along = vector_of(given, 0).normalized();
    const Vec3 d = vector_of(given, 1);
    return as_number((d - along.dot(d) * along).norm());
}

MatrixX twisted_wire(const Given& given) {
    return as_number(
        -number_of(given, 0) * (number_of(given, 2) * 2.0 * pi + number_of(given, 3)) / number_of(given, 1));
}

MatrixX newton_past_the_horizon(const Given& given) {
    constexpr double kSmall = 1e-6;
    const double theta = number_of(given, 0);
    const double slope = (std::sin(theta + kSmall) - std::sin(theta - kSmall)) / (2.0 * kSmall);
    return as_number(theta - std::sin(theta) / slope);
}

struct OwnAnswer {
    const char* file;
    const char* exercise;
    MatrixX (*answer)(const Given& given);
};
constexpr OwnAnswer kOwnAnswers[] = {
    {"dynamics.toml", "box-turns-over", box_turns_over},
    {"dynamics.toml", "chain-turns", chain_turns},
    {"dynamics.toml", "spring-torque", spring_torque},
    {"dynamics.toml", "chain-pull", chain_pull},
    {"dynamics.toml", "one-pendulum", one_pendulum},
    {"dynamics.toml", "ring-lets-go", ring_lets_go},
    {"dynamics.toml", "twisted-wire", twisted_wire},
    {"hard.toml", "missing-piece", missing_piece},
    {"hard.toml", "condition-of-the-wrong-two", condition_of_the_wrong_two},
    {"hard.toml", "newton-past-the-horizon", newton_past_the_horizon},
    {"loops.toml", "row-of-a-rod", row_of_a_rod},
    {"loops.toml", "bob-height", bob_height},
    {"loops.toml", "breathing-ring", breathing_ring},
    {"loops.toml", "bar-of-scott-russell", bar_of_scott_russell},
    {"loops.toml", "screw-rise", screw_rise},
    {"loops.toml", "bead-off-the-wire", bead_off_the_wire},
};

const Exercise& exercise_named(const ExercisesRead& read, const std::string& name) {
    for (const Exercise& exercise : read.exercises) {
        if (exercise.name == name) { return exercise; }
    }
    throw std::invalid_argument("there is no exercise " + name);
}

}  // namespace

TEST_CASE("Answers are those of formulas that are written once more", "[exercises]") {
    for (const OwnAnswer& own : kOwnAnswers) {
        const ExercisesRead read = read_exercise_file(std::string(JW_EXERCISES_FOLDER "/").append(own.file));
        const TaskMaker maker(exercise_named(read, own.exercise));
        for (const char* student : {"ann", "bob", "cyd", "dee"}) {
            const Task task = maker.make(seed_of("own", student, own.exercise));
            CAPTURE(own.exercise, student, task.problem);
            REQUIRE(task.problem.empty());
            Given given;
            for (const GivenSymbol& symbol : task.asked.given) { given.push_back(symbol.value); }
            // a thousandth of the student's tolerance; finite differences have eight digits
            CHECK(
                difference_from(task.asked.right, own.answer(given), task.asked) <=
                1e-3 * task.asked.tolerance);
        }
    }
}
