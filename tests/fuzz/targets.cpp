#include "tests/fuzz/targets.hpp"

#include <algorithm>
#include <array>

namespace jw::fuzz {

namespace {

constexpr std::array kTargets{
    Target{
        "lesson",
        "a lesson is read or refused at places inside the file; what was read and is written again reads the "
        "same",
        check_lesson},
    Target{
        "story", "a lesson that is read can be told: every step has a text, a JSON document and a picture",
        check_story},
    Target{
        "experiments",
        "an experiment that is understood has a sentence that is understood as the same; what was tried can "
        "be saved",
        check_experiments},
    Target{
        "answers",
        "an answer file is refused at places inside it or graded, each exercise once, with 0 to all of its "
        "points",
        check_answers},
    Target{
        "files", "a file or program output that is handed in is judged: all points exactly if it is right",
        check_files},
    Target{
        "record", "the record of a snapshot is refused, or it is written as the same record", check_record},
    Target{"picture", "a PNG is refused, or it is written as the same picture", check_picture},
    Target{
        "formula",
        "a formula is refused at a place inside it, or written in a way that reads as the same formula",
        check_formula},
    Target{
        "driver",
        "a function of time that is accepted has finite values, and the derivatives that belong to them",
        check_driver},
};

}  // namespace

void promise(bool kept, const std::string& promise) {
    if (!kept) { throw Broken(promise); }
}

std::span<const Target> targets() { return kTargets; }

const Target& target_called(std::string_view name) {
    const auto found = std::ranges::find(kTargets, name, &Target::name);
    if (found != kTargets.end()) { return *found; }
    std::string names;
    for (const Target& target : kTargets) { names += (names.empty() ? "" : ", ") + std::string(target.name); }
    throw std::invalid_argument("no target '" + std::string(name) + "'; expected one of " + names);
}

}  // namespace jw::fuzz
