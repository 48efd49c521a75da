#include <CLI/CLI.hpp>

#include <algorithm>
#include <map>

#include "app/commands/commands.hpp"
#include "lessons/catalogue.hpp"
#include "lessons/reader.hpp"

namespace jw {

namespace {

struct Entry {
    std::string path;
    std::string title;
    std::string source;
};

Exit list(const std::filesystem::path& folder, const Streams& streams) {
    const std::vector<std::filesystem::path> files = lessons_below(folder);
    if (files.empty()) {
        throw CommandError(
            Exit::bad_input, "jointwise: error: no lesson (*.toml) below '" + folder.string() +
                                 "'; give another folder, or set JOINTWISE_LESSONS");
    }
    std::map<std::string, std::vector<Entry>> chapters;
    std::size_t widest = 0;
    Exit exit = Exit::done;
    for (const auto& file : files) {
        const ReadResult read = read_lesson_file(file);
        if (!read.lesson) {
            streams.err << read.report();
            exit = Exit::bad_input;
            continue;
        }
        const Lesson& lesson = *read.lesson;
        const std::string path = std::filesystem::relative(file).string();
        chapters[lesson.chapter].push_back({path, lesson.title, lesson.source});
        widest = std::max(widest, path.size());
    }
    for (const auto& [chapter, entries] : chapters) {
        streams.out << (chapter.empty() ? "other" : chapter) << '\n';
        for (const Entry& e : entries) {
            streams.out << "  " << e.path << std::string(widest - e.path.size() + 2, ' ') << e.title;
            if (!e.source.empty()) { streams.out << " (" << e.source << ')'; }
            streams.out << '\n';
        }
    }
    return exit;
}

}  // namespace

void add_list(CLI::App& app, const Streams& streams, Run& run) {
    CLI::App* command = app.add_subcommand("list", "show the lessons, by chapter");
    auto folder = std::make_shared<std::string>(catalogue_folder().string());
    command->add_option("FOLDER", *folder, "where lessons are looked for")->type_name("");
    command->footer("Example: jointwise list");
    command->callback(
        [folder, &streams, &run] { run = [folder, &streams] { return list(*folder, streams); }; });
}

}  // namespace jw
