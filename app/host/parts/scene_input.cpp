#include "app/host/parts/scene_input.hpp"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "app/session/picture/picture_parts.hpp"

namespace jw::host {

namespace {

constexpr double kTurnPerPixel = 0.006;
constexpr double kCloserPerNotch = 1.15;
constexpr double kTurnPerKey = 0.15;  // [rad]
constexpr double kCloserPerKey = 1.2;
constexpr double kTurnSeconds = 0.3;

/// The moving body that a drawn object belongs to; -1 if there is none or it is fixed.
int body_of(const Session& session, const Pointable& link) {
    const Mechanism& mechanism = session.lesson().mechanism;
    const auto moves = [&](int body) { return !mechanism.bodies[static_cast<std::size_t>(body)].fixed; };
    if (link.kind == Pointable::Kind::body) { return moves(link.index) ? link.index : -1; }
    if (link.kind != Pointable::Kind::joint && link.kind != Pointable::Kind::vector) { return -1; }
    const Joint& joint = mechanism.joints[static_cast<std::size_t>(link.index)];
    if (moves(joint.body_j)) { return joint.body_j; }
    return moves(joint.body_i) ? joint.body_i : -1;
}

}  // namespace

void SceneInput::show(const render::Camera& camera, bool at_once) {
    own_ = true;
    if (at_once) {
        camera_ = to_ = camera;
        turned_ = 1.0;
    } else {
        turn_to(camera);
    }
}

void SceneInput::look_through(const render::Camera& camera) {
    show(camera, true);
    own_ = false;
}

void SceneInput::show(render::StandardView view) {
    turn_to(render::standard_view(goal(), view));
    own_ = false;
}

void SceneInput::turn_to(const render::Camera& camera) {
    from_ = camera_;
    to_ = camera;
    turned_ = 0.0;
}

bool SceneInput::advance(double seconds) {
    if (turned_ >= 1.0) { return false; }
    turned_ = std::min(1.0, turned_ + seconds / kTurnSeconds);
    camera_ = render::blended(from_, to_, turned_ * turned_ * (3.0 - 2.0 * turned_));
    return true;
}

/// Shows the view that the user has chosen.
void SceneInput::put(const render::Camera& camera) {
    camera_ = camera;
    turned_ = 1.0;
    own_ = false;
}

void SceneInput::zoom(
    double factor, const render::Rect& viewport, double x, double y, const Session& session) {
    const double size = std::max(1e-9, session.style().bounds.diagonal());
    put(render::zoomed(camera_, viewport, factor, x, y, size));
}

void SceneInput::carry_out(Command command, const render::Rect& viewport, const Session& session) {
    // the commands have the order of the views
    static_assert(static_cast<int>(Command::view_free) - static_cast<int>(Command::view_front) == 6);
    if (command >= Command::view_front && command <= Command::view_free) {
        const int view = static_cast<int>(command) - static_cast<int>(Command::view_front);
        return show(static_cast<render::StandardView>(view));
    }
    const double x = viewport.x + 0.5 * viewport.width;
    const double y = viewport.y + 0.5 * viewport.height;
    switch (command) {
        case Command::turn_left: return put(render::orbited(camera_, -kTurnPerKey, 0.0));
        case Command::turn_right: return put(render::orbited(camera_, kTurnPerKey, 0.0));
        case Command::turn_up: return put(render::orbited(camera_, 0.0, -kTurnPerKey));
        case Command::turn_down: return put(render::orbited(camera_, 0.0, kTurnPerKey));
        case Command::zoom_in: return zoom(kCloserPerKey, viewport, x, y, session);
        case Command::zoom_out: return zoom(1.0 / kCloserPerKey, viewport, x, y, session);
        default: return;
    }
}

void SceneInput::handle(const LessonUi& ui, const render::Rect& viewport, bool reachable) {
    const ImGuiIO& io = ImGui::GetIO();
    const auto x = static_cast<double>(io.MousePos.x);
    const auto y = static_cast<double>(io.MousePos.y);
    const bool over = viewport.contains(x, y) && !io.WantCaptureMouse;
    if (over && reachable && mode_ == Mode::idle) { point_at(ui); }
    // two fingers can pan and zoom at the same time
    if (over && (mode_ == Mode::idle || mode_ == Mode::pan) && io.MouseWheel != 0.0F) {
        const double factor = std::pow(kCloserPerNotch, static_cast<double>(io.MouseWheel));
        zoom(factor, viewport, x, y, ui.session);
    }
    if (mode_ == Mode::idle) {
        if (!over) { return; }
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
            press(ui, viewport, io.KeyShift ? Mode::pan : Mode::drag);
        }
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Right) || ImGui::IsMouseClicked(ImGuiMouseButton_Middle)) {
            press(ui, viewport, Mode::pan);
        }
        if (ImGui::IsMouseClicked(kTurningButton)) { press(ui, viewport, Mode::orbit); }
        return;
    }
    const std::size_t bodies = ui.session.lesson().mechanism.bodies.size();
    if (mode_ == Mode::drag && static_cast<std::size_t>(body_) >= bodies) {
        // the lesson was read again or replaced, and does not have the held body any more
        mode_ = Mode::idle;
        body_ = joint_ = -1;
        return;
    }
    const bool held = io.MouseDown[0] || io.MouseDown[1] || io.MouseDown[2] || io.MouseDown[kTurningButton];
    if (!held) { return release(ui); }
    move(ui, viewport);
}

