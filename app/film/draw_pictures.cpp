#include "app/film/draw_pictures.hpp"

#include <optional>

#include "app/host/frames/frame_files.hpp"

namespace jw::film {

namespace {

/// Paints pictures of a film. The view of a step is computed once for all its pictures.
class FilmPainter {
public:
    explicit FilmPainter(const DrawnLesson& lesson)
        : story_(lesson.story), painter_(*lesson.story, lesson.width, lesson.height, lesson.look) {}

    render::Image paint(const FilmPicture& picture) {
        if (!view_ || view_->step != picture.step) { view_ = view_of(*story_, picture.step); }
        if (picture.share >= 1.0) { return painter_.paint(*view_); }
        const auto k = at(picture.step);
        Step step = story_->steps()[k];
        step.state = pose_between(story_->steps()[k - 1].state, step.state, picture.share);
        return painter_.paint(*view_, painter_.picture(*view_, step));
    }

private:
    const Story* story_;
    host::FramePainter painter_;
    std::optional<View> view_;
};

}  // namespace

void draw_missing(
    const DrawnLesson& lesson, std::span<const NumberedPicture> pictures, const host::FrameDraft& draft,
    const std::function<void(std::size_t there)>& progress) {
    std::optional<FilmPainter> painter;  // takes a third of a second: only if a picture is missing
    host::PictureWriter writer(draft.folder());
    std::size_t there = 0;
    for (const NumberedPicture& numbered : pictures) {
        if (!draft.has(numbered.number)) {
            if (!painter) { painter.emplace(lesson); }
            writer.add(numbered.number, painter->paint(numbered.picture));
        }
        progress(++there);
    }
    writer.wait();
}

std::span<const NumberedPicture> part_of(std::span<const NumberedPicture> all, int part, int parts) {
    const auto border = [&](int k) {
        return all.size() * static_cast<std::size_t>(k) / static_cast<std::size_t>(parts);
    };
    return all.subspan(border(part), border(part + 1) - border(part));
}

}  // namespace jw::film
