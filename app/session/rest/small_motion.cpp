#include "app/session/rest/small_motion.hpp"

#include "core/equations/assembler.hpp"
#include "core/kinematics/manifold.hpp"

namespace jw {

std::optional<State> pose_in_mode(const RestView& view, std::size_t mode, std::complex<double> z) {
    const Mode& m = view.outcome.motions.modes[mode];
    const Centroidal& scene = *view.instant.scene;
    System system(scene.mechanism, everything(scene.mechanism));
    const Layout<OmegaLocal> layout(system);
    State pose = view.outcome.state;
    const VectorX shape = layout.columns_of(pose, m.shape);
    const VectorX late = layout.columns_of(pose, m.shape_late);
    layout.advance(pose, z.real() * shape - z.imag() * late);
    if (!project(system, pose, 0.0)) { return std::nullopt; }
    return scene.as_given(pose);
}

Picture picture_at_rest(
    const Story& story, const PictureStyle& style, const RestView& view, const std::optional<State>& moved) {
    const Lesson& lesson = story.lesson();
    // like a moment of the motion: no joint is its subject
    Step step = story.steps().front();
    step.kind = Step::Kind::motion;
    step.additions = static_cast<int>(lesson.order.size());
    step.system = std::make_shared<System>(lesson.mechanism, selection_of(lesson, step.additions));
    step.t = 0.0;
    step.state = moved.value_or(view.instant.state);
    step.velocity = view.instant.velocity;
    step.centroidal = moved ? nullptr : view.instant.scene;
    step.centroidal_acceleration = view.instant.velocity;  // zero, too
    Picture picture = picture_of(story, style, step, 0);
    for (render::Shape& shape : picture.scene.shapes) { shape.id = 0; }
    for (render::Arrow& arrow : picture.scene.arrows) { arrow.id = 0; }
    for (Annotation& name : picture.annotations) { name.link = {}; }
    return picture;
}

}  // namespace jw
