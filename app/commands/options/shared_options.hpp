#pragma once

#include <string>
#include <vector>

#include "app/commands/program/command.hpp"
#include "app/session/output/json.hpp"
#include "app/session/try/session.hpp"
#include "core/quantity/names.hpp"

namespace CLI {
class App;
}

/// Options that several commands share: --format, --size, --try, --quantities.
namespace jw {

/// Adds `--format WORD`: the command writes the format that one of `words` names; the first is the default
/// and is put into `format`. `--output WORD` and, if "json" is a word, `--json` do the same, but no help
/// shows them.
/// @param format  must live until the command runs
/// @param help    replaces the list of words
void add_format_option(
    CLI::App& command, std::string& format, const std::vector<std::string>& words,
    const std::string& help = {});

struct PixelSize {
    int width = 0;
    int height = 0;
};

/// @param either_way  the picture may be higher than wide: then the limits are swapped
/// @throws CommandError if the text is not a size, or the size is not between the limits
PixelSize size_option(
    const std::string& text, PixelSize smallest, PixelSize largest, bool either_way = false);

void add_try_option(CLI::App& command, std::vector<std::string>& experiments);

/// Adds the argument FILE, and --try.
void add_lesson_options(
    CLI::App& command, std::string& file, std::vector<std::string>& experiments,
    const std::string& about = "lesson file");

/// A lesson after all experiments, and what these did in words.
struct ChangedLesson {
    Lesson lesson;
    std::vector<std::string> done;
};

/// Carries out all of `experiments` and says in words what they did.
/// @throws CommandError (bad_input) for an experiment that cannot be carried out
std::vector<std::string> carry_out_all(Session& session, const std::vector<std::string>& experiments);

/// The lesson in `path` after all of `experiments`, one after the other.
/// @throws CommandError (bad_input) for a lesson with mistakes, and as carry_out_all does
ChangedLesson lesson_of(
    const std::filesystem::path& path, const std::vector<std::string>& experiments, const Streams& streams);

/// One line each, "tried: hinge: without x"; empty if nothing was done.
std::string done_text(const std::vector<std::string>& done);
/// Adds the key "tried" if something was done.
void add_done(Json& json, const std::vector<std::string>& done);

/// The document with the key "tried" if something was done.
std::string document_of(Json json, const std::vector<std::string>& done);

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
