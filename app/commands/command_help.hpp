#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

/// The help of the program as data: what manual and completions are made of, so that they know every option.
namespace jw {

struct OptionHelp {
    std::vector<std::string> names;    ///< "-h", "--help"; of what stands without a name: "FILE"
    std::string value;                 ///< "NAME"; empty for a flag
    std::vector<std::string> choices;  ///< all words that it can be, empty where it can be others
    std::string description;
    bool required = false;
    bool many = false;
};

struct CommandHelp {
    std::string name;  ///< "render", or "snapshot record" of one that is part of another
    std::string description;
    std::string footer;
    std::vector<std::string> parts;  ///< words that must follow: "record", "compare"
    std::vector<OptionHelp> positionals;
    std::vector<OptionHelp> options;  ///< those that help shows
};

struct ProgramHelp {
    CommandHelp program;                ///< with the options that stand before and behind every command
    std::vector<CommandHelp> commands;  ///< in the order of the program's help, parts behind their own
};

ProgramHelp help_of(const CLI::App& app);

/// @param shell "bash", "zsh" or "fish"
std::string completion_for(const ProgramHelp& help, const std::string& shell);
/// Manual page of section 1, for man.
std::string manual_page(const ProgramHelp& help, const std::string& version);

}  // namespace jw
