#include <algorithm>
#include <utility>

#include "app/session/picture/picture_camera.hpp"
#include "app/session/picture/picture_parts.hpp"
#include "app/session/picture/picture_shapes.hpp"

namespace jw {

namespace {

using namespace picture;

// bounds of the motion from so many moments: between them nothing goes far
constexpr std::size_t kMomentsSeen = 250;
// a Newton iteration that throws bodies away farther than this would make everything else small
constexpr double kWildIteration = 1.6;
// the ground's axes are shown if they do not make the mechanism small either
constexpr double kFarOrigin = 1.35;
constexpr double kVisible = 0.2;  // of the unit: length of a vector that should be in sight
constexpr double kAsideLimit = 0.08;
constexpr double kSideLimit = 0.14;

/// Indices of the steps whose poses bound all others.
std::vector<int> moments_of(const Story& story) {
    std::vector<int> chosen;
    std::vector<int> motion;
    for (int k = 0; k < static_cast<int>(story.steps().size()); ++k) {
        const bool moves = story.steps()[static_cast<std::size_t>(k)].kind == Step::Kind::motion;
        (moves ? motion : chosen).push_back(k);
    }
    const std::size_t stride = 1 + motion.size() / kMomentsSeen;
    for (std::size_t k = 0; k < motion.size(); k += stride) { chosen.push_back(motion[k]); }
    if (!motion.empty()) { chosen.push_back(motion.back()); }
    return chosen;
}

void set_shapes(const Story& story, PictureStyle& style) {
    style.bodies.clear();
    for (int b = 0; b < static_cast<int>(story.lesson().mechanism.bodies.size()); ++b) {
        style.bodies.push_back(local_shapes(story.lesson(), b, style.unit, style.up));
    }
}

/// Size of the bodies over the story, wherever iterations throw them in between.
double size_of_bodies(const Story& story, const PictureStyle& style, const std::vector<int>& moments) {
    render::Bounds bounds;
    const Step* before = nullptr;
    for (const int k : moments) {
        const Step& step = story.steps()[static_cast<std::size_t>(k)];
        if (step.kind == Step::Kind::iteration) { continue; }
        // most steps of a large lesson add a joint and leave everything where it is
        if (before != nullptr && step.state.r == before->state.r && step.state.p == before->state.p) {
            continue;
        }
        before = &step;
        render::Scene scene;
        for (int b = 0; b < static_cast<int>(style.bodies.size()); ++b) {
            add_body(story.lesson(), style, step.state, b, 1.0F, scene);
        }
        bounds.include(render::bounds_of(scene));
    }
    return bounds.diagonal();
}

/// A pose at which the joint is closed, as it is looked at most; the last of the story if it never is.
const State& closed_state(const Story& story, int joint) {
    for (const Step& step : story.steps()) {
        const std::vector<int>& joints = step.system->selection().joints;
        if (step.kind == Step::Kind::assembled && std::ranges::find(joints, joint) != joints.end()) {
            return step.state;
        }
    }
    return story.steps().back().state;
}

/// Lift of a vector that leaves the bodies at `side` from P and may run in a handle from there on.
double lift_of(const Solid& solid, const Vec3& P, const Vec3& direction, double side, double unit) {
    const Vec3 from = P + side * direction;
    return solid.clearance(from, from + 0.5 * kVisible * unit * direction, kAsideLimit * unit);
}

JointStyle joint_style(
    const Story& story, const PictureStyle& style, int joint, const std::vector<int>& moments) {
    const Mechanism& mechanism = story.lesson().mechanism;
    const State& state = closed_state(story, joint);
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
    for (const int k : moments) {
        const Step& step = story.steps()[static_cast<std::size_t>(k)];
        const std::vector<int>& present = step.system->selection().joints;
        if (step.kind == Step::Kind::iteration) { continue; }
        if (std::ranges::find(present, joint) == present.end()) { continue; }
        const PlacedJoint now = placed(mechanism, joint, step.state);
        const double d = now.displacement();
        found.lowest = std::min(found.lowest, d);
        found.highest = std::max(found.highest, d);
        found.farthest = std::max(found.farthest, (now.P_j - now.P_i - d * now.s_i).norm());
    }
    return found;
}

render::Bounds bounds_of(
    const Story& story, const PictureStyle& style, const std::vector<int>& moments, bool iterations) {
    render::Bounds bounds;
    render::Bounds before;
    for (const int k : moments) {
        if ((story.steps()[static_cast<std::size_t>(k)].kind == Step::Kind::iteration) != iterations) {
            continue;
        }
        render::Bounds now =
            render::bounds_of(compose(story, style, story.steps()[static_cast<std::size_t>(k)], k).scene);
        bounds.include(now, before);
        before = std::move(now);
    }
    return bounds;
}

void set_bounds(const Story& story, const std::vector<int>& moments, PictureStyle& style) {
    style.ground_axes = false;
    render::Bounds bounds = bounds_of(story, style, moments, false);
    style.ground_axes = true;
    // these stay where they are: one moment is as good as all
    const auto first = std::ranges::find_if(moments, [&](int k) {
        return story.steps()[static_cast<std::size_t>(k)].kind != Step::Kind::iteration;
    });
    render::Bounds with_axes = bounds;
    if (first != moments.end()) { with_axes.include(bounds_of(story, style, {*first}, false)); }
    style.ground_axes = with_axes.diagonal() < kFarOrigin * bounds.diagonal();
    if (style.ground_axes) { bounds = with_axes; }
    render::Bounds with_iterations = bounds_of(story, style, moments, true);
    with_iterations.include(bounds);
    style.bounds = with_iterations.diagonal() < kWildIteration * bounds.diagonal() ? with_iterations : bounds;
}

/// Chooses the traced point: the joint point or origin of a moving body with the longest path.
void set_traced_point(const Story& story, PictureStyle& style) {
    const Mechanism& mechanism = story.lesson().mechanism;
    double longest = 1e-3 * style.unit;  // less would be a dot
    const auto consider = [&](int body, const Vec3& s_local) {
        if (mechanism.bodies[static_cast<std::size_t>(body)].fixed) { return; }
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
        // the first of equally long ones, whatever the rounding
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
    const std::vector<int> moments = moments_of(story);
    PictureStyle style;
    style.up = story.lesson().camera.up.value_or(Vec3::UnitZ()).normalized();
    style.view = view_direction(story, style.up);
    // sizes first: what has none in the lesson is drawn in proportion to the mechanism itself
    style.unit = extent(mechanism);
    set_shapes(story, style);
    style.unit = std::max(size_of_bodies(story, style, moments), 0.3 * style.unit);
    set_shapes(story, style);
    for (int j = 0; j < static_cast<int>(mechanism.joints.size()); ++j) {
        style.joints.push_back(joint_style(story, style, j, moments));
    }
    set_traced_point(story, style);
    set_reaction_scales(story, style);
    set_bounds(story, moments, style);
    style.ground = render::ground_below(style.bounds, style.up);
    return style;
}

}  // namespace jw
