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

/// Calls visit(key, member) for each member.
template <class Exercise, class Visit>
void for_each_member(Exercise& e, const Visit& visit) {
    visit("name", e.name);
    visit("title", e.title);
    visit("points", e.points);
    visit("earned", e.earned);
    visit("handed_in", e.handed_in);
    visit("not_run", e.not_run);
    visit("understood", e.judged.understood);
    visit("right", e.judged.right);
    visit("share", e.judged.share);
    visit("mistake", e.judged.mistake);
    visit("mistake_title", e.judged.title);
    visit("slide", e.judged.slide);
    visit("feedback", e.judged.feedback);
}

Json json_of_exercise(const ExerciseGrade& e) {
    Json json;
    for_each_member(e, [&](const char* key, const auto& member) { json[key] = member; });
    return json;
}

ExerciseGrade exercise_in(const Json& json) {
    ExerciseGrade e;
    for_each_member(e, [&](const char* key, auto& member) { json.at(key).get_to(member); });
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
