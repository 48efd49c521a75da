#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace jw {

/// Adds `--format WORD`: the command writes the format that one of `words` names; the first is the default
/// and is put into `format`. `--output WORD` and, if "json" is a word, `--json` do the same, but no help
/// shows them.
/// @param format  must live until the command runs
/// @param help    replaces the list of words
void add_format_option(
    CLI::App& command, std::string& format, const std::vector<std::string>& words,
    const std::string& help = {});

}  // namespace jw
