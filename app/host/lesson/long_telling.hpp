#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <vector>

#include "app/session/beside/background.hpp"
#include "app/session/story/story_telling.hpp"

/// Stories that take long to tell, told beside the pictures.
namespace jw::host {

/// Thrown by what needs a story that is still being told. It changes nothing, and is to be done again once
/// the story is there. Not an error: what handles those must let it pass.
struct NotToldYet {};

/// A lesson whose story is told beside the pictures, from a part that may have been told already.
class ToldBeside {
public:
    /// @param telling  of that lesson
    ToldBeside(std::shared_ptr<const Lesson> lesson, std::unique_ptr<StoryTelling> telling);

    /// Part of the story that is told, from 0 to 1.
    double progress() const { return *part_; }
    bool is_done() const { return work_->is_done(); }
    void wait() { work_->wait(); }
    /// @throws what the telling threw
    ToldLesson take() { return work_->take(); }
    /// Tells it to stop. @return the work, to be kept until it has
    std::unique_ptr<BackgroundWork> stop();

private:
    std::shared_ptr<std::atomic<double>> part_ = std::make_shared<std::atomic<double>>(0.0);
    std::unique_ptr<Background<ToldLesson>> work_;
};

/// The storyteller of a window: short stories at once, long ones beside the pictures. What has met NotToldYet
/// is done again, and asks for the same stories in the same order, but for those of what it need not do
/// again. Stories are known by the text of their lesson, and kept until nothing needs them.
class LongTelling {
public:
    /// As Storyteller. @throws NotToldYet if it takes long
    ToldLesson tell(const std::shared_ptr<const Lesson>& lesson, const StoryOptions& options);
    /// Begins an act that needs stories, for the first time or again.
    void begin() { asked_ = 0; }
    /// Drops all stories, which nothing needs any more, and stops the one under way.
    void forget();

    /// A story is told beside; only then the others may be asked for. Once `is_done`, what needs it can be
    /// done again.
    bool is_busy() const { return beside_ != nullptr; }
    bool is_done() const { return beside_->is_done(); }
    double progress() const { return beside_->progress(); }
    void wait() { beside_->wait(); }
    /// Number of stories that were begun beside the pictures, for tests.
    int told_beside() const { return told_beside_; }

private:
    ToldLesson keep(ToldLesson told);
    void stop();

    std::vector<ToldLesson> told_;  ///< in the order in which they were asked for
    std::size_t asked_ = 0;         ///< of them, since `begin`
    int told_beside_ = 0;
    std::unique_ptr<ToldBeside> beside_;
    std::vector<std::unique_ptr<BackgroundWork>> stopped_;  ///< not ended yet
};

}  // namespace jw::host
