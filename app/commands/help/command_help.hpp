#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

/// The help of the program as data: the manual and the completions are made from it, so that they know every
/// option.
namespace jw {

struct OptionHelp {
    std::vector<std::string> names;    ///< "-h", "--help"; for an argument without a name: "FILE"
    std::string value;                 ///< "NAME"; empty for a flag
    std::vector<std::string> choices;  ///< all words that it can be; empty if it can be others
    std::string description;
    bool required = false;
    bool many = false;
};

struct CommandHelp {
    std::string name;  ///< "render", or "snapshot record" for a part of another command
    std::string description;
    std::string footer;
    std::vector<std::string> parts;  ///< words that must follow: "record", "compare"
    std::vector<OptionHelp> positionals;
    std::vector<OptionHelp> options;  ///< options that the help shows
};

struct ProgramHelp {
    CommandHelp program;                ///< with the options that can stand before and after every command
    std::vector<CommandHelp> commands;  ///< in the order of the program's help, parts after their command
};

ProgramHelp help_of(const CLI::App& app);

/// @param shell "bash", "zsh" or "fish"
std::string completion_for(const ProgramHelp& help, const std::string& shell);
/// Manual page of section 1 for man.
std::string manual_page(const ProgramHelp& help, const std::string& version);

}  // namespace jw
