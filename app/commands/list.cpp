#include <CLI/CLI.hpp>

#include <algorithm>
#include <map>

#include "app/commands/commands.hpp"
#include "app/commands/format_option.hpp"
#include "app/session/wording/text_table.hpp"
#include "lessons/catalogue.hpp"
#include "lessons/reader.hpp"

namespace jw {

namespace {

struct ListOptions {
    std::string folder = catalogue_folder().string();
    std::string format;
};

struct Entry {
    std::filesystem::path file;
    std::string chapter;
    std::string title;
    std::string source;
};

void write_text(const std::vector<Entry>& entries, std::ostream& out) {
    const auto path_of = [](const Entry& e) { return std::filesystem::relative(e.file).string(); };
    std::map<std::string, std::vector<const Entry*>> chapters;
    std::size_t widest = 0;
    for (const Entry& e : entries) {
        chapters[e.chapter].push_back(&e);
        widest = std::max(widest, path_of(e).size());
    }
    for (const auto& [chapter, of_chapter] : chapters) {
        out << (chapter.empty() ? "other" : chapter) << '\n';
        for (const Entry* e : of_chapter) {
            const std::string path = path_of(*e);
            out << "  " << path << std::string(widest - path.size() + 2, ' ') << e->title;
            if (!e->source.empty()) { out << " (" << e->source << ')'; }
            out << '\n';
        }
    }
}

/// The table of README.md, in the order of a course; a lesson is named by its path below `folder`.
void write_markdown(std::vector<Entry> entries, const std::filesystem::path& folder, std::ostream& out) {
    std::ranges::stable_sort(entries, {}, [](const Entry& e) { return chapter_place(e.file); });
    out << "| lesson | | source |\n| --- | --- | --- |\n";
    for (const Entry& e : entries) {
        const auto path = std::filesystem::relative(e.file, folder).replace_extension();
        out << "| `" << path.generic_string() << "` | " << markdown_cell(e.title) << " | "
            << markdown_cell(e.source) << " |\n";
    }
}

Exit list(const ListOptions& options, const Streams& streams) {
    const std::vector<std::filesystem::path> files = lessons_below(options.folder);
    if (files.empty()) {
        throw CommandError(
            Exit::bad_input, "jointwise: error: no lesson (*.toml) below '" + options.folder +
                                 "'; give another folder, or set JOINTWISE_LESSONS");
    }
    std::vector<Entry> entries;
    for (const auto& file : files) {
        const ReadResult read = read_lesson_file(file);
        if (read.lesson) {
            entries.push_back({file, read.lesson->chapter, read.lesson->title, read.lesson->source});
        } else {
            streams.err << read.report();
        }
    }
    if (options.format == "markdown") {
        write_markdown(entries, options.folder, streams.out);
    } else {
        write_text(entries, streams.out);
    }
    return entries.size() == files.size() ? Exit::done : Exit::bad_input;
}

}  // namespace

void add_list(CLI::App& app, const Streams& streams, Run& run) {
    CLI::App* command = app.add_subcommand("list", "show the lessons, by chapter");
    auto options = std::make_shared<ListOptions>();
    command->add_option("FOLDER", options->folder, "folder that lessons are looked for in")->type_name("");
    add_format_option(*command, options->format, {"text", "markdown"});
    command->footer("Example: jointwise list");
    command->callback(
        [options, &streams, &run] { run = [options, &streams] { return list(*options, streams); }; });
}

}  // namespace jw
