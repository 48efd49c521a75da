#include "app/session/try/place.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace jw {

Place place_of(const Story& story, int index) {
    const Step& step = story.steps()[static_cast<std::size_t>(index)];
    Place place{step.kind, subject_of(story.lesson(), step), 0, step.question, step.t};
    for (int k = index - 1; k >= 0; --k) {
        if (subject_of(story.lesson(), story.steps()[static_cast<std::size_t>(k)]) != place.subject) {
            break;
        }
        ++place.nth;
    }
    return place;
}

int nearest_moment(const Story& story, double t) {
    int nearest = static_cast<int>(story.steps().size()) - 1;
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < story.steps().size(); ++k) {
        const Step& step = story.steps()[k];
        if (step.kind != Step::Kind::motion || std::abs(step.t - t) >= distance) { continue; }
        distance = std::abs(step.t - t);
        nearest = static_cast<int>(k);
    }
    return nearest;
}

int find_place(const Story& story, const Place& place) {
    const auto size = static_cast<int>(story.steps().size());
    if (place.kind == Step::Kind::motion) { return nearest_moment(story, place.t); }
    if (place.kind == Step::Kind::bodies) { return 0; }
    for (int k = 0; is_asked(place.kind) && k < size; ++k) {
        const Step& step = story.steps()[static_cast<std::size_t>(k)];
        if (step.kind == place.kind && step.question == place.question) { return k; }
    }
    int nth = 0;
    int last = -1;
    for (int k = 0; k < size; ++k) {
        const Step& step = story.steps()[static_cast<std::size_t>(k)];
        if (subject_of(story.lesson(), step) != place.subject) { continue; }
        last = k;
        const bool same = nth++ == place.nth && step.kind == place.kind;
        const bool done = step.kind == place.kind && place.kind != Step::Kind::iteration;
        if (same || done) { return k; }
    }
    return last >= 0 ? last : std::min(size - 1, story.last_assembled());
}

}  // namespace jw
