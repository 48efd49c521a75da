#pragma once

#include <functional>
#include <utility>

#include "app/host/ui/ui.hpp"
#include "render/camera.hpp"
#include "render/orbit.hpp"

/// Mouse and keys on the 3D picture: turn, move, zoom, point at things and pull them.
namespace jw::host {

/// Number (see picture_id) of what is drawn nearest to a pixel; 0 for nothing.
using Picker = std::function<int(float x, float y)>;

class SceneHand {
public:
    const render::Camera& camera() const { return camera_; }
    /// True until the person turns the camera: it is the story's own.
    bool is_own() const { return own_; }
    /// The camera, or where it is turning to.
    const render::Camera& goal() const { return turned_ < 1.0 ? to_ : camera_; }
    /// At once, as if the person had turned it there.
    void look_through(const render::Camera& camera);

    /// The story's own view; at once, or turning there.
    void show(const render::Camera& camera, bool at_once);
    /// The commands of keys: a standard view, parts of a turn and of the distance. Others do nothing.
    void carry_out(Command command, const render::Rect& viewport, const Session& session);

    /// Without it nothing in 3D can be pointed at.
    void set_picker(Picker picker) { pick_ = std::move(picker); }
    /// Handles the mouse in one frame.
    /// @param reachable  nothing lies over the picture: what is drawn there can be pointed at
    void handle(const LessonUi& ui, const render::Rect& viewport, bool reachable);
    /// Lets a turning camera go on. @return true while it turns
    bool advance(double seconds);
    /// The view turns, or something is held.
    bool is_busy() const { return turned_ < 1.0 || (mode_ != Mode::idle && moved_); }
    bool is_dragging() const { return mode_ == Mode::drag; }
    /// Holds nothing any more, wherever the mouse is.
    void let_go() { mode_ = Mode::idle; }

private:
    enum class Mode { idle, orbit, pan, drag };

    void show(render::StandardView view);
    void turn(double dx, double dy);
    void zoom(double factor, const render::Rect& viewport, double x, double y, const Session& session);
    void point_at(const LessonUi& ui);
    /// @param wanted  `drag` takes hold of a body, and turns the view where there is none
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
    int joint_ = -1;  ///< pressed upon: a click chooses it
    Vec3 point_local_ = Vec3::Zero();
};

}  // namespace jw::host