void SceneInput::point_at(const LessonUi& ui) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (ui.state.pointed_at || !pick_) { return; }
    ui.state.pointed_at = pointable_of(pick_(mouse.x, mouse.y));
}

void SceneInput::press(const LessonUi& ui, const render::Rect& viewport, Mode wanted) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    x_ = mouse.x;
    y_ = mouse.y;
    moved_ = false;
    const Pointable link = ui.state.pointed_at;
    const bool takes_hold = wanted == Mode::drag;
    joint_ = takes_hold && link.kind == Pointable::Kind::joint ? link.index : -1;
    body_ = takes_hold ? body_of(ui.session, link) : -1;
    mode_ = takes_hold && body_ < 0 ? Mode::orbit : wanted;
    if (body_ < 0) { return; }
    const State& state = ui.session.step().state;
    const Vec3 middle = picture::middle_of_body(ui.session.style(), state, body_);
    const Vec3 held =
        render::point_at_depth(camera_, viewport, static_cast<double>(x_), static_cast<double>(y_), middle);
    const picture::BodyFrame frame = picture::frame_of(state, body_);
    point_local_ = frame.A.transpose() * (held - frame.r);
}

void SceneInput::move(const LessonUi& ui, const render::Rect& viewport) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (!ImGui::IsMousePosValid(&mouse)) { return; }
    const float dx = mouse.x - x_;
    const float dy = mouse.y - y_;
    if (!moved_ && std::hypot(dx, dy) < kLongestClick) { return; }
    moved_ = true;
    if (dx == 0.0F && dy == 0.0F) { return; }
    x_ = mouse.x;
    y_ = mouse.y;
    if (mode_ == Mode::drag) {
        const Vec3 held = picture::frame_of(ui.session.step().state, body_).point(point_local_);
        const Vec3 target = render::point_at_depth(
            camera_, viewport, static_cast<double>(mouse.x), static_cast<double>(mouse.y), held);
        ui.state.playback.pause();
        ui.requests.add(Drag{body_, point_local_, target});
        return;
    }
    const auto right = static_cast<double>(dx);
    const auto down = static_cast<double>(dy);
    put(mode_ == Mode::orbit ? render::orbited(camera_, kTurnPerPixel * right, kTurnPerPixel * down)
                             : render::panned(camera_, viewport, right, down));
}

void SceneInput::release(const LessonUi& ui) {
    if (!moved_ && joint_ >= 0 && ui.session.step().kind == Step::Kind::motion) {
        ui.requests.show_joint = joint_;
    }
    joint_ = -1;
    if (mode_ == Mode::drag && moved_) { ui.requests.add(Release{}); }
    mode_ = Mode::idle;
    body_ = -1;
}

}  // namespace jw::host
