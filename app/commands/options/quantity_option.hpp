#pragma once

#include <string>
#include <vector>

#include "app/commands/program/command.hpp"
#include "core/quantity/names.hpp"

namespace CLI {
class App;
}

/// Quantities that the user names for a command.
namespace jw {

/// Quantities by their names, as typed after an option. Old names cause a note on the error stream.
/// @throws CommandError for a name that is not a quantity
std::vector<NamedQuantity> quantities_named(
    const std::string& option, const std::vector<std::string>& names, const Mechanism& mechanism,
    const Streams& streams);

/// Option `--quantities`, names separated by commas.
void add_quantities_option(CLI::App& command, std::vector<std::string>& names);

/// Flag `--old-names`: columns have the names from before each quantity had one name everywhere.
void add_old_names_flag(CLI::App& command, bool& old_names);

/// Gives the first `count` columns their old names.
void rename_columns(std::vector<std::string>& columns, std::size_t count);

}  // namespace jw
