#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/diagnostics/diagnostics.hpp"
#include "tests/hard/report.hpp"

/// The hard cases: hard_cases [--markdown] [CASE...]; ./dev bench hard. Exit status 1 if a number is out of
/// its bounds, 2 for a name that is not a case.
namespace {

using namespace jw::hard;

std::vector<const Case*> chosen_by(const std::vector<std::string_view>& names) {
    std::vector<const Case*> chosen;
    for (const Case& c : cases()) {
        if (names.empty() || std::ranges::find(names, c.name) != names.end()) { chosen.push_back(&c); }
    }
    return chosen;
}

}  // namespace

int main(int argc, char** argv) {
    const std::span<char*> arguments(argv + 1, static_cast<std::size_t>(argc - 1));
    std::vector<std::string_view> names(arguments.begin(), arguments.end());
    const bool markdown = std::erase(names, "--markdown") > 0;
    const std::vector<const Case*> chosen = chosen_by(names);
    for (const std::string_view name : names) {
        if (std::ranges::find(cases(), name, &Case::name) != cases().end()) { continue; }
        std::vector<std::string> known;
        for (const Case& c : cases()) { known.emplace_back(c.name); }
        const std::string hint = jw::did_you_mean(name, known);
        std::cerr << "hard_cases: error: " << jw::in_quotes(name) << ": no such hard case; expected one of "
                  << jw::comma_list(known) << '\n'
                  << (hint.empty() ? "" : "hint: " + hint + '\n');
        return 2;
    }
    if (markdown) { std::cout << markdown_head(); }
    bool broken = false;
    for (const Case* c : chosen) {
        const Result result = c->run();
        std::cout << (markdown ? markdown_of(*c, result) : text_of(*c, result)) << std::flush;
        for (const std::string& sentence : broken_bounds(result)) {
            std::cerr << c->name << ": " << sentence << '\n';
            broken = true;
        }
    }
    return broken ? 1 : 0;
}
