#pragma once

#include <string>
#include <vector>

#include "app/commands/command.hpp"
#include "core/quantity/names.hpp"

namespace CLI {
class App;
}

/// Quantities that a command is asked for by name.
namespace jw {

/// Quantities by their names, as typed behind an option. Names of before are noted on the error stream.
/// @throws CommandError for a name that is none
std::vector<NamedQuantity> quantities_named(
    const std::string& option, const std::vector<std::string>& names, const Mechanism& mechanism,
    const Streams& streams);

/// Option `--quantities`, names separated by commas.
void add_quantities_option(CLI::App& command, std::vector<std::string>& names);

/// Flag `--old-names`: columns are called as they were before there was one name for a quantity.
void add_old_names_flag(CLI::App& command, bool& old_names);

/// The first `count` columns, by their names of before.
void rename_columns(std::vector<std::string>& columns, std::size_t count);

}  // namespace jw
