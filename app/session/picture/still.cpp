#include "app/session/picture/still.hpp"

#include <algorithm>
#include <iterator>

#include "app/session/picture/picture.hpp"
#include "app/session/picture/picture_parts.hpp"
#include "app/session/story/dynamics_run.hpp"
#include "app/session/wording/labels.hpp"

namespace jw {

namespace {

// if two joints are nearer than this, in the picture's unit, their vectors would hide each other
constexpr double kApartWithVectors = 0.25;
// share of ink in the colour of a name; the rest is the colour of the body or axis
constexpr float kInkOfBodyNames = 0.6F;
constexpr float kInkOfAxisNames = 0.3F;

/// The lesson's scene at rest: nothing is added, asked or moved. Everything must be visible, so only the
/// direction of the author's camera is kept.
Lesson still_of(const Lesson& lesson, bool as_given) {
    Lesson still = lesson;
    still.order.clear();
    still.questions.clear();
    still.camera.target.reset();
    still.camera.distance.reset();
    if (as_given) { return still; }
    const Story story(lesson, last_pose_only());
    if (story.failure() == nullptr) {
        still.mechanism = placed_at(lesson.mechanism, story.steps().back().state);
    }
    return still;
}

/// Sets how far the guides and planes of the joints must reach at this pose, assembled or not.
void fit_joints(const Mechanism& mechanism, const State& state, PictureStyle& style) {
    for (int j = 0; j < static_cast<int>(mechanism.joints.size()); ++j) {
        const picture::PlacedJoint joint = picture::placed(mechanism, j, state);
        const double d = joint.displacement();
        JointStyle& range = style.joints[at(j)];
        range.lowest = std::min(0.0, d);
        range.highest = std::max(0.0, d);
        range.farthest = (joint.P_j - joint.P_i - d * joint.s_i).norm();
    }
}

/// A step with all joints, none of them its subject: their vectors are added by `still_picture`.
Step whole_step(const Story& story) {
    Step step = story.steps().front();
    const bool few = story.lesson().mechanism.joints.size() <= 2;
    step.kind = few ? Step::Kind::bodies : Step::Kind::assembled;  // axes of bodies: strong or faint
    step.system = std::make_shared<System>(story.lesson().mechanism, everything(story.lesson().mechanism));
    return step;
}

/// Place of a joint's name: where its points meet; on body j if it slides; in the middle of a link.
Vec3 place_of(const picture::PlacedJoint& joint) {
    const JointType& type = *joint.joint->type;
    const bool between =
        type.uses(Role::same_point) || type.uses(Role::length) || type.glyph == JointGlyph::none;
    return between ? Vec3(0.5 * (joint.P_i + joint.P_j)) : joint.P_j;
}

Annotation name_of(const picture::PlacedJoint& joint) {
    Annotation name{place_of(joint), Vec3::Zero(), joint.joint->name, render::palette::kInk, true};
    name.link = Pointable::joint(joint.index);
    return name;
}

/// Adds dashes between points of a joint that are apart, or that only the joint's name would connect.
void add_connection(const PictureStyle& style, const picture::PlacedJoint& joint, render::Scene& scene) {
    const JointType& type = *joint.joint->type;
    if (type.glyph == JointGlyph::none && !picture::contains(*joint.joint, kD, {FormulaVector::d})) {
        scene.polylines.push_back({{joint.P_i, joint.P_j}, 2.5, render::palette::kInkFaint, true});
    }
    if (!type.uses(Role::same_point)) { return; }
    Picture gap;
    picture::add_gap(style, joint, gap);
    std::ranges::move(gap.scene.polylines, std::back_inserter(scene.polylines));
}

/// Adds names at the ends of the ground's axes, except at those that are seen end-on.
void add_axis_names(const PictureStyle& style, const render::Scene& scene, std::vector<Annotation>& names) {
    constexpr double end_on = 0.3;  // sine of the angle to the view
    if (!style.ground_axes || scene.triads.empty()) { return; }
    const render::Triad& ground = scene.triads.front();
    for (int k = 0; k < 3; ++k) {
        const Vec3 axis = ground.pose.A.col(k);
        if (axis.cross(style.view.normalized()).norm() < end_on) { continue; }
        names.push_back(
            {ground.pose.r + ground.length * axis, axis, axis_name(k),
             render::mix(render::palette::kAxes[at(k)], render::palette::kInk, kInkOfAxisNames), true});
    }
}

/// Adds the names in the order in which they find their places: vectors and points, joints, axes, and then
/// bodies, which have much room around them.
void add_all_names(
    const Lesson& lesson, const PictureStyle& style, const std::vector<picture::PlacedJoint>& joints,
    std::vector<Annotation> bodies, Picture& picture) {
    std::vector<Annotation>& names = picture.annotations;
    for (const picture::PlacedJoint& joint : joints) { names.push_back(name_of(joint)); }
    add_axis_names(style, picture.scene, names);
    for (Annotation& body : bodies) {
        const render::Colour own = picture::colour_of_body(lesson, body.link.index);
        body.colour = render::mix(own, render::palette::kInk, kInkOfBodyNames);
        names.push_back(std::move(body));
    }
    // joints may share points and axes
    constexpr double same_place = 0.03;  // of the unit
    picture::leave_out_repeated(names, [&](const Annotation& first, const Annotation& name) {
        return first.text == name.text && first.body_name == name.body_name &&
               (first.at - name.at).norm() < same_place * style.unit;
    });
}

/// Joints whose vectors are shown: one, or two far apart; otherwise those that consist of vectors alone.
std::vector<int> joints_with_vectors(
    const Story& story, const PictureStyle& style, const std::vector<picture::PlacedJoint>& joints) {
    if (joints.size() == 1) { return {0}; }
    const bool two = joints.size() == 2;
    const bool apart =
        two && (place_of(joints[0]) - place_of(joints[1])).norm() > kApartWithVectors * style.unit;
    return apart ? std::vector<int>{0, 1} : featured_joints(story);
}

Picture still_picture(const Story& story, const PictureStyle& style) {
    const Lesson& lesson = story.lesson();
    const Step step = whole_step(story);
    Picture picture = picture::compose(story, style, step, 0);
    std::vector<Annotation> bodies = std::move(picture.annotations);
    picture.annotations.clear();
    std::vector<picture::PlacedJoint> joints;
    for (int j = 0; j < static_cast<int>(lesson.mechanism.joints.size()); ++j) {
        joints.push_back(picture::placed(lesson.mechanism, j, step.state));
        add_connection(style, joints.back(), picture.scene);
    }
    for (const int j : joints_with_vectors(story, style, joints)) {
        picture::add_vectors(style, joints[at(j)], picture);
    }
    add_all_names(lesson, style, joints, std::move(bodies), picture);
    return picture;
}

}  // namespace

Still::Still(const Lesson& lesson, bool as_given) {
    lesson_ = std::make_unique<const Lesson>(still_of(lesson, as_given));
    story_ = std::make_unique<const Story>(*lesson_, poses_only());
    style_ = picture_style(*story_);
    fit_joints(story_->lesson().mechanism, story_->steps().front().state, style_);
    picture_ = still_picture(*story_, style_);
    style_.bounds = render::bounds_of(picture_.scene);
    picture_.scene.ground = render::ground_below(style_.bounds, style_.up);
}

render::Camera Still::camera(const render::Rect& viewport, const render::Rect& safe) const {
    return camera_of(*story_, style_, viewport, safe);
}

}  // namespace jw
