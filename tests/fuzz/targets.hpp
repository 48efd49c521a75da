#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

/// Readers of untrusted input, with their promises for any bytes. libFuzzer and the replay of kept inputs run
/// the same functions.
namespace jw::fuzz {

/// An input for which a promise was not kept: what was promised, and what came instead.
class Broken : public std::logic_error {
public:
    using std::logic_error::logic_error;
};

/// @throws Broken with `promise` if it was not kept
void promise(bool kept, const std::string& promise);

struct Target {
    const char* name;  ///< also of its folder in tests/fuzz/corpus and its list of words
    const char* promises;
    /// @return whether the input was understood, so that promises about its contents were checked
    /// @throws Broken if a promise is not kept; nothing else may be thrown
    bool (*check)(const std::string& input);
};
std::span<const Target> targets();
/// @throws std::invalid_argument with the names of all targets if none has this name
const Target& target_called(std::string_view name);

// the targets
bool check_lesson(const std::string& input);
bool check_story(const std::string& input);
bool check_experiments(const std::string& input);
bool check_answers(const std::string& input);
bool check_files(const std::string& input);
bool check_record(const std::string& input);
bool check_picture(const std::string& input);
bool check_formula(const std::string& input);
bool check_driver(const std::string& input);

}  // namespace jw::fuzz
