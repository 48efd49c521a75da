#include "app/session/picture/picture.hpp"

#include <algorithm>

#include "app/session/answers/question_view.hpp"
#include "app/session/picture/picture_parts.hpp"
#include "app/session/wording/labels.hpp"

namespace jw {

namespace picture {

namespace {

constexpr double kTriad = 0.10;  // of the unit
constexpr double kGroundTriad = 0.14;
constexpr double kTriadRadius = 0.0028;
constexpr double kSameFrame = 0.02;
constexpr float kFaint = 0.4F;
constexpr float kGhost = 0.2F;
constexpr double kMoved = 0.01;    // of the unit: smaller motions are not visible
constexpr double kOneName = 0.06;  // of the unit: equal names closer than this mean the same thing

int bodies_count(const Lesson& lesson) { return static_cast<int>(lesson.mechanism.bodies.size()); }

/// Joints that a step is about: the joint that is added or asked about, or along which the added driver acts;
/// during the motion the featured joints. Empty if there are none.
std::vector<int> subject_joints(const Story& story, const Step& step) {
    if (step.kind == Step::Kind::motion) { return featured_joints(story); }
    const std::optional<Addition> subject = subject_of(story.lesson(), step);
    if (const int asked = joint_asked_about(story.lesson(), step); asked >= 0) { return {asked}; }
    if (!subject) { return {}; }
    if (subject->kind == Addition::Kind::joint) { return {subject->index}; }
    const int along = story.lesson().mechanism.drivers[at(subject->index)].joint;
    return along < 0 ? std::vector<int>{} : std::vector<int>{along};
}

bool is_among(const std::vector<int>& joints, int joint) {
    return std::ranges::find(joints, joint) != joints.end();
}

/// The joint whose equation could not be closed, -1 if there is none.
int failing_joint(const Step& step) {
    if (!step.failure) { return -1; }
    const Constraint* const c = constraint_of(*step.system, step.failure->row);
    return c == nullptr ? -1 : c->joint;
}

/// Sets the ids of all entries from `first` on to that of `link`.
template <class Drawn>
void name_from(std::vector<Drawn>& drawn, std::size_t first, const Pointable& link) {
    for (std::size_t k = first; k < drawn.size(); ++k) { drawn[k].id = picture_id(link); }
}

void add_mechanism(
    const Lesson& lesson, const PictureStyle& style, const Step& step, const std::vector<int>& highlighted,
    const BodyChoice& bodies, render::Scene& scene) {
    for (int b = 0; b < bodies_count(lesson); ++b) {
        if (!bodies.contains(b)) { continue; }
        const std::size_t first = scene.shapes.size();
        add_body(lesson, style, step.state, b, 1.0F, scene);
        name_from(scene.shapes, first, Pointable::body(b));
    }
    for (const int j : step.system->selection().joints) {
        const Joint& joint = lesson.mechanism.joints[at(j)];
        const bool stands = !bodies.contains(joint.body_i) && !bodies.contains(joint.body_j);
        if (stands && !is_among(highlighted, j)) { continue; }
        const std::size_t first = scene.shapes.size();
        add_joint(lesson, style, placed(lesson.mechanism, j, step.state), is_among(highlighted, j), scene);
        name_from(scene.shapes, first, Pointable::joint(j));
    }
}

/// The part of a joint's vectors that a colour stands for (palette.hpp), -1 for none.
int part_of(const render::Colour& colour) {
    if (colour == render::palette::kVectorI) { return Pointable::kVectorI; }
    if (colour == render::palette::kVectorJ) { return Pointable::kVectorJ; }
    return colour == render::palette::kVectorD ? Pointable::kVectorD : -1;
}

/// Adds the vectors of a joint and their names, linked to these vectors.
void add_named_vectors(
    const Lesson& lesson, const PictureStyle& style, const State& state, int joint, Picture& picture) {
    const std::size_t first_arrow = picture.scene.arrows.size();
    const std::size_t first_name = picture.annotations.size();
    add_vectors(style, placed(lesson.mechanism, joint, state), picture);
    for (std::size_t k = first_arrow; k < picture.scene.arrows.size(); ++k) {
        render::Arrow& arrow = picture.scene.arrows[k];
        if (const int part = part_of(arrow.colour); part >= 0) {
            arrow.id = picture_id(Pointable::vector(joint, part));
        }
    }
    for (std::size_t k = first_name; k < picture.annotations.size(); ++k) {
        Annotation& annotation = picture.annotations[k];
        if (const int part = part_of(annotation.colour); part >= 0) {
            annotation.link = Pointable::vector(joint, part);
        }
    }
}

void add_triads(
    const Lesson& lesson, const PictureStyle& style, const Step& step, const std::vector<int>& joints,
    const BodyChoice& bodies, render::Scene& scene) {
    const auto joins = [&](int joint, int body) {
        const Joint& subject = lesson.mechanism.joints[at(joint)];
        return subject.body_i == body || subject.body_j == body;
    };
    const BodyFrame ground = frame_of(step.state, 0);
    for (int b = 0; b < bodies_count(lesson); ++b) {
        if (!bodies.contains(b)) { continue; }
        const BodyFrame frame = frame_of(step.state, b);
        // axes on axes would look like arrows with two heads
        const bool on_ground = b > 0 && style.ground_axes && (frame.A - ground.A).norm() < kSameFrame &&
                               (frame.r - ground.r).norm() < kSameFrame * style.unit;
        if (on_ground || (b == 0 && !style.ground_axes)) { continue; }
        const bool of_subject = std::ranges::any_of(joints, [&](int joint) { return joins(joint, b); });
        render::Triad triad{{frame.A, frame.r}};
        triad.length = (b == 0 ? kGroundTriad : kTriad) * style.unit;
        triad.radius = kTriadRadius * style.unit;
        triad.alpha = of_subject || b == 0 || step.kind == Step::Kind::bodies ? 1.0F : kFaint;
        scene.triads.push_back(triad);
    }
}

void add_names(
    const Lesson& lesson, const PictureStyle& style, const Step& step, const BodyChoice& bodies,
    Picture& picture) {
    for (int b = 0; b < bodies_count(lesson); ++b) {
        if (!bodies.contains(b)) { continue; }
        const auto k = at(b);
        if (lesson.mechanism.bodies[k].fixed && lesson.looks[k].shapes.empty()) { continue; }
        Annotation name;
        name.at = middle_of_body(style, step.state, b);
        name.text = lesson.mechanism.bodies[k].name;
        name.colour = render::palette::kInkSoft;
        name.body_name = true;
        name.link = Pointable::body(b);
        picture.annotations.push_back(name);
    }
}

/// Adds pale copies of the bodies where they were before this solve.
void add_ghosts(
    const Story& story, const PictureStyle& style, int index, const BodyChoice& bodies,
    render::Scene& scene) {
    int start = index;
    while (start > 0 && story.steps()[at(start)].kind != Step::Kind::equations) { --start; }
    const State& before = story.steps()[at(start)].state;
    const State& now = story.steps()[at(index)].state;
    for (int b = 0; b < bodies_count(story.lesson()); ++b) {
        if (!bodies.contains(b)) { continue; }
        const BodyFrame from = frame_of(before, b);
        const BodyFrame to = frame_of(now, b);
        // a turn is visible as the motion of a point about a quarter of the unit away
        const double moved = (to.r - from.r).norm() + 0.25 * style.unit * (to.A - from.A).norm();
        if (moved > kMoved * style.unit) { add_body(story.lesson(), style, before, b, kGhost, scene); }
    }
}

/// The path of the traced point up to now.
void add_path(const Story& story, const PictureStyle& style, int index, render::Scene& scene) {
    if (style.traced_body < 0) { return; }
    render::Polyline path{{}, 1.6, render::palette::kInkFaint};
    path.see_through = false;
    const auto add = [&](const Step& step) {
        path.points.push_back(frame_of(step.state, style.traced_body).point(style.traced_point_local));
    };
    if (story.curve().empty()) {
        for (int k = 0; k <= index; ++k) {
            const Step& step = story.steps()[at(k)];
            if (step.kind == Step::Kind::motion) { add(step); }
        }
    } else {
        const double now = story.steps()[at(index)].t;
        for (const Step& moment : story.curve()) {
            if (moment.t <= now) { add(moment); }
        }
    }
    if (path.points.size() > 1) { scene.polylines.push_back(std::move(path)); }
}

}  // namespace

Picture compose(
    const Story& story, const PictureStyle& style, const Step& step, int index, const BodyChoice& bodies) {
    const Lesson& lesson = story.lesson();
    const bool moves = step.kind == Step::Kind::motion;
    const std::vector<int> joints = subject_joints(story, step);
    const std::optional<Addition> subject = subject_of(lesson, step);
    const bool about_driver = subject && subject->kind == Addition::Kind::driver;

    Picture picture;
    add_mechanism(lesson, style, step, moves ? std::vector<int>{} : joints, bodies, picture.scene);
    if (step.kind == Step::Kind::iteration) { add_ghosts(story, style, index, bodies, picture.scene); }
    add_triads(lesson, style, step, joints, bodies, picture.scene);
    if (about_driver) {
        add_driver(lesson, style, step.state, subject->index, picture);
    } else {
        for (const int joint : joints) { add_named_vectors(lesson, style, step.state, joint, picture); }
        // a vector that two joints share and that is fixed in the same body has one name
        leave_out_repeated(picture.annotations, [&](const Annotation& first, const Annotation& name) {
            return name.text == first.text && name.link.kind == Pointable::Kind::vector &&
                   (name.at - first.at).norm() < kOneName * style.unit;
        });
    }
    if (const int failing = failing_joint(step); failing >= 0 && !is_among(joints, failing)) {
        add_gap(style, placed(lesson.mechanism, failing, step.state), picture);
    }
    // between bodies that are still apart, springs would only hide other things
    if (step.additions == static_cast<int>(lesson.order.size())) {
        add_springs(lesson, style, step.state, picture.scene);
    }
    if (const auto reactions = reactions_of(step)) { add_reactions(style, *reactions, picture); }
    add_names(lesson, style, step, bodies, picture);
    return picture;
}

}  // namespace picture

void add_ghosts(
    const Lesson& lesson, const PictureStyle& style, std::span<const State> poses, Picture& picture) {
    constexpr float palest = 0.10F;
    constexpr float strongest = 0.30F;
    for (std::size_t k = 0; k < poses.size(); ++k) {
        const float part = static_cast<float>(k + 1) / static_cast<float>(poses.size());
        for (int b = 0; b < static_cast<int>(lesson.mechanism.bodies.size()); ++b) {
            if (lesson.mechanism.bodies[at(b)].fixed) { continue; }
            picture::add_body(
                lesson, style, poses[k], b, palest + part * (strongest - palest), picture.scene);
        }
    }
}

void light_up(Picture& picture, const Emphasis& lit) {
    if (lit.empty()) { return; }
    for (render::Shape& shape : picture.scene.shapes) {
        shape.highlighted = shape.highlighted || lit.contains(pointable_of(shape.id));
    }
    for (render::Arrow& arrow : picture.scene.arrows) {
        arrow.highlighted = arrow.highlighted || lit.contains(pointable_of(arrow.id));
    }
}

Picture picture_of(const Story& story, const PictureStyle& style, int index) {
    return picture_of(story, style, story.steps()[at(index)], index);
}

Picture picture_of(const Story& story, const PictureStyle& style, const Step& step, int index) {
    Picture picture = picture::compose(story, style, step, index);
    if (step.kind == Step::Kind::motion) { picture::add_path(story, style, index, picture.scene); }
    picture.scene.ground = style.ground;
    return picture;
}

}  // namespace jw
