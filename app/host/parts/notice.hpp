#pragma once

#include <string>

#include "app/host/ui/ui.hpp"

/// Words on sheets over the 3D picture.
namespace jw::host {

/// What was done or why it was not, to be read for a while.
class Notice {
public:
    /// In place of what was said before, unless there is nothing to say.
    void say(const std::string& message);
    /// @return true if it went out
    bool advance(double seconds);

    const std::string& text() const { return text_; }
    /// Until it goes out; infinity where nothing is said.
    double seconds_left() const;

private:
    std::string text_;
    double seconds_left_ = 0.0;
};

/// That the pose is not one of the lesson.
void draw_badge(const Ui& ui, const panels::Box& scene);

/// A notice at the foot of the picture, and above it the mistakes of the file; over the widgets.
void draw_notices(
    const Ui& ui, const panels::Box& scene, const std::string& notice, const std::string& mistakes);

}  // namespace jw::host
