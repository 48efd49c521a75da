#include "app/host/lesson/background_story.hpp"

#include <stdexcept>
#include <utility>

#include "lessons/write/writer.hpp"

namespace jw::host {

namespace {

// work of a story (see StoryTelling) before it continues in the background: 10 to 60 ms for the lessons here,
// two or three times as long in a web page; most stories end earlier. A count, not a time, so that the
// behaviour of a lesson does not depend on the load of the machine
constexpr double kMostAtOnce = 25'000.0;

/// True if two lessons are the same, perhaps in two copies.
bool are_same(const Lesson& a, const Lesson& b) {
    if (&a == &b) { return true; }
    try {
        return a.file_name == b.file_name && lesson_text(a) == lesson_text(b);
    } catch (const std::invalid_argument&) {
        // a lesson made by a program, which no file can describe: rely on the order of requests
        return true;
    }
}

}  // namespace

std::unique_ptr<Background<ToldLesson>> told_in_background(
    std::shared_ptr<const Lesson> lesson, std::unique_ptr<StoryTelling> telling,
    std::shared_ptr<std::atomic<double>> part) {
    const auto piece = [lesson = std::move(lesson), told = std::shared_ptr<StoryTelling>(std::move(telling)),
                        part = std::move(part)](const std::stop_token&) -> std::optional<ToldLesson> {
        const bool goes_on = told->go_on();
        *part = told->progress();
        if (goes_on) { return std::nullopt; }
        return ToldLesson{lesson, told->story()};
    };
    return std::make_unique<Background<ToldLesson>>(piece);
}

ToldLesson BackgroundStories::tell(const std::shared_ptr<const Lesson>& lesson, const StoryOptions& options) {
    if (background_ && background_->is_done()) {
        told_.push_back(std::exchange(background_, nullptr)->take());
    }
    while (asked_ < told_.size()) {
        if (are_same(*lesson, *told_[asked_].lesson)) { return told_[asked_++]; }
        told_.erase(told_.begin() + static_cast<std::ptrdiff_t>(asked_));
    }
    stop();
    auto telling = std::make_unique<StoryTelling>(*lesson, options);
    while (telling->work() < kMostAtOnce) {
        if (telling->go_on()) { continue; }
        told_.push_back({lesson, telling->story()});
        return told_[asked_++];
    }
    ++begun_in_background_;
    part_ = std::make_shared<std::atomic<double>>(0.0);
    background_ = told_in_background(lesson, std::move(telling), part_);
    throw NotToldYet();
}

void BackgroundStories::stop() {
    std::erase_if(stopped_, [](const auto& work) { return work->is_done(); });
    if (!background_) { return; }
    background_->stop();
    stopped_.push_back(std::move(background_));
}

void BackgroundStories::forget() {
    stop();
    told_.clear();
    asked_ = 0;
}

}  // namespace jw::host
