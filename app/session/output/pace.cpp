#include "app/session/output/pace.hpp"

#include <algorithm>

#include "app/session/wording/text_width.hpp"
#include "lessons/math/text_parts.hpp"

namespace jw {

namespace {

// pace of an attentive reader in a lecture, formulas beside the text
constexpr double kSecondsToLook = 1.5;
constexpr double kSecondsPerCharacter = 0.05;

}  // namespace

double seconds_to_look(const View& view, double moment) {
    if (view.kind == Step::Kind::motion) { return moment; }
    if (view.kind == Step::Kind::iteration) { return kSecondsToLook; }
    const int characters =
        displayed_width(view.sentence) + displayed_width(math::plain_words(view.author_text));
    return kSecondsToLook + kSecondsPerCharacter * characters;
}

double seconds_of_step(const Story& story, const View& view) {
    const auto moments = std::ranges::count(story.steps(), Step::Kind::motion, &Step::kind);
    const std::optional<MotionPlan> motion = shown_motion(story.lesson());
    const double duration = motion ? motion->duration : 0.0;
    return seconds_to_look(view, moments > 1 ? duration / static_cast<double>(moments - 1) : duration);
}

}  // namespace jw
