#include "app/snapshot/taken.hpp"

#include "app/host/frames/environment.hpp"

namespace jw::snapshot {

namespace {

NaturalScale natural_scale(const Story& story) {
    const std::optional<MotionPlan> motion = shown_motion(story.lesson());
    NaturalScale scale;
    scale.length = picture_style(story).unit;
    if (motion && motion->to > motion->from) { scale.duration = motion->to - motion->from; }
    return scale;
}

}  // namespace

Camera::Camera(const Lesson& lesson, const SnapshotSize& size, const ShotChoice& choice, UnknownShots unknown)
    : story_(lesson),
      shots_(shots_of(story_, choice, unknown)),
      painter_(story_, size.width, size.height),
      environment_(host::environment(painter_.renderer())) {
    std::vector<std::vector<Fact>*> lists;
    facts_.reserve(shots_.size());
    for (const Shot& shot : shots_) { lists.push_back(&facts_.emplace_back(facts(shot))); }
    set_tolerances(lists, natural_scale(story_));
    painter_.wait_for_fonts();
}

std::vector<Fact> Camera::facts(const Shot& shot) const {
    const View shown = view(shot);
    std::vector<Fact> facts = facts_of(shown);
    const Lesson& lesson = story_.lesson();
    for (const std::vector<Fact>& more :
         {facts_of(lesson), facts_of(painter_.picture(shown), lesson.mechanism),
          facts_of(painter_.camera())}) {
        facts.insert(facts.end(), more.begin(), more.end());
    }
    return facts;
}

Snapshot Camera::take(const Shot& shot) {
    const View shown = view(shot);
    const Picture picture = painter_.picture(shown);
    Snapshot taken;
    taken.colour = painter_.paint(shown, picture);
    taken.layers = picture_of(painter_.layers(picture), story_.lesson().mechanism);
    taken.record.name = shot.name;
    taken.record.title = shown.title;
    taken.record.drawn_with = environment_;
    taken.record.things = taken.layers.things;
    taken.record.facts = facts_[static_cast<std::size_t>(&shot - shots_.data())];
    return taken;
}

render::Image Camera::colour_as(const Shot& shot, const StepNumber& number) {
    const View shown = view(shot);
    return painter_.paint_numbered(shown, painter_.picture(shown), number.step - 1, number.steps);
}

}  // namespace jw::snapshot
