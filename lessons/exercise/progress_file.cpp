#include "lessons/exercise/progress_file.hpp"

#include "lessons/fields/fields.hpp"
#include "lessons/fields/toml_text.hpp"
#include "lessons/typed/exact_text.hpp"

namespace jw {

namespace {

constexpr int kMostCounted = 1000000000;

int count_in(Fields& fields, std::string_view key) {
    const auto count = fields.integer(key, 0, kMostCounted);
    return count ? count->value : 0;
}

void read_records(Fields& root, ExerciseRecords& records) {
    for (Fields& fields : root.tables("exercise")) {
        fields.require("name", "the key of an exercise");
        const auto name = fields.text("name");
        ExerciseRecord record;
        record.tried = count_in(fields, "tried");
        record.solved = count_in(fields, "solved");
        record.streak = count_in(fields, "streak");
        record.variant = count_in(fields, "variant");
        fields.finish();
        if (name) { records[name->value] = record; }
    }
}

}  // namespace

std::string progress_text(const ExerciseRecords& records) {
    std::string text = "# Exercises tried in the window of Jointwise.\nformat = 1\nfile = \"progress\"\n";
    for (const auto& [key, record] : records) {
        text += "\n[[exercise]]\nname = " + writing::string_text(key) +
                "\ntried = " + std::to_string(record.tried) + "\nsolved = " + std::to_string(record.solved) +
                "\nstreak = " + std::to_string(record.streak) +
                "\nvariant = " + std::to_string(record.variant) + "\n";
    }
    return text;
}

ProgressRead read_progress(std::string text) {
    ProgressRead read;
    Problems problems("progress.toml", text);
    if (const auto table = reading::parse_toml(text, problems)) {
        Fields root(*table, "the progress", problems);
        static const std::vector<std::string> kWords{"progress"};
        root.require("format", "format = 1");
        root.integer("format", 1, 1);
        root.require("file", "file = \"progress\"");
        root.word("file", kWords);
        read_records(root, read.records);
        root.finish();
    }
    const std::vector<Diagnostic> found = problems.take();
    if (!found.empty()) {
        read.records.clear();
        read.problem = "line " + std::to_string(found.front().span.line) + ": " + found.front().message;
    }
    return read;
}

}  // namespace jw
