#include "app/export/moving_scene.hpp"

#include "app/session/picture/picture_parts.hpp"
#include "core/jets/euler_parameters.hpp"
#include "render/passes/instances.hpp"

namespace jw {

namespace {

std::array<float, 3> floats(const Vec3& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

/// Unit p in the order of glTF: the scalar comes last.
std::array<float, 4> rotation_of(const Vec4& p) {
    return {
        static_cast<float>(p[1]), static_cast<float>(p[2]), static_cast<float>(p[3]),
        static_cast<float>(p[0])};
}

gltf::Pose pose_of(const State& state, int body) {
    const auto b = at(body);
    return {floats(state.r[b]), rotation_of(state.p[b].normalized())};
}

/// Steps of the motion; without a motion, the step at which the mechanism is assembled.
std::vector<int> moments_of(const Story& story) {
    std::vector<int> moments;
    for (int k = 0; k < static_cast<int>(story.steps().size()); ++k) {
        if (story.steps()[at(k)].kind == Step::Kind::motion) { moments.push_back(k); }
    }
    if (moments.empty()) { moments.push_back(story.last_assembled()); }
    return moments;
}

/// Appends a copy of `shape`, placed as the vertex shader places it (render/scene/shapes.hpp).
void append(gltf::Mesh& mesh, const render::Mesh& shape, const render::Instance& instance) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const render::MeshVertex& vertex : shape.vertices) {
        const Eigen::Vector3f inner{instance.size.w(), instance.size.w(), instance.size.z()};
        const Eigen::Vector3f scale =
            (1.0F - vertex.core.w()) * instance.size.head<3>() + vertex.core.w() * inner;
        const Eigen::Vector3f local =
            vertex.core.head<3>().cwiseProduct(scale) + vertex.normal * instance.rounding;
        const Eigen::Vector3f at = instance.pose.leftCols<3>() * local + instance.pose.col(3);
        const Eigen::Vector3f normal = (instance.pose.leftCols<3>() * vertex.normal).normalized();
        mesh.positions.push_back({at.x(), at.y(), at.z()});
        mesh.normals.push_back({normal.x(), normal.y(), normal.z()});
    }
    for (const std::uint16_t index : shape.indices) { mesh.indices.push_back(first + index); }
}

gltf::Mesh mesh_of(const RigidPart& part) {
    render::Scene alone;
    alone.shapes.push_back(part.shape);
    const render::DrawLists lists = render::draw_lists_of(alone, 1.0);
    gltf::Mesh mesh;
    mesh.colour = {part.shape.colour.r, part.shape.colour.g, part.shape.colour.b, 1.0F};
    for (const render::InstanceLists* const list : {&lists.bodies, &lists.see_through}) {
        for (std::size_t number = 0; number < render::kMeshes; ++number) {
            if ((*list)[number].empty()) { continue; }
            const render::Mesh shape = render::make_mesh(number);
            for (const render::Instance& instance : (*list)[number]) { append(mesh, shape, instance); }
        }
    }
    return mesh;
}

gltf::Pose turned_to_y(const Vec3& up) {
    gltf::Pose pose;
    pose.rotation = rotation_of(euler_parameters_between(up, Vec3::UnitY()));
    return pose;
}

/// Time at which a moment of the motion is shown [s].
float time_of(const MotionPlan& plan, double t) {
    return static_cast<float>(plan.duration * (t - plan.from) / (plan.to - plan.from));
}

}  // namespace

gltf::Scene moving_scene_of(const Story& story) {
    const Lesson& lesson = story.lesson();
    const std::vector<Body>& bodies = lesson.mechanism.bodies;
    const PictureStyle style = picture_style(story);
    const std::vector<int> moments = moments_of(story);
    const auto state_at = [&](int step) -> const State& { return story.steps()[at(step)].state; };
    gltf::Scene scene;
    scene.name = lesson.title;
    scene.nodes.push_back({lesson.title, {}, -1, turned_to_y(style.up), {}});
    const std::optional<MotionPlan> plan = shown_motion(lesson);
    const bool moves = plan && moments.size() > 1;
    if (moves) {
        for (const int k : moments) { scene.times.push_back(time_of(*plan, story.steps()[at(k)].t)); }
    }
    for (int b = 0; b < static_cast<int>(bodies.size()); ++b) {
        gltf::Node node{bodies[at(b)].name, {}, -1, pose_of(state_at(moments.front()), b), {}};
        if (moves && !bodies[at(b)].fixed) {
            for (const int k : moments) { node.motion.push_back(pose_of(state_at(k), b)); }
        }
        scene.nodes.front().children.push_back(static_cast<int>(scene.nodes.size()));
        scene.nodes.push_back(std::move(node));
    }
    for (const RigidPart& part : rigid_parts_of(story, style, moments)) {
        gltf::Node node;
        node.name = part.name;
        node.mesh = static_cast<int>(scene.meshes.size());
        scene.meshes.push_back(mesh_of(part));
        scene.nodes[1 + static_cast<std::size_t>(part.body)].children.push_back(
            static_cast<int>(scene.nodes.size()));
        scene.nodes.push_back(std::move(node));
    }
    return scene;
}

}  // namespace jw
