#include <algorithm>
#include <limits>
#include <utility>

#include "app/session/picture/picture.hpp"
#include "app/session/picture/picture_parts.hpp"

namespace jw {

namespace {

using namespace picture;

// the bounds of the motion come from about this many moments: nothing goes far between them
constexpr std::size_t kMomentsSeen = 250;
// of the unit, and of |p|: a motion of a thousandth of a pixel is not visible
constexpr double kStands = 1e-6;
// a Newton iteration that moves bodies farther away than this would make everything else small
constexpr double kWildIteration = 1.6;
// the ground's axes are shown unless they would make the mechanism small, too
constexpr double kFarOrigin = 1.35;
constexpr double kVisible = 0.2;  // of the unit: length of a vector that should be visible
constexpr double kAsideLimit = 0.08;
constexpr double kSideLimit = 0.14;

/// A step whose pose is shown.
struct Moment {
    int step = 0;
    BodyChoice moved;  ///< bodies that have moved since the moments before
};
/// The steps whose poses bound all others.
struct Moments {
    std::vector<Moment> closed;
    std::vector<Moment> iterations;
};

/// Poses of `steps` with the bodies that moved: most steps of a large lesson leave nearly all in place.
std::vector<Moment> seen_in(const Story& story, const std::vector<int>& steps, double unit) {
    std::vector<Moment> moments;
    State last;  // the pose of each body when it moved last
    for (const int k : steps) {
        const State& now = story.steps()[at(k)].state;
        std::vector<bool> moved(now.r.size(), true);
        for (std::size_t b = 0; b < last.r.size(); ++b) {
            moved[b] =
                (now.r[b] - last.r[b]).norm() > kStands * unit || (now.p[b] - last.p[b]).norm() > kStands;
        }
        last.r.resize(now.r.size());
        last.p.resize(now.p.size());
        for (std::size_t b = 0; b < moved.size(); ++b) {
            if (!moved[b]) { continue; }
            last.r[b] = now.r[b];
            last.p[b] = now.p[b];
        }
        moments.push_back({k, BodyChoice(std::move(moved))});
    }
    return moments;
}

Moments moments_of(const Story& story, double unit) {
    std::vector<int> closed;
    std::vector<int> iterations;
    std::vector<int> motion;
    for (int k = 0; k < static_cast<int>(story.steps().size()); ++k) {
        const Step::Kind kind = story.steps()[at(k)].kind;
        const bool moves = kind == Step::Kind::motion;
        (moves ? motion : kind == Step::Kind::iteration ? iterations : closed).push_back(k);
    }
    const std::size_t stride = 1 + motion.size() / kMomentsSeen;
    for (std::size_t k = 0; k < motion.size(); k += stride) { closed.push_back(motion[k]); }
    if (!motion.empty()) { closed.push_back(motion.back()); }
    return {seen_in(story, closed, unit), seen_in(story, iterations, unit)};
}

void set_shapes(const Story& story, PictureStyle& style) {
    style.bodies.clear();
    for (int b = 0; b < static_cast<int>(story.lesson().mechanism.bodies.size()); ++b) {
        style.bodies.push_back(local_shapes(story.lesson(), b, style.unit, style.up));
    }
}

/// Size of the bodies over the story, without the poses of iterations.
double size_of_bodies(const Story& story, const PictureStyle& style, const Moments& moments) {
    render::Bounds bounds;
    for (const Moment& moment : moments.closed) {
        const State& state = story.steps()[at(moment.step)].state;
        render::Scene scene;
        for (int b = 0; b < static_cast<int>(style.bodies.size()); ++b) {
            if (moment.moved.contains(b)) { add_body(story.lesson(), style, state, b, 1.0F, scene); }
        }
        bounds.include(render::bounds_of(scene));
    }
    return bounds.diagonal();
}

/// First appearance of a joint in the story.
struct Arrival {
    int additions = std::numeric_limits<int>::max();  ///< the joint is present from this number on
    /// The pose at which it is first closed, which is looked at most; the last of the story if it never
    /// closes.
    const State* closed = nullptr;
};

/// Arrivals of all joints of the mechanism.
std::vector<Arrival> arrivals_in(const Story& story) {
    std::vector<Arrival> arrivals(
        story.lesson().mechanism.joints.size(), Arrival{.closed = &story.steps().back().state});
    for (const Step& step : story.steps()) {
        if (step.kind != Step::Kind::equations && step.kind != Step::Kind::assembled) { continue; }
        const Addition& added = story.lesson().order[at(step.additions - 1)];
        if (added.kind != Addition::Kind::joint) { continue; }
        Arrival& arrival = arrivals[at(added.index)];
        arrival.additions = step.additions;
        if (step.kind == Step::Kind::assembled) { arrival.closed = &step.state; }
    }
    return arrivals;
}

/// Lift of a vector that leaves the bodies at `side` from P, but may be inside a handle after that.
double lift_of(const Solid& solid, const Vec3& P, const Vec3& direction, double side, double unit) {
    const Vec3 from = P + side * direction;
    return solid.clearance(from, from + 0.5 * kVisible * unit * direction, kAsideLimit * unit);
}

JointStyle joint_style(
    const Story& story, const PictureStyle& style, int joint, const Arrival& arrival,
    const Moments& moments) {
    const Mechanism& mechanism = story.lesson().mechanism;
    const State& state = *arrival.closed;
    const PlacedJoint j = placed(mechanism, joint, state);
    const Solid solid(style, state, j.joint->body_i, j.joint->body_j);
    const double length = kVisible * style.unit;
    JointStyle found;
    found.aside_i = solid.clearance(j.P_i, j.P_i + length * j.s_i, kAsideLimit * style.unit);
    found.aside_j = solid.clearance(j.P_j, j.P_j + length * j.s_j, kAsideLimit * style.unit);
    for (const auto& [from, direction] :
         {std::pair{j.P_i, j.h_i}, std::pair{j.P_j, j.h_j}, std::pair{j.P_i, j.u_i},
          std::pair{j.P_j, j.u_j}}) {
        found.side = std::max(found.side, solid.reach(from, direction, kSideLimit * style.unit));
    }
    const bool screw = j.joint->type->uses(kSidesU);
    found.lift_i = lift_of(solid, j.P_i, screw ? j.u_i : j.h_i, found.side, style.unit);
    found.lift_j = lift_of(solid, j.P_j, screw ? j.u_j : j.h_j, found.side, style.unit);
    const int theta = mechanism.theta_indices()[at(joint)];
    const auto reach = [&](const State& pose) {
        const PlacedJoint now = placed(mechanism, joint, pose);
        const double d = j.joint->type->has_curve() ? pose.theta[at(theta)] : now.displacement();
        found.lowest = std::min(found.lowest, d);
        found.highest = std::max(found.highest, d);
        found.farthest = std::max(found.farthest, (now.P_j - now.P_i - d * now.s_i).norm());
    };
    for (const Moment& moment : moments.closed) {
        const Step& step = story.steps()[at(moment.step)];
        if (step.additions < arrival.additions) { continue; }
        const bool moves = moment.moved.contains(j.joint->body_i) || moment.moved.contains(j.joint->body_j);
        if (moves || step.additions == arrival.additions) { reach(step.state); }
    }
    return found;
}

render::Bounds bounds_of(const Story& story, const PictureStyle& style, const std::vector<Moment>& moments) {
    render::Bounds bounds;
    for (const Moment& moment : moments) {
        const Step& step = story.steps()[at(moment.step)];
        bounds.include(render::bounds_of(compose(story, style, step, moment.step, moment.moved).scene));
    }
    return bounds;
}

void set_bounds(const Story& story, const Moments& moments, PictureStyle& style) {
    style.ground_axes = false;
    render::Bounds bounds = bounds_of(story, style, moments.closed);
    style.ground_axes = true;
    // the axes do not move: one moment is enough
    render::Bounds with_axes = bounds;
    with_axes.include(bounds_of(story, style, {moments.closed.front()}));
    style.ground_axes = with_axes.diagonal() < kFarOrigin * bounds.diagonal();
    if (style.ground_axes) { bounds = with_axes; }
    render::Bounds with_iterations = bounds_of(story, style, moments.iterations);
    with_iterations.include(bounds);
    style.bounds = with_iterations.diagonal() < kWildIteration * bounds.diagonal() ? with_iterations : bounds;
}

/// Chooses the traced point: the joint point or origin of a moving body with the longest path.
void set_traced_point(const Story& story, PictureStyle& style) {
    const Mechanism& mechanism = story.lesson().mechanism;
    double longest = 1e-3 * style.unit;  // less would be a dot
    const auto consider = [&](int body, const Vec3& s_local) {
        if (mechanism.bodies[at(body)].fixed) { return; }
        double length = 0.0;
        const Step* last = nullptr;
        for (const Step& step : story.steps()) {
            if (step.kind != Step::Kind::motion) { continue; }
            if (last != nullptr) {
                const Vec3 from = frame_of(last->state, body).point(s_local);
                length += (frame_of(step.state, body).point(s_local) - from).norm();
            }
            last = &step;
        }
        // the first of equally long paths, whatever the rounding
        if (length > 1.001 * longest) {
            longest = length;
            style.traced_body = body;
            style.traced_point_local = s_local;
        }
    };
    for (const Joint& joint : mechanism.joints) {
        consider(joint.body_i, joint.geometry.P_i_local);
        consider(joint.body_j, joint.geometry.P_j_local);
    }
    for (int b = 0; b < static_cast<int>(mechanism.bodies.size()); ++b) { consider(b, Vec3::Zero()); }
}

}  // namespace

PictureStyle picture_style(const Story& story) {
    const Mechanism& mechanism = story.lesson().mechanism;
    PictureStyle style;
    style.up = story.lesson().camera.up.value_or(Vec3::UnitZ()).normalized();
    style.view = view_direction(story, style.up);
    // sizes first: shapes that the lesson does not give are drawn in proportion to the mechanism itself
    style.unit = extent(mechanism);
    const Moments moments = moments_of(story, style.unit);
    set_shapes(story, style);
    style.unit = std::max(size_of_bodies(story, style, moments), 0.3 * style.unit);
    set_shapes(story, style);
    const std::vector<Arrival> arrivals = arrivals_in(story);
    for (int j = 0; j < static_cast<int>(mechanism.joints.size()); ++j) {
        style.joints.push_back(joint_style(story, style, j, arrivals[at(j)], moments));
        style.joints.back().wheels = wheel_style(mechanism, style, j, *arrivals[at(j)].closed);
    }
    set_traced_point(story, style);
    set_reaction_scales(story, style);
    set_bounds(story, moments, style);
    style.ground = render::ground_below(style.bounds, style.up);
    return style;
}

}  // namespace jw
