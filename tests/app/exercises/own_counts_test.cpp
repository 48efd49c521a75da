#include <catch2/catch.hpp>

#include <cmath>
#include <set>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "app/exercises/task.hpp"
#include "app/session/claims/claim_poses.hpp"
#include "lessons/exercise/read_exercises.hpp"

// Independent counts of equations: Grübler's by hand, the rank from the singular values of finite differences
// of what joints keep constant. The equations of the program are not used.

using namespace jw;

namespace {

Mat3 turn_of(const Vec4& p) { return Eigen::Quaterniond(p(0), p(1), p(2), p(3)).toRotationMatrix(); }

/// Place and turn of a body.
struct Placed {
    Vec3 r;
    Mat3 A;
};

int equations_by_hand(const std::string_view type) {
    if (type == "revolute" || type == "prismatic") { return 5; }
    if (type == "cylindrical" || type == "universal") { return 4; }
    if (type == "spherical") { return 3; }
    throw std::invalid_argument("no equations are known of " + std::string(type));
}

/// Values that a joint keeps constant, more than its equations where that is simpler: the rank is the same.
std::vector<double> kept_by(const Joint& joint, const Placed& i, const Placed& j) {
    const std::string_view type = joint.type->name;
    const JointGeometry& g = joint.geometry;
    const Vec3 d = j.r + j.A * g.P_j_local - i.r - i.A * g.P_i_local;
    const Vec3 axis = i.A * g.s_i_local;
    const Vec3 other = j.A * g.s_j_local;
    std::vector<double> all;
    const auto keep = [&](const Vec3& v) { all.insert(all.end(), v.begin(), v.end()); };
    if (type == "spherical" || type == "revolute" || type == "universal") { keep(d); }
    if (type == "universal") { all.push_back(axis.dot(other)); }
    if (type == "cylindrical" || type == "prismatic") { keep(axis.cross(d)); }
    if (type == "revolute" || type == "cylindrical") { keep(axis.cross(other)); }
    if (type == "prismatic") {
        const Mat3 relative = i.A.transpose() * j.A;
        for (int k = 0; k < 3; ++k) { keep(relative.col(k)); }
    }
    return all;
}

double angle_about_axis(const Joint& joint, const Placed& i, const Placed& j) {
    const Vec3 from = i.A * joint.geometry.u_i_local;
    const Vec3 to = j.A * joint.geometry.u_j_local;
    return std::atan2((i.A * joint.geometry.s_i_local).dot(from.cross(to)), from.dot(to));
}

VectorX kept_by_all(const Mechanism& mechanism, const std::vector<Placed>& at, bool driven) {
    std::vector<double> all;
    for (const Joint& joint : mechanism.joints) {
        const auto i = static_cast<std::size_t>(joint.body_i);
        const auto j = static_cast<std::size_t>(joint.body_j);
        const std::vector<double> kept = kept_by(joint, at[i], at[j]);
        all.insert(all.end(), kept.begin(), kept.end());
    }
    if (driven) {
        for (const Driver& driver : mechanism.drivers) {
            const Joint& joint = mechanism.joints[static_cast<std::size_t>(driver.joint)];
            all.push_back(angle_about_axis(
                joint, at[static_cast<std::size_t>(joint.body_i)],
                at[static_cast<std::size_t>(joint.body_j)]));
        }
    }
    return Eigen::Map<const VectorX>(all.data(), static_cast<Eigen::Index>(all.size()));
}

/// Finite differences for small shifts of each moving body along the axes and small turns about them.
MatrixX differences(const Mechanism& mechanism, const State& state, bool driven) {
    constexpr double kSmall = 1e-5;
    std::vector<Placed> at;
    for (std::size_t b = 0; b < state.r.size(); ++b) { at.push_back({state.r[b], turn_of(state.p[b])}); }
    std::vector<VectorX> columns;
    for (std::size_t b = 0; b < at.size(); ++b) {
        if (mechanism.bodies[b].fixed) { continue; }
        for (int k = 0; k < 6; ++k) {
            const auto moved = [&](double by) {
                std::vector<Placed> other = at;
                if (k < 3) {
                    other[b].r(k) += by;
                } else {
                    other[b].A = Eigen::AngleAxisd(by, Vec3::Unit(k - 3)).toRotationMatrix() * at[b].A;
                }
                return kept_by_all(mechanism, other, driven);
            };
            columns.emplace_back((moved(kSmall) - moved(-kSmall)) / (2.0 * kSmall));
        }
    }
    MatrixX all(columns.front().size(), static_cast<Eigen::Index>(columns.size()));
    for (std::size_t k = 0; k < columns.size(); ++k) { all.col(static_cast<Eigen::Index>(k)) = columns[k]; }
    return all;
}

int rank_by_singular_values(const MatrixX& m) {
    const VectorX values = Eigen::JacobiSVD<MatrixX>(m).singularValues();
    const double largest = values(0);
    int rank = 0;
    for (const double value : values) {
        // no singular value may lie between independent rows and the errors of finite differences
        const bool is_clear = value > 1e-3 * largest || value < 1e-7 * largest;
        CAPTURE(values.transpose());
        REQUIRE(is_clear);
        rank += value > 1e-3 * largest ? 1 : 0;
    }
    return rank;
}

/// Rows, columns and rank of what a task is about.
struct OwnCounts {
    int rows = 0;
    int columns = 0;
    int rank = 0;
};

OwnCounts own_counts(const Task& task) {
    const Lesson& lesson = task.variant.lesson;
    const Moment when = lesson.claims.front().when;
    // joints come before drivers
    const auto* const after = std::get_if<AfterAddition>(&when);
    const bool driven = after == nullptr || after->count > static_cast<int>(lesson.mechanism.joints.size());
    const Pose pose = ClaimPoses(lesson).at(when);
    REQUIRE(pose.failure.empty());
    OwnCounts counts;
    for (const Joint& joint : lesson.mechanism.joints) { counts.rows += equations_by_hand(joint.type->name); }
    if (driven) { counts.rows += static_cast<int>(lesson.mechanism.drivers.size()); }
    const MatrixX all = differences(lesson.mechanism, pose.instant.state, driven);
    counts.columns = static_cast<int>(all.cols());
    counts.rank = rank_by_singular_values(all);
    return counts;
}

int own_answer(const std::string& name, const OwnCounts& own) {
    if (name == "four-bar-rank") { return own.rank; }
    if (name == "slider-crank-grubler") { return own.columns - own.rows; }
    if (name == "bennett-redundant") { return own.rows - own.rank; }
    return own.columns - own.rank;
}

}  // namespace

TEST_CASE(
    "Counts of loops are those that are counted once more, and differ between students", "[exercises]") {
    const ExercisesRead read = read_exercise_file(std::string(JW_EXERCISES_FOLDER) + "/analysis.toml");
    int found = 0;
    for (const Exercise& exercise : read.exercises) {
        const std::set<std::string> names{
            "four-bar-rank", "slider-crank-grubler", "bennett-redundant", "rssr-freedoms"};
        if (!names.contains(exercise.name)) { continue; }
        ++found;
        const TaskMaker maker(exercise);
        std::set<int> answers;
        std::set<const Exercise*> questions;
        for (std::uint64_t student = 0; student < 40; ++student) {
            const Task task = maker.make(1000003 * student);
            CAPTURE(exercise.name, task.exercise().ask, task.problem);
            REQUIRE(task.problem.empty());
            if (!questions.insert(&task.exercise()).second) { continue; }
            const int own = own_answer(exercise.name, own_counts(task));
            CHECK(task.asked.right(0, 0) == own);
            answers.insert(own);
        }
        CAPTURE(exercise.name);
        CHECK(questions.size() == exercise.alternatives.size() + 1);
        CHECK(answers.size() == questions.size());
    }
    CHECK(found == 4);
}
