#include "app/session/picture.hpp"

#include <algorithm>

#include "app/session/picture_parts.hpp"

namespace jw {

namespace {

using namespace picture;

// bounds of the motion from so many moments: between them nothing goes far
constexpr int kBoundsMoments = 60;
constexpr double kTriad = 0.10;  // of the unit
constexpr double kGroundTriad = 0.14;
// the ground's axes are shown if they do not make the mechanism small
constexpr double kNearOrigin = 0.35;

/// Bodies and joints of a step, no vectors.
void add_mechanism(
    const Lesson& lesson, const PictureStyle& style, const Step& step, int subject_joint,
    render::Scene& scene) {
    for (int b = 0; b < static_cast<int>(lesson.mechanism.bodies.size()); ++b) {
        add_body(lesson, style, step.state, b, scene);
    }
    for (const int j : step.system->selection().joints) {
        const Joint& joint = lesson.mechanism.joints[static_cast<std::size_t>(j)];
        add_joint(lesson, style, placed(joint, step.state), j == subject_joint, scene);
    }
}

bool shows_ground_axes(const PictureStyle& style, const Vec3& origin) {
    const Vec3 nearest = origin.cwiseMax(style.bounds.lowest()).cwiseMin(style.bounds.highest());
    return (nearest - origin).norm() < kNearOrigin * style.unit;
}

void add_triads(
    const Lesson& lesson, const PictureStyle& style, const Step& step, const Joint* subject,
    Picture& picture) {
    for (int b = 0; b < static_cast<int>(lesson.mechanism.bodies.size()); ++b) {
        const BodyFrame frame = frame_of(step.state, b);
        if (b == 0 && !shows_ground_axes(style, frame.r)) { continue; }
        const bool of_subject = subject != nullptr && (subject->body_i == b || subject->body_j == b);
        render::Triad triad{{frame.A, frame.r}};
        triad.length = (b == 0 ? kGroundTriad : kTriad) * style.unit;
        triad.radius = 0.0028 * style.unit;
        triad.alpha = of_subject || b == 0 || subject == nullptr ? 1.0F : 0.45F;
        picture.scene.triads.push_back(triad);
    }
}

void add_names(const Lesson& lesson, const Step& step, Picture& picture) {
    for (int b = 0; b < static_cast<int>(lesson.mechanism.bodies.size()); ++b) {
        const auto k = static_cast<std::size_t>(b);
        if (lesson.mechanism.bodies[k].fixed && lesson.looks[k].shapes.empty()) { continue; }
        Annotation name;
        name.at = middle_of_body(lesson, step.state, b);
        name.text = lesson.mechanism.bodies[k].name;
        name.colour = render::palette::kInkSoft;
        name.body_name = true;
        picture.annotations.push_back(name);
    }
}

/// A point whose path tells the motion: of all joint points on moving bodies the one that goes farthest.
struct Tracer {
    int body = -1;
    Vec3 s_local = Vec3::Zero();
};

Tracer tracer_of(const Story& story) {
    const Mechanism& mechanism = story.lesson().mechanism;
    Tracer best;
    double longest = 0.0;
    const auto consider = [&](int body, const Vec3& s_local) {
        if (mechanism.bodies[static_cast<std::size_t>(body)].fixed) { return; }
        double length = 0.0;
        const Step* last = nullptr;
        for (const Step& step : story.steps()) {
            if (step.kind != Step::Kind::motion) { continue; }
            if (last != nullptr) {
                length +=
                    (frame_of(step.state, body).point(s_local) - frame_of(last->state, body).point(s_local))
                        .norm();
            }
            last = &step;
        }
        if (length > 1.001 * longest) {
            longest = length;
            best = {body, s_local};
        }
    };
    for (const Joint& joint : mechanism.joints) {
        consider(joint.body_i, joint.geometry.P_i_local);
        consider(joint.body_j, joint.geometry.P_j_local);
    }
    for (int b = 0; b < static_cast<int>(mechanism.bodies.size()); ++b) { consider(b, Vec3::Zero()); }
    return best;
}

void add_trace(const Story& story, int index, Picture& picture) {
    const Tracer tracer = tracer_of(story);
    if (tracer.body < 0) { return; }
    render::Polyline path{{}, 1.6, render::palette::kInkFaint};
    path.see_through = false;
    for (int k = 0; k <= index; ++k) {
        const Step& step = story.steps()[static_cast<std::size_t>(k)];
        if (step.kind == Step::Kind::motion) {
            path.points.push_back(frame_of(step.state, tracer.body).point(tracer.s_local));
        }
    }
    if (path.points.size() > 1) { picture.scene.polylines.push_back(std::move(path)); }
}

/// Steps whose poses bound all others.
std::vector<const Step*> bounding_steps(const Story& story) {
    std::vector<const Step*> all;
    std::vector<const Step*> motion;
    for (const Step& step : story.steps()) {
        (step.kind == Step::Kind::motion ? motion : all).push_back(&step);
    }
    const std::size_t stride = std::max<std::size_t>(1, motion.size() / kBoundsMoments);
    for (std::size_t k = 0; k < motion.size(); k += stride) { all.push_back(motion[k]); }
    return all;
}

render::Bounds bounds_of(const Story& story, const PictureStyle& style, bool with_joints) {
    render::Bounds bounds;
    for (const Step* step : bounding_steps(story)) {
        render::Scene scene;
        if (with_joints) {
            add_mechanism(story.lesson(), style, *step, -1, scene);
        } else {
            for (int b = 0; b < static_cast<int>(story.lesson().mechanism.bodies.size()); ++b) {
                add_body(story.lesson(), style, step->state, b, scene);
            }
        }
        bounds.include(render::bounds_of(scene));
    }
    return bounds;
}

}  // namespace

PictureStyle picture_style(const Story& story) {
    PictureStyle style;
    style.up = story.lesson().camera.up.value_or(Vec3::UnitZ()).normalized();
    // sizes first: what has none in the lesson is drawn in proportion to the mechanism itself
    style.unit = extent(story.lesson().mechanism);
    style.unit = std::max(bounds_of(story, style, false).diagonal(), 0.3 * style.unit);
    style.bounds = bounds_of(story, style, true);
    const Vec3& origin = story.lesson().mechanism.bodies.front().r;
    if (shows_ground_axes(style, origin)) { style.bounds.include(origin, kGroundTriad * style.unit); }
    style.ground = render::ground_below(style.bounds, style.up);
    return style;
}

Picture picture_of(const Story& story, const PictureStyle& style, int index) {
    const Lesson& lesson = story.lesson();
    const Step& step = story.steps()[static_cast<std::size_t>(index)];
    const std::optional<Addition> subject = subject_of(lesson, step);
    int joint = -1;
    if (subject && subject->kind == Addition::Kind::joint) { joint = subject->index; }
    if (step.kind == Step::Kind::motion) { joint = story.featured_joint(); }
    const Joint* subject_joint =
        joint >= 0 ? &lesson.mechanism.joints[static_cast<std::size_t>(joint)] : nullptr;

    Picture picture;
    add_mechanism(lesson, style, step, step.kind == Step::Kind::motion ? -1 : joint, picture.scene);
    add_triads(lesson, style, step, subject_joint, picture);
    if (subject_joint != nullptr) { add_vectors(style, placed(*subject_joint, step.state), picture); }
    if (subject && subject->kind == Addition::Kind::driver) {
        add_driver(lesson, style, step.state, subject->index, picture);
    }
    add_names(lesson, step, picture);
    if (step.kind == Step::Kind::motion) { add_trace(story, index, picture); }
    picture.scene.ground = style.ground;
    return picture;
}

}  // namespace jw
