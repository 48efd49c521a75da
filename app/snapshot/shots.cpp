#include "app/snapshot/shots.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "app/session/encoding/base64.hpp"
#include "lessons/diagnostics/diagnostics.hpp"

namespace jw::snapshot {

namespace {

constexpr std::size_t kLongest = 120;  // bytes: file systems allow 255, and endings are added

std::string file_name(std::string text) {
    std::ranges::replace(text, ' ', '_');
    const std::string name = percent_encoded(text, "-_.");
    return (name.starts_with('.') ? "%2E" + name.substr(1) : name).substr(0, kLongest);
}

std::string subject_of_shot(const Lesson& lesson, const Step& step) {
    const std::optional<Addition> subject = subject_of(lesson, step);
    if (!subject) { return {}; }
    const auto k = static_cast<std::size_t>(subject->index);
    return subject->kind == Addition::Kind::joint ? lesson.mechanism.joints[k].name
                                                  : "driver " + lesson.mechanism.drivers[k].name;
}

std::string name_of_shot(const Lesson& lesson, const Step& step) {
    switch (step.kind) {
        case Step::Kind::bodies: return "bodies";
        case Step::Kind::equations: return subject_of_shot(lesson, step) + "-equations";
        case Step::Kind::assembled: return subject_of_shot(lesson, step);
        case Step::Kind::failed: return subject_of_shot(lesson, step) + "-failed";
        case Step::Kind::answer: return "answer-" + std::to_string(step.question + 1);
        case Step::Kind::motion: return "motion-" + short_number(step.t, 9);
        case Step::Kind::question: return "question-" + std::to_string(step.question + 1);
        case Step::Kind::iteration: return subject_of_shot(lesson, step) + "-iteration";
    }
    return {};
}

/// Every step with its name.
std::vector<Shot> all_shots(const Story& story) {
    std::vector<Shot> shots;
    std::set<std::string> names;
    for (int k = 0; k < static_cast<int>(story.steps().size()); ++k) {
        const std::string plain =
            file_name(name_of_shot(story.lesson(), story.steps()[static_cast<std::size_t>(k)]));
        std::string name = plain;
        for (int n = 2; !names.insert(name).second; ++n) { name = plain + "-" + std::to_string(n); }
        shots.push_back({name, k});
    }
    return shots;
}

/// Adds the moments at which timed texts of the author begin to be shown.
void add_told_moments(const Story& story, const std::vector<int>& motion, std::set<int>& chosen) {
    for (const StepTexts::AtTime& told : story.lesson().step_texts.times) {
        const auto first = std::ranges::find_if(
            motion, [&](int k) { return story.steps()[static_cast<std::size_t>(k)].t >= told.from; });
        if (first != motion.end()) { chosen.insert(*first); }
    }
}

/// Steps of the motion at equal distances, including the first and the last, and the steps at which the
/// author tells something.
std::set<int> moments_of(const Story& story, int moments) {
    std::vector<int> motion;
    for (int k = 0; k < static_cast<int>(story.steps().size()); ++k) {
        if (story.steps()[static_cast<std::size_t>(k)].kind == Step::Kind::motion) { motion.push_back(k); }
    }
    std::set<int> chosen;
    const auto last = static_cast<double>(motion.size()) - 1.0;
    for (int k = 0; k < moments && !motion.empty(); ++k) {
        const double part = moments == 1 ? 0.0 : static_cast<double>(k) / (moments - 1);
        chosen.insert(motion[static_cast<std::size_t>(std::lround(part * last))]);
    }
    if (moments > 0) { add_told_moments(story, motion, chosen); }
    return chosen;
}

void refuse_unknown(const std::vector<Shot>& all, const std::vector<std::string>& only) {
    std::vector<std::string> names;
    for (const Shot& shot : all) { names.push_back(shot.name); }
    for (const std::string& name : only) {
        if (std::ranges::find(names, name) != names.end()) { continue; }
        const std::string hint = did_you_mean(name, names);
        throw std::runtime_error(
            "the lesson has no step " + in_quotes(name) + "; expected one of " + comma_list(names) +
            (hint.empty() ? "" : " (" + hint + ")"));
    }
}

}  // namespace

std::vector<Shot> shots_of(const Story& story, const ShotChoice& choice, UnknownShots unknown) {
    std::vector<Shot> shots = all_shots(story);
    if (!choice.only.empty()) {
        if (unknown == UnknownShots::refused) { refuse_unknown(shots, choice.only); }
        std::erase_if(shots, [&](const Shot& shot) {
            return std::ranges::find(choice.only, shot.name) == choice.only.end();
        });
        return shots;
    }
    const std::set<int> moments = moments_of(story, choice.moments);
    std::erase_if(shots, [&](const Shot& shot) {
        const Step::Kind kind = story.steps()[static_cast<std::size_t>(shot.step)].kind;
        const bool other_moment = kind == Step::Kind::motion && !moments.contains(shot.step);
        return other_moment || kind == Step::Kind::iteration || kind == Step::Kind::question;
    });
    return shots;
}

}  // namespace jw::snapshot
