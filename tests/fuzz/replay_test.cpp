#include <catch2/catch.hpp>

#include <random>

#include "tests/fuzz/targets.hpp"
#include "tests/fuzz/words.hpp"
#include "tests/support/mutated_text.hpp"

namespace jw::fuzz {
namespace {

const std::filesystem::path kFolder = JW_FUZZ;
constexpr unsigned kSeed = 20261125;

/// Fault of the target with this input; empty if there is none.
/// @param understood  incremented if the input was understood
std::string fault_of(const Target& target, const std::string& input, int& understood) {
    try {
        understood += target.check(input) ? 1 : 0;
    } catch (const std::exception& broken) { return broken.what(); }
    return {};
}

/// @return 1 if the input was understood
int check(const Target& target, const std::string& name, const std::string& input) {
    int understood = 0;
    const std::string fault = fault_of(target, input, understood);
    if (fault.empty()) { return understood; }
    FAIL_CHECK(
        std::string(target.name) + " promises that " + target.promises + "\nbroken by " + name + ": " +
        fault + "\n" + input);
    return 0;
}

const Target& any_target() {
    std::vector<const Target*> all;
    for (const Target& target : targets()) { all.push_back(&target); }
    return *GENERATE_REF(from_range(all));
}

/// Number of damaged inputs that the target checks in less than two seconds.
int damaged_inputs(const Target& target) {
    const std::string name = target.name;
    if (name == "experiments" || name == "story" || name == "files") { return 200; }
    return 3000;
}

}  // namespace

TEST_CASE("readers keep their promises for all kept inputs", "[fuzz]") {
    const Target& target = any_target();
    const std::vector<Kept> kept = kept_inputs(kFolder / "corpus" / target.name);
    CAPTURE(target.name);
    int understood = 0;
    for (const Kept& input : kept) { understood += check(target, input.name, input.text); }
    // if most inputs were refused, hardly any promise would be checked
    CHECK(2 * understood >= static_cast<int>(kept.size()));
    for (const char* edge : {"", "a", "\n", "\xFF", "[[[[", "{\"\":"}) { check(target, "an edge", edge); }
}

TEST_CASE("damaged kept inputs break no promise either", "[fuzz]") {
    const Target& target = any_target();
    const std::vector<Kept> kept = kept_inputs(kFolder / "corpus" / target.name);
    const std::vector<std::string> words =
        read_words(kFolder / "words" / (target.name + std::string(".dict")));
    std::mt19937 random(kSeed);
    for (int k = 0; k < damaged_inputs(target); ++k) {
        const Kept& input = kept[random() % kept.size()];
        check(
            target, "mutant " + std::to_string(k) + " of " + input.name,
            test::mutated(input.text, random, words));
    }
}

TEST_CASE("a broken promise is noticed", "[fuzz]") {
    const Target broken{"broken", "no input has a z", [](const std::string& input) {
                            promise(input.find('z') == std::string::npos, "there is a z");
                            return true;
                        }};
    int understood = 0;
    CHECK(fault_of(broken, "a", understood) == "");
    CHECK(fault_of(broken, "az", understood) == "there is a z");
    CHECK(understood == 1);
}

}  // namespace jw::fuzz
