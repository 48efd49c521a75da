#include <array>
#include <sstream>

#include "app/session/try/carry_out.hpp"
#include "app/session/try/experiment_text.hpp"
#include "lessons/read/reader.hpp"
#include "lessons/write/writer.hpp"
#include "tests/fuzz/targets.hpp"

namespace jw::fuzz {

namespace {

// joints of every kind of vector, a driver, loops, a screw, directions that are not perpendicular
constexpr std::array kScenes{
    "lessons/exercises/scenes/four-bar.toml", "lessons/exercises/scenes/slider-crank.toml",
    "lessons/exercises/scenes/clinic-jack.toml", "lessons/exercises/scenes/wire-and-disc.toml"};
// they are carried out one after the other
constexpr int kMostExperiments = 4;

const Lesson& scene(std::size_t which) {
    static const std::array lessons = [] {
        std::array<Lesson, kScenes.size()> all;
        for (std::size_t k = 0; k < kScenes.size(); ++k) {
            all[k] = read_lesson_file(std::string(JW_SOURCE_ROOT) + "/" + kScenes[k]).lesson.value();
        }
        return all;
    }();
    return lessons.at(which);
}

/// @return whether the sentence was understood
bool try_sentence(Session& session, const std::string& sentence) {
    std::string error;
    const auto experiment = read_experiment(sentence, session, error);
    promise(experiment.has_value() == error.empty(), "an experiment or what is wrong: " + error);
    if (experiment) {
        const std::string text = text_of(*experiment, session.lesson());
        const auto again = read_experiment(text, session, error);
        promise(again.has_value(), "'" + text + "' of '" + sentence + "' is understood: " + error);
        promise(
            text_of(*again, session.lesson()) == text,
            "'" + text + "' of '" + sentence + "' is understood as itself");
    }
    const ExperimentResult result = carry_out(session, sentence);
    promise(result.done || !result.said.empty(), "'" + sentence + "' that is not done says why");
    const ReadResult saved = read_lesson(lesson_text(session.lesson()), "tried.toml");
    promise(saved.lesson.has_value(), "after '" + sentence + "' the lesson can be saved:\n" + saved.report());
    promise(
        session.index() >= 0 && session.index() < static_cast<int>(session.story().steps().size()),
        "a step is shown");
    return experiment.has_value();
}

}  // namespace

/// Tries experiments: the first byte chooses the scene, each line is an experiment.
bool check_experiments(const std::string& input) {
    if (input.empty()) { return false; }
    Session session(scene(static_cast<unsigned char>(input[0]) % kScenes.size()), false);
    std::istringstream lines(input.substr(1));
    int count = 0;
    bool understood = false;
    for (std::string line; count < kMostExperiments && std::getline(lines, line); ++count) {
        understood = try_sentence(session, line) || understood;
    }
    return understood;
}

}  // namespace jw::fuzz
