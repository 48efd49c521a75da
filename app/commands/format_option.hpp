#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace jw {

/// Adds `--format WORD`: what a command writes is one of `words`, of which the first is the default and is
/// put into `format`. `--output WORD` and, where "json" is a word, `--json` still say the same and are in no
/// help.
/// @param format  must live until the command runs
/// @param help    in place of the list of words
void add_format_option(
    CLI::App& command, std::string& format, const std::vector<std::string>& words,
    const std::string& help = {});

}  // namespace jw
