#pragma once

#include <functional>
#include <utility>

#include "app/host/ui/ui.hpp"
#include "render/scene/camera.hpp"
#include "render/scene/orbit.hpp"

/// Mouse and keys on the 3D picture: turn, move, zoom, point at objects and pull them.
namespace jw::host {

/// Number (see picture_id) of the object drawn nearest to a pixel; 0 for nothing.
using Picker = std::function<int(float x, float y)>;

class SceneInput {
public:
    const render::Camera& camera() const { return camera_; }
    /// True if the camera is the story's own: the user has not turned it.
    bool is_own() const { return own_; }
    /// The camera, or the one to which it is turning.
    const render::Camera& goal() const { return turned_ < 1.0 ? to_ : camera_; }
    /// Sets the camera at once, as if the user had turned it there.
    void look_through(const render::Camera& camera);

    /// Shows the story's own view, at once or by turning there.
    void show(const render::Camera& camera, bool at_once);
    /// Carries out commands of keys: standard views, turns by a small angle, zoom. Other commands do nothing.
    void carry_out(Command command, const render::Rect& viewport, const Session& session);

    /// Sets the picker. Without it, objects in 3D cannot be pointed at.
    void set_picker(Picker picker) { pick_ = std::move(picker); }
    /// Handles the mouse in one frame.
    /// @param reachable  nothing covers the picture, so its objects can be pointed at
    void handle(const LessonUi& ui, const render::Rect& viewport, bool reachable);
    /// Continues the turn of the camera. @return true while it turns
    bool advance(double seconds);
    /// True while the view turns, or the mouse drags the view or a body.
    bool is_busy() const { return turned_ < 1.0 || (mode_ != Mode::idle && moved_); }
    bool is_dragging() const { return mode_ == Mode::drag; }
    /// Lets go of everything, wherever the mouse is.
    void let_go() { mode_ = Mode::idle; }

private:
    enum class Mode { idle, orbit, pan, drag };

    void show(render::StandardView view);
    void put(const render::Camera& camera);
    void zoom(double factor, const render::Rect& viewport, double x, double y, const Session& session);
    void point_at(const LessonUi& ui);
    /// @param wanted  `drag` takes hold of a body, or turns the view if there is none
    void press(const LessonUi& ui, const render::Rect& viewport, Mode wanted);
    void move(const LessonUi& ui, const render::Rect& viewport);
    void release(const LessonUi& ui);
    void turn_to(const render::Camera& camera);

    Picker pick_;
    render::Camera camera_;
    render::Camera from_;
    render::Camera to_;
    double turned_ = 1.0;  ///< part of the way from `from_` to `to_`
    bool own_ = true;

    Mode mode_ = Mode::idle;
    float x_ = 0.0F;
    float y_ = 0.0F;
    bool moved_ = false;
    int body_ = -1;
    int joint_ = -1;  ///< under the pressed button: a click selects it
    Vec3 point_local_ = Vec3::Zero();
};

}  // namespace jw::host
