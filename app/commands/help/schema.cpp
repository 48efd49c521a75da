#include <CLI/CLI.hpp>

#include "app/commands/help/lesson_schema.hpp"
#include "app/commands/program/commands.hpp"

namespace jw {

void add_schema(CLI::App& app, const Streams& streams, Run& run) {
    CLI::App* command = app.add_subcommand("schema", "write the JSON Schema of lesson files, for editors");
    command->footer("Example: jointwise schema > lesson.schema.json");
    command->callback([&streams, &run] {
        run = [&streams] {
            write_lesson_schema(streams.out);
            return Exit::done;
        };
    });
}

}  // namespace jw
