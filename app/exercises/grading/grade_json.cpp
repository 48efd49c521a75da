#include <algorithm>
#include <vector>

#include "app/exercises/grading/grade.hpp"
#include "app/exercises/grading/plain_file.hpp"
#include "app/exercises/random.hpp"
#include "app/session/output/json.hpp"

namespace jw {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostFiles = 2000;
constexpr std::size_t kLargestFile = 2U << 20U;

Json json_of_exercise(const ExerciseGrade& e) {
    return {
        {"name", e.name},
        {"title", e.title},
        {"points", e.points},
        {"earned", e.earned},
        {"handed_in", e.handed_in},
        {"not_run", e.not_run},
        {"understood", e.judged.understood},
        {"right", e.judged.right},
        {"share", e.judged.share},
        {"mistake", e.judged.mistake},
        {"mistake_title", e.judged.title},
        {"slide", e.judged.slide},
        {"feedback", e.judged.feedback}};
}

ExerciseGrade exercise_in(const Json& json) {
    ExerciseGrade e;
    e.name = json.at("name");
    e.title = json.at("title");
    e.points = json.at("points");
    e.earned = json.at("earned");
    e.handed_in = json.at("handed_in");
    e.not_run = json.at("not_run");
    e.judged.understood = json.at("understood");
    e.judged.right = json.at("right");
    e.judged.share = json.at("share");
    e.judged.mistake = json.at("mistake");
    e.judged.title = json.at("mistake_title");
    e.judged.slide = json.at("slide");
    e.judged.feedback = json.at("feedback").get<std::vector<std::string>>();
    return e;
}

}  // namespace

std::string json_text(const Grade& grade) {
    Json exercises = Json::array();
    for (const ExerciseGrade& e : grade.exercises) { exercises.push_back(json_of_exercise(e)); }
    const Json json{{"submission", grade.submission}, {"student", grade.student},
                    {"problem", grade.problem},       {"points", grade.points()},
                    {"earned", grade.earned()},       {"exercises", std::move(exercises)}};
    return json_document(json, 2);
}

std::string json_text(const ExerciseGrade& grade) { return json_document(json_of_exercise(grade), 2); }

bool read_grade(const std::string& text, ExerciseGrade& grade) {
    const Json json = Json::parse(text, nullptr, false);
    try {
        grade = exercise_in(json);
        return true;
    } catch (const Json::exception&) { return false; }
}

bool read_grade(const std::string& text, Grade& grade) {
    const Json json = Json::parse(text, nullptr, false);
    try {
        grade = {};
        grade.submission = json.at("submission");
        grade.student = json.at("student");
        grade.problem = json.at("problem");
        for (const Json& e : json.at("exercises")) { grade.exercises.push_back(exercise_in(e)); }
        return true;
    } catch (const Json::exception&) { return false; }
}

std::string digest_of(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> files;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        if (files.size() < kMostFiles) { files.push_back(entry->path()); }
    }
    if (error) { return {}; }
    std::ranges::sort(files);
    std::uint64_t digest = 1;
    for (const fs::path& file : files) {
        const PlainFile read = read_plain_file(file, kLargestFile);
        digest = seed_of(std::to_string(digest), file.filename().string(), read.problem + read.text);
    }
    return std::to_string(digest);
}

}  // namespace jw
