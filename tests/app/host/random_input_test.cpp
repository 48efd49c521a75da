#include <catch2/catch.hpp>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "lessons/files/catalogue.hpp"
#include "tests/app/host/checks.hpp"
#include "tests/app/host/exercise_lesson.hpp"
#include "tests/app/host/random_person.hpp"
#include "tests/support/number_from.hpp"

#if defined(__SANITIZE_ADDRESS__)
#include <sanitizer/common_interface_defs.h>
#endif

namespace jw::test {
namespace {

constexpr int kEvents = 300;
constexpr std::uint32_t kSeed = 20240;

std::string text_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Printed also when a sanitizer ends the program at once.
std::string who;
const RandomPerson* at_work = nullptr;
[[maybe_unused]] void say_who() {
    if (at_work != nullptr) { std::fprintf(stderr, "%s%s\n", who.c_str(), at_work->trail().c_str()); }
}

void try_lesson(
    const std::filesystem::path& lesson, const std::vector<std::string>& others, std::uint32_t seed) {
    const auto events = static_cast<int>(number_from("JW_RANDOM_EVENTS", kEvents));
    TemporaryFolder folder;
    const std::filesystem::path file = folder.write(lesson.filename().string(), text_of(lesson));
    Person person(file.string());
    RandomPerson somebody(person, seed, file, others);
    at_work = &somebody;
    who = "JW_RANDOM_SEED=" + std::to_string(seed) + " JW_RANDOM_LESSON=" + lesson.stem().string() + "\n";
    while (somebody.events() < events) {
        somebody.act();
        const std::string fault = fault_of(person.host());
        INFO(who << somebody.trail());
        REQUIRE(fault == "");
    }
    at_work = nullptr;
}

}  // namespace

TEST_CASE("Whatever somebody does at random to any lesson, numbers stay finite and nothing breaks") {
#if defined(__SANITIZE_ADDRESS__)
    __sanitizer_set_death_callback(say_who);
#endif
    const std::uint32_t seed = number_from("JW_RANDOM_SEED", kSeed);
    const char* const only = std::getenv("JW_RANDOM_LESSON");
    const std::vector<std::filesystem::path> lessons = lessons_below(catalogue_folder());
    std::vector<std::string> texts;
    for (const auto& lesson : lessons) { texts.push_back(text_of(lesson)); }
    texts.emplace_back("title = \"broken\"\n[[bodies]]\nname = 3\n");
    for (std::size_t k = 0; k < lessons.size(); ++k) {
        if (only != nullptr && lessons[k].stem() != only) { continue; }
        try_lesson(lessons[k], texts, seed + (only != nullptr ? 0 : static_cast<std::uint32_t>(k)));
    }
}

TEST_CASE("Whatever somebody does at random to a lesson with exercises of every kind, nothing breaks") {
    const TemporaryFolder folder;
    const std::filesystem::path lesson = folder.write("all-kinds.toml", lesson_with_exercises());
    try_lesson(lesson, {text_of(lesson)}, number_from("JW_RANDOM_SEED", kSeed));
}

}  // namespace jw::test
