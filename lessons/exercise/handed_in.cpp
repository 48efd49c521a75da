#include "lessons/exercise/handed_in.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <sstream>

#include "lessons/exercise/scene_nodes.hpp"
#include "lessons/fields/fields.hpp"
#include "lessons/files/file_text.hpp"
#include "lessons/typed/exact_text.hpp"

namespace jw {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLargestKey = 100000;
constexpr std::size_t kLargestRoster = 10U << 20U;
constexpr std::size_t kLongestStudent = 80;
constexpr std::size_t kShortestSecret = 8;
constexpr std::size_t kMostAnswers = 1000;
constexpr std::size_t kMostEntries = 5000;

std::string as_text(const toml::node& node) {
    return node.is_string() ? node.as_string()->get() : node_text(node);
}

GivenText given_in(const toml::node& node) {
    GivenText given{as_text(node), {}};
    const toml::array* const list = node.as_array();
    if (list == nullptr) { return given; }
    for (const toml::node& entry : *list) {
        if (given.list.size() < kMostEntries) { given.list.push_back(as_text(entry)); }
    }
    return given;
}

/// The first field of a line of CSV, without quotes.
std::string first_field(const std::string& line) {
    std::string field;
    bool quoted = false;
    for (std::size_t k = 0; k < line.size(); ++k) {
        const char c = line[k];
        if (c == '"') {
            quoted = !quoted;
        } else if (!quoted && (c == ',' || c == ';' || c == '\t' || c == '\r')) {
            break;
        } else {
            field += c;
        }
    }
    while (field.ends_with(' ')) { field.pop_back(); }
    return field.substr(std::min(field.find_first_not_of(' '), field.size()));
}

bool is_head(std::string field) {
    constexpr std::array<std::string_view, 6> kHeads{"student",    "id",   "student id",
                                                     "student_id", "name", "sid"};
    std::ranges::transform(
        field, field.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::ranges::find(kHeads, field) != kHeads.end();
}

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

CourseKey read_course_key(const fs::path& path) {
    CourseKey key;
    FileText file = read_file_text(path, kLargestKey);
    if (!file.problem.empty()) {
        key.problem = path.string() + ": error: " + file.problem +
                      "; expected the key of a course, a file with format = 1 and secret = \"some words\"\n";
        return key;
    }
    FileRead read;
    read_toml(read, std::move(file.text), path.string(), [&](const toml::table& table, Problems& problems) {
        Fields root(table, "the key", problems);
        root.require("format", "format = 1 as the first key");
        root.integer("format", 1, 1);
        root.require("secret", "words that nobody guesses; all numbers of the course follow from them");
        if (const auto secret = root.text("secret")) {
            key.secret = secret->value;
            if (secret->value.size() < kShortestSecret) {
                problems.add(
                    Code::out_of_range, secret->span, "the secret is short; expected at least 8 letters");
            }
        }
        if (const auto files = root.texts("exercises")) {
            for (const Located<std::string>& name : files->value) {
                key.exercises.push_back(path.parent_path() / name.value);
            }
        }
        root.finish();
    });
    key.problem = read.report();
    return key;
}

HandedIn read_answers_text(std::string text) {
    HandedIn handed;
    FileRead read;
    read_toml(read, std::move(text), kAnswersFile, [&](const toml::table& table, Problems& problems) {
        Fields root(table, "the answers", problems);
        root.has("format");
        root.require("student", "the name under which the sheet was made");
        if (const auto student = root.text("student")) {
            handed.student = student->value;
            const std::string fault = fault_of_student(student->value);
            if (!fault.empty()) { problems.add(Code::faulty_name, student->span, fault); }
        }
        const toml::table* const answers = table["answers"].as_table();
        root.has("answers");
        if (answers == nullptr || answers->size() > kMostAnswers) {
            problems.add(
                Code::missing_key, root.span(),
                "there is no table [answers]; expected one with up to 1000 answers");
            return;
        }
        for (const auto& [name, value] : *answers) {
            handed.answers[std::string(name.str())] = given_in(value);
        }
    });
    handed.problem = read.report();
    return handed;
}

Roster read_roster(const fs::path& path) {
    Roster roster;
    const FileText file = read_file_text(path, kLargestRoster);
    if (!file.problem.empty()) {
        roster.problem = path.string() + ": error: " + file.problem + "; expected a list of students (CSV)\n";
        return roster;
    }
    std::istringstream lines(file.text);
    std::set<std::string> known;
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        const std::string student =
            first_field(number == 1 && line.starts_with("\xEF\xBB\xBF") ? line.substr(3) : line);
        if (student.empty() || (number == 1 && is_head(student))) { continue; }
        std::string fault = fault_of_student(student);
        if (fault.empty() && !known.insert(student).second) {
            fault = "student " + in_quotes(student) + " is there twice";
        }
        if (!fault.empty()) {
            roster.problem += path.string() + ":" + std::to_string(number) + ":1: error: " + fault + "\n";
        }
        roster.students.push_back(student);
    }
    if (roster.students.empty() && roster.problem.empty()) {
        roster.problem = path.string() + ": error: there is no student in it; expected one in each line\n";
    }
    return roster;
}

std::string fault_of_student(const std::string& student) {
    const auto fits = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
               c == '_' || c == '.' || c == '@' || c == '+';
    };
    const bool good = !student.empty() && student.size() <= kLongestStudent && student.front() != '.' &&
                      student.front() != '-' && std::ranges::all_of(student, fits);
    return good ? std::string()
                : in_quotes(student) +
                      " cannot be the name of a student; expected up to 80 letters, digits and - _ . @ +";
}

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
    FileRead file;
    read_toml(file, std::move(text), "progress.toml", [&](const toml::table& table, Problems& problems) {
        Fields root(table, "the progress", problems);
        static const std::vector<std::string> kWords{"progress"};
        root.require("format", "format = 1");
        root.integer("format", 1, 1);
        root.require("file", "file = \"progress\"");
        root.word("file", kWords);
        read_records(root, read.records);
        root.finish();
    });
    if (!file.diagnostics.empty()) {
        const Diagnostic& first = file.diagnostics.front();
        read.records.clear();
        read.problem = "line " + std::to_string(first.span.line) + ": " + first.message;
    }
    return read;
}

}  // namespace jw
