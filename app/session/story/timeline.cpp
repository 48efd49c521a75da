#include "app/session/story/timeline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include "core/numerics/decimal.hpp"

namespace jw {

namespace {

/// The stretch that a step is part of. A question belongs to what it asks about, not to the steps before it.
struct Part {
    bool moves = false;
    int additions = 0;

    bool operator==(const Part&) const = default;
};

Part part_of(const Story& story, const Step& step) {
    Part part{step.kind == Step::Kind::motion, step.additions};
    if (!is_asked(step.kind)) { return part; }
    const Question& question = question_of(story.lesson(), step);
    part.moves = question.place == Question::Place::motion;
    if (step.kind == Step::Kind::question && question.place == Question::Place::addition) {
        ++part.additions;
    }
    return part;
}

std::string name_of(const Part& part, const Lesson& lesson) {
    if (part.moves) { return "motion"; }
    if (part.additions == 0) { return "bodies"; }
    return name_of(lesson.order[at(part.additions - 1)], lesson.mechanism);
}

/// The moment of the motion nearest to time `t`; nothing if nothing moves.
std::optional<int> moment_near(const Story& story, double t) {
    std::optional<int> nearest;
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < story.steps().size(); ++k) {
        const Step& step = story.steps()[k];
        if (step.kind != Step::Kind::motion || std::abs(step.t - t) >= distance) { continue; }
        distance = std::abs(step.t - t);
        nearest = static_cast<int>(k);
    }
    return nearest;
}

}  // namespace

std::vector<Stretch> stretches_of(const Story& story) {
    std::vector<Stretch> stretches;
    for (std::size_t k = 0; k < story.steps().size(); ++k) {
        const Step& step = story.steps()[k];
        const auto index = static_cast<int>(k);
        const Part part = part_of(story, step);
        const bool same = k > 0 && part_of(story, story.steps()[k - 1]) == part;
        if (same) {
            stretches.back().last = index;
        } else {
            const Step::Kind kind = part.moves ? Step::Kind::motion : step.kind;
            stretches.push_back({index, index, name_of(part, story.lesson()), kind});
        }
    }
    return stretches;
}

int last_step(const Story& story) { return static_cast<int>(story.steps().size()) - 1; }

std::optional<int> first_moment(const Story& story) {
    const auto found = std::ranges::find(story.steps(), Step::Kind::motion, &Step::kind);
    return found == story.steps().end() ? std::nullopt
                                        : std::optional<int>(static_cast<int>(found - story.steps().begin()));
}

int next_joint(const Story& story, int step, int direction) {
    int target = direction > 0 ? last_step(story) : 0;
    for (const Stretch& s : stretches_of(story)) {
        if (direction > 0 && s.first > step) { return s.first; }
        if (direction < 0 && s.first < step) { target = s.first; }
    }
    return target;
}

std::optional<int> step_at(const Story& story, const std::string& place) {
    const int last = last_step(story);
    double number = 0.0;
    const bool is_time = place.starts_with("t=");
    const char* const begin = place.data() + (is_time ? 2 : 0);
    const char* const end = place.data() + place.size();
    const auto [stop, error] = read_decimal(begin, end, number);
    if (error == std::errc() && stop == end && std::isfinite(number)) {
        if (!is_time) {
            const double index = number - 1.0;
            const bool fits = index >= 0.0 && index <= last && index == std::floor(index);
            return fits ? std::optional<int>(static_cast<int>(index)) : std::nullopt;
        }
        return moment_near(story, number);
    }
    for (const Stretch& stretch : stretches_of(story)) {
        if (stretch.name != place) { continue; }
        // at the joint or driver itself, not at the questions before it
        int step = stretch.first;
        while (step < stretch.last && story.steps()[at(step)].kind == Step::Kind::question) { ++step; }
        return step;
    }
    return std::nullopt;
}

StoryPlace place_of(const Story& story, int index) {
    const Step& step = story.steps()[at(index)];
    StoryPlace place{step.kind, subject_of(story.lesson(), step), 0, step.question, step.t};
    for (int k = index - 1; k >= 0; --k) {
        if (subject_of(story.lesson(), story.steps()[at(k)]) != place.subject) { break; }
        ++place.nth;
    }
    return place;
}

int nearest_moment(const Story& story, double t) { return moment_near(story, t).value_or(last_step(story)); }

int find_place(const Story& story, const StoryPlace& place) {
    const auto size = static_cast<int>(story.steps().size());
    if (place.kind == Step::Kind::motion) { return nearest_moment(story, place.t); }
    if (place.kind == Step::Kind::bodies) { return 0; }
    for (int k = 0; is_asked(place.kind) && k < size; ++k) {
        const Step& step = story.steps()[at(k)];
        if (step.kind == place.kind && step.question == place.question) { return k; }
    }
    int nth = 0;
    int last = -1;
    for (int k = 0; k < size; ++k) {
        const Step& step = story.steps()[at(k)];
        if (subject_of(story.lesson(), step) != place.subject) { continue; }
        last = k;
        const bool same = nth++ == place.nth && step.kind == place.kind;
        const bool done = step.kind == place.kind && place.kind != Step::Kind::iteration;
        if (same || done) { return k; }
    }
    return last >= 0 ? last : std::min(size - 1, story.last_assembled());
}

}  // namespace jw
