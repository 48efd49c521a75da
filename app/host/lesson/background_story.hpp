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

/// A lesson whose story is computed in the background; a part may have been computed before.
class BackgroundStory {
public:
    /// @param telling  of that lesson
    BackgroundStory(std::shared_ptr<const Lesson> lesson, std::unique_ptr<StoryTelling> telling);

    /// Fraction of the story that has been computed, from 0 to 1.
    double progress() const { return *part_; }
    bool is_done() const { return work_->is_done(); }
    void wait() { work_->wait(); }
    /// @throws the exception that the computation threw
    ToldLesson take() { return work_->take(); }
    /// Asks the computation to stop. @return the work, to be kept until it has stopped
    std::unique_ptr<BackgroundWork> stop();

private:
    std::shared_ptr<std::atomic<double>> part_ = std::make_shared<std::atomic<double>>(0.0);
    std::unique_ptr<Background<ToldLesson>> work_;
};

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

    /// True while a story is computed in the background; call the next three functions only then. Once the
    /// story `is_done`, the action that needs it can be done again.
    bool is_busy() const { return background_ != nullptr; }
    bool is_done() const { return background_->is_done(); }
    double progress() const { return background_->progress(); }
    void wait() { background_->wait(); }
    /// Number of stories that were begun in the background, for tests.
    int begun_in_background() const { return begun_in_background_; }

private:
    ToldLesson keep(ToldLesson told);
    void stop();

    std::vector<ToldLesson> told_;  ///< in the order in which they were asked for
    std::size_t asked_ = 0;         ///< number of them asked for since `begin`
    int begun_in_background_ = 0;
    std::unique_ptr<BackgroundStory> background_;
    std::vector<std::unique_ptr<BackgroundWork>> stopped_;  ///< not ended yet
};

}  // namespace jw::host
