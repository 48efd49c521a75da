#include "app/site/stations.hpp"

#include <algorithm>

#include "app/session/story/timeline.hpp"

namespace jw::site {

namespace {

// of a story with more stations, only those with a text of the author get a picture: forty would be too many
constexpr std::size_t kAllPictured = 12;
// most moments of a motion that a page shows
constexpr std::size_t kMostMoments = 6;

const Step& step_at_index(const Story& story, int index) {
    return story.steps()[static_cast<std::size_t>(index)];
}

Station station_of(const Story& story, const Stretch& stretch) {
    Station station;
    station.told = stretch.last;
    for (int k = stretch.first; k <= stretch.last; ++k) {
        const Step& step = step_at_index(story, k);
        if (step.kind == Step::Kind::equations) { station.equations = k; }
        if (!is_asked(step.kind)) { station.told = k; }
    }
    return station;
}

/// The moments at which a text of the author begins. If the first of them is later than the start of the
/// motion, also a moment in the middle of the time before it.
std::vector<Station> moments_of(const Story& story, const Stretch& stretch) {
    std::vector<int> moments;
    for (int k = stretch.first; k <= stretch.last; ++k) {
        if (step_at_index(story, k).kind == Step::Kind::motion) { moments.push_back(k); }
    }
    std::vector<Station> stations;
    if (moments.empty()) { return stations; }
    const auto add = [&](int step) {
        Station station;
        station.told = step;
        station.moves = true;
        stations.push_back(station);
    };
    for (const StepTexts::AtTime& text : story.lesson().step_texts.times) {
        const auto at =
            std::ranges::find_if(moments, [&](int k) { return step_at_index(story, k).t >= text.from; });
        if (at != moments.end() && stations.size() < kMostMoments) { add(*at); }
    }
    if (stations.empty() ||
        step_at_index(story, stations.front().told).t > step_at_index(story, moments.front()).t) {
        const int end = stations.empty() ? moments.back() : stations.front().told;
        add(moments.front() + (end - moments.front()) / 2);
        std::ranges::rotate(stations, stations.end() - 1);
    }
    return stations;
}

bool has_words(const Lesson& lesson, const Addition& added) {
    const auto k = static_cast<std::size_t>(added.index);
    const std::vector<Text>& texts =
        added.kind == Addition::Kind::joint ? lesson.step_texts.joints : lesson.step_texts.drivers;
    return k < texts.size() && !texts[k].empty();
}

}  // namespace

std::vector<Station> stations_of(const Story& story) {
    std::vector<Station> stations;
    for (const Stretch& stretch : stretches_of(story)) {
        if (stretch.kind == Step::Kind::motion) {
            const std::vector<Station> moments = moments_of(story, stretch);
            stations.insert(stations.end(), moments.begin(), moments.end());
        } else {
            stations.push_back(station_of(story, stretch));
        }
    }
    for (Station& station : stations) {
        station.id = "step-" + std::to_string(station.told + 1);
        const std::optional<Addition> subject =
            subject_of(story.lesson(), step_at_index(story, station.told));
        station.pictured = stations.size() <= kAllPictured || station.moves || !subject ||
                           has_words(story.lesson(), *subject) || step_at_index(story, station.told).failed();
    }
    return stations;
}

}  // namespace jw::site
