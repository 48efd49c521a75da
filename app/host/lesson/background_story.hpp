#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <vector>

#include "app/session/background/background.hpp"
#include "app/session/story/story_telling.hpp"

/// Long stories, computed in the background while pictures are drawn.
namespace jw::host {

/// Thrown by an action that needs a story that is still being computed. The action changes nothing, and is
/// done again when the story is complete. This is not an error: handlers of errors must let it pass.
struct NotToldYet {};

/// Computes the rest of a story in the background.
/// @param part  is set to the fraction of the story that has been computed, from 0 to 1
std::unique_ptr<Background<ToldLesson>> told_in_background(
    std::shared_ptr<const Lesson> lesson, std::unique_ptr<StoryTelling> telling,
    std::shared_ptr<std::atomic<double>> part = std::make_shared<std::atomic<double>>(0.0));

/// The storyteller of a window: it computes short stories at once, and long ones in the background. An action
/// that threw NotToldYet is done again, and must then ask for the same stories in the same order, except for
/// the parts that are done already. Stories are identified by the text of their lesson, and kept until
/// nothing needs them.
class BackgroundStories {
public:
    /// As Storyteller. @throws NotToldYet if it takes long
    ToldLesson tell(const std::shared_ptr<const Lesson>& lesson, const StoryOptions& options);
    /// Begins an action that needs stories, for the first time or again.
    void begin() { asked_ = 0; }
    /// Discards all stories, and stops a running computation. Call it when nothing needs them any more.
    void forget();

    /// True while a story is computed in the background; call the next two functions only then. Once the
    /// story `is_done`, the action that needs it can be done again.
    bool is_busy() const { return background_ != nullptr; }
    bool is_done() const { return background_->is_done(); }
    void wait() { background_->wait(); }
    /// Fraction of the story that has been computed, from 0 to 1; 1 if none is computed in the background.
    double progress() const { return is_busy() ? part_->load() : 1.0; }
    /// Number of stories that were begun in the background, for tests.
    int begun_in_background() const { return begun_in_background_; }

private:
    void stop();

    std::vector<ToldLesson> told_;  ///< in the order in which they were asked for
    std::size_t asked_ = 0;         ///< number of them asked for since `begin`
    int begun_in_background_ = 0;
    std::unique_ptr<Background<ToldLesson>> background_;
    std::shared_ptr<std::atomic<double>> part_;             ///< of the story in the background
    std::vector<std::unique_ptr<BackgroundWork>> stopped_;  ///< not ended yet
};

}  // namespace jw::host
