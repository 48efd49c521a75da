#pragma once

#include <string>

#include "app/host/ui/ui.hpp"

/// Words on sheets over the 3D picture.
namespace jw::host {

/// Text at the foot of the picture: for a few seconds a message about what was done, or why it was not; and
/// the mistakes of a file until they are corrected.
class Notice {
public:
    /// Replaces the message, unless the new one is empty.
    void say(const std::string& message);
    /// Removes the message.
    void hush() { text_.clear(); }
    /// @return true if the message has disappeared
    bool advance(double seconds);
    /// Replaces the mistakes; empty: there are none any more.
    void blame(const std::string& mistakes) {
        mistakes_ = mistakes;
        are_of_file_ = true;
    }
    /// Shows why an address cannot be opened, in place of mistakes.
    void blame_address(const std::string& why);

    const std::string& text() const { return text_; }
    /// Time until the message disappears [s]; infinity if there is none.
    double seconds_left() const;
    const std::string& mistakes() const { return mistakes_; }

    /// Draws at the foot of `scene`, over the widgets.
    /// @param has_lesson  a lesson is open, which was read before the mistakes were made
    void draw(const Ui& ui, const panels::Box& scene, bool has_lesson) const;

private:
    std::string text_;
    double seconds_left_ = 0.0;
    std::string mistakes_;
    bool are_of_file_ = true;
};

/// Draws the badge that says that the pose is not that of the step.
/// @param foot  height at the foot of the picture that is covered by something else [px]
void draw_badge(const Ui& ui, const panels::Box& scene, float foot);
/// Height of the badge with its margins [px].
float badge_height(const Ui& ui);

/// Words that describe the computation of a story.
const char* words_of_waiting();

/// A sheet in the middle of `room`, with the progress of a long computation and a button to cancel it.
/// @return true if the button was pressed
bool waiting_sheet(const Ui& ui, const panels::Box& room, double part);

}  // namespace jw::host
