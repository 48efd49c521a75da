#include "app/commands/options/quantity_option.hpp"

#include <CLI/CLI.hpp>

#include "app/commands/program/commands.hpp"
#include "app/session/wording/quantity_text.hpp"
#include "lessons/diagnostics/diagnostics.hpp"

namespace jw {

namespace {

/// Error for an unknown quantity, with similar names: quantities of the same owner, or the owners that exist.
CommandError unknown(const std::string& option, const std::string& name, const Mechanism& mechanism) {
    std::vector<std::string> names;
    std::vector<std::string> of_owner;
    const std::string owner(owner_in(name));
    for (const NamedQuantity& q : quantities_of(mechanism)) {
        names.push_back(name_of(q.quantity, q.derivative, mechanism));
        if (owner_in(names.back()) == owner) { of_owner.push_back(names.back()); }
    }
    std::vector<std::string> owners{"energy", "jacobian"};
    for (const Body& body : mechanism.bodies) { owners.push_back(body.name); }
    for (const Joint& joint : mechanism.joints) { owners.push_back(joint.name); }
    for (const Driver& driver : mechanism.drivers) { owners.push_back(driver.name); }
    const std::string expected = of_owner.empty() ? "NAME.WHAT with NAME one of " + comma_list(owners)
                                                  : "one of " + comma_list(of_owner);
    const std::string near = did_you_mean(name, names);
    return bad_input(
        option + ": no quantity " + in_quotes(name) + "; expected " + expected,
        near.empty() ? "docs/quantities.md has all names" : near);
}

}  // namespace

std::vector<NamedQuantity> quantities_named(
    const std::string& option, const std::vector<std::string>& names, const Mechanism& mechanism,
    const Streams& streams) {
    std::vector<NamedQuantity> list;
    for (const std::string& name : names) {
        const std::optional<ReadName> read = read_name(name, mechanism);
        if (!read) { throw unknown(option, name, mechanism); }
        if (read->wants_point) {
            throw bad_input(
                option + ": " + in_quotes(name) +
                " leaves its point open; expected it in the body's frame, in m, like " +
                std::string(owner_in(name)) + ".point[0.5 0 0].x");
        }
        if (!read->name_of_today.empty()) {
            streams.err << "jointwise: note: " << in_quotes(name) << " is now called "
                        << in_quotes(read->name_of_today) << "; the old name goes with the next version\n";
        }
        list.push_back(read->named);
    }
    return list;
}

void add_quantities_option(CLI::App& command, std::vector<std::string>& names) {
    add_value(
        command, "--quantities", names, "A,B",
        "more columns, by name, separated by commas: hinge.force.x,energy.sum")
        ->delimiter(',')
        ->allow_extra_args(false);
}

void add_old_names_flag(CLI::App& command, bool& old_names) {
    command.add_flag("--old-names", old_names, "name columns as in earlier versions");
}

void rename_columns(std::vector<std::string>& columns, std::size_t count) {
    for (std::size_t k = 0; k < std::min(count, columns.size()); ++k) {
        columns[k] = column_of_before(columns[k]);
    }
}

}  // namespace jw
