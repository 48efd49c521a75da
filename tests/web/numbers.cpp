#include <array>
#include <cstdint>
#include <exception>
#include <iostream>
#include <string>
#include <string_view>
#include <utility>

#include "app/session/claims/checks.hpp"
#include "app/session/output/json.hpp"
#include "app/session/story/dynamics_run.hpp"
#include "app/session/story/story.hpp"
#include "app/session/view/inspection.hpp"
#include "app/session/view/solution.hpp"
#include "lessons/lesson/enum_words.hpp"
#include "lessons/read/reader.hpp"

/// The numbers of lessons, as the commands of the same names print them by default. The program reads only
/// the files that it is given, and also runs where there are no commands. Its output is the same on every
/// machine, which numbers_test.py checks on several.
///
///     numbers FILE...            for each document of each lesson its hash, its size and its name
///     numbers --json NAME FILE   one document
namespace jw {

namespace {

std::string inspection_of(const Lesson& lesson) {
    const Story story(lesson, last_pose_only());
    const int last = static_cast<int>(story.steps().size()) - 1;
    std::string text;
    for (const auto& choice : kChoices) {
        text += json_document(json_of(inspect_step(story, last, choice.value, Spectrum::always), lesson));
    }
    return text;
}

std::string steps_of(const Lesson& lesson) {
    const Story story(lesson, StoryOptions{});
    return json_document(json_of(story, static_cast<int>(story.steps().size()) - 1));
}

std::string solution_of(const Lesson& lesson, Analysis analysis) {
    const MotionPlan motion = lesson.motion.value_or(MotionPlan{});
    const SweepPlan plan{analysis, motion.from, motion.to, (motion.to - motion.from) / motion.steps};
    return json_document(json_of(solve_sweep(lesson, plan), analysis, lesson));
}

std::string positions_of(const Lesson& lesson) { return solution_of(lesson, Analysis::position); }
std::string accelerations_of(const Lesson& lesson) { return solution_of(lesson, Analysis::acceleration); }

std::string claims_of(const Lesson& lesson) {
    std::string text;
    for (const ClaimResult& claim : check_claims(lesson)) {
        text += (claim.holds ? "holds: " : "fails: ") + claim.moment + ' ' + claim.subject + ": " +
                claim.expected + ", " + claim.found + '\n';
    }
    return text;
}

std::string simulation_of(const Lesson& lesson, DynamicsRequest request) {
    if (entry_of(request.settings.method).adaptive) { request.settings.most_steps = kMostStepsUnasked; }
    request.reactions = true;
    return json_document(json_of(simulate(lesson, request), lesson));
}

/// Simulation by another method, for a quarter of the lesson's time.
std::string simulation_by(const Lesson& lesson, Method method, Formulation formulation) {
    DynamicsRequest request = request_of(lesson);
    request.settings.method = method;
    request.settings.formulation = formulation;
    request.method_chosen = true;
    request.duration *= 0.25;
    return simulation_of(lesson, std::move(request));
}

std::string usual_simulation_of(const Lesson& lesson) {
    return lesson.dynamics ? simulation_of(lesson, request_of(lesson)) : std::string();
}
std::string simulation_of_bodies(const Lesson& lesson) {
    return lesson.dynamics ? simulation_by(lesson, Method::explicit_5, Formulation::bodies) : std::string();
}
std::string implicit_simulation_of(const Lesson& lesson) {
    return lesson.dynamics ? simulation_by(lesson, Method::implicit_5, Formulation::automatic)
                           : std::string();
}

struct Document {
    const char* name;
    std::string (*of)(const Lesson& lesson);  ///< empty where the lesson has none
};

constexpr std::array kDocuments{
    Document{"inspect", &inspection_of},
    Document{"step", &steps_of},
    Document{"solve", &positions_of},
    Document{"solve-acceleration", &accelerations_of},
    Document{"check", &claims_of},
    Document{"simulate", &usual_simulation_of},
    Document{"simulate-bodies", &simulation_of_bodies},
    Document{"simulate-implicit", &implicit_simulation_of}};

Lesson lesson_of(const std::string& file) {
    ReadResult read = read_lesson_file(file);
    if (!read.lesson) { throw std::runtime_error(read.report()); }
    return std::move(*read.lesson);
}

/// The document, or why there is none.
std::string text_of(const Document& document, const Lesson& lesson) {
    try {
        return document.of(lesson);
    } catch (const std::exception& error) { return std::string("error: ") + error.what() + '\n'; }
}

/// FNV-1a of 64 bits
std::uint64_t hash_of(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char c : text) { hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U; }
    return hash;
}

void print_hashes(const std::string& file) {
    const Lesson lesson = lesson_of(file);
    for (const Document& document : kDocuments) {
        const std::string text = text_of(document, lesson);
        if (text.empty()) { continue; }
        std::cout << std::hex << hash_of(text) << std::dec << ' ' << text.size() << ' ' << document.name
                  << ' ' << file << '\n'
                  << std::flush;
    }
}

}  // namespace

}  // namespace jw

int main(int count, char** arguments) {
    try {
        if (count == 4 && std::string_view(arguments[1]) == "--json") {
            for (const jw::Document& document : jw::kDocuments) {
                if (std::string_view(arguments[2]) != document.name) { continue; }
                std::cout << jw::text_of(document, jw::lesson_of(arguments[3]));
            }
            return 0;
        }
        for (int k = 1; k < count; ++k) { jw::print_hashes(arguments[k]); }
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
    return 0;
}
