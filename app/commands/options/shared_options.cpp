#include "app/commands/options/shared_options.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <optional>
#include <regex>

#include "app/commands/program/add_command.hpp"
#include "app/session/try/carry_out.hpp"
#include "app/session/wording/quantity_text.hpp"
#include "lessons/diagnostics/diagnostics.hpp"

namespace jw {

namespace {

/// "text, csv or json"
std::string or_list(const std::vector<std::string>& words) {
    std::string text = words.front();
    for (std::size_t k = 1; k < words.size(); ++k) {
        text += (k + 1 == words.size() ? " or " : ", ") + words[k];
    }
    return text;
}

std::string text_of(PixelSize size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

bool fits(PixelSize size, PixelSize smallest, PixelSize largest) {
    return size.width >= smallest.width && size.height >= smallest.height && size.width <= largest.width &&
           size.height <= largest.height;
}

std::optional<PixelSize> read_size(const std::string& text) {
    static const std::regex form("([0-9]{1,5})x([0-9]{1,5})");
    std::smatch match;
    if (!std::regex_match(text, match, form)) { return std::nullopt; }
    return PixelSize{std::stoi(match[1]), std::stoi(match[2])};
}

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

void add_format_option(
    CLI::App& command, std::string& format, const std::vector<std::string>& words, const std::string& help) {
    format = words.front();
    const auto add = [&](const char* name) {
        return add_value(command, name, format, "FORMAT", help.empty() ? or_list(words) : help)
            ->check(CLI::IsMember(words));
    };
    CLI::Option* const option = add("--format");
    // help does not show an empty group
    CLI::Option* const output = add("--output")->group("")->excludes(option);
    if (std::ranges::find(words, "json") == words.end()) { return; }
    command.add_flag_callback("--json", [&format] { format = "json"; })
        ->group("")
        ->excludes(option)
        ->excludes(output);
}

PixelSize size_option(const std::string& text, PixelSize smallest, PixelSize largest, bool either_way) {
    const std::optional<PixelSize> size = read_size(text);
    const bool is_good = size && (fits(*size, smallest, largest) ||
                                  (either_way && fits({size->height, size->width}, smallest, largest)));
    if (is_good) { return *size; }
    throw bad_input(
        "--size '" + text + "'; expected WIDTHxHEIGHT in pixels from " + text_of(smallest) + " to " +
        text_of(largest) + (either_way ? ", or turned" : "") + ", for example 1920x1080");
}

void add_try_option(CLI::App& command, std::vector<std::string>& experiments) {
    add_value(
        command, "--try", experiments, "TEXT",
        "experiment to carry out first, as listed by 'jointwise try FILE'; can be given several times")
        ->type_size(1)
        ->allow_extra_args(false);
}

void add_lesson_options(
    CLI::App& command, std::string& file, std::vector<std::string>& experiments, const std::string& about) {
    add_value(command, "FILE", file, "", about)->required();
    add_try_option(command, experiments);
}

std::vector<std::string> carry_out_all(Session& session, const std::vector<std::string>& experiments) {
    std::vector<std::string> done;
    for (const std::string& text : experiments) {
        const ExperimentResult result = carry_out(session, text);
        if (!result.done) { throw bad_input("--try " + in_quotes(text) + ": " + result.said); }
        done.push_back(result.said);
    }
    return done;
}

ChangedLesson lesson_of(
    const std::filesystem::path& path, const std::vector<std::string>& experiments, const Streams& streams) {
    Lesson lesson = lesson_of(path, streams);
    if (experiments.empty()) { return {std::move(lesson), {}}; }
    Session session(std::move(lesson));
    std::vector<std::string> done = carry_out_all(session, experiments);
    return {session.lesson(), std::move(done)};
}

std::string done_text(const std::vector<std::string>& done) {
    std::string text;
    for (const std::string& one : done) { text += "tried: " + one + '\n'; }
    return text;
}

void add_done(Json& json, const std::vector<std::string>& done) {
    if (!done.empty()) { json["tried"] = done; }
}

std::string document_of(Json json, const std::vector<std::string>& done) {
    add_done(json, done);
    return json_document(json);
}

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
                        << in_quotes(read->name_of_today)
                        << "; the next version will not accept the old name\n";
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
