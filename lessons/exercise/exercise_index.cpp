#include "lessons/exercise/exercise_index.hpp"

#include <algorithm>
#include <iterator>

#include "lessons/fields/fields.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/files/file_text.hpp"

namespace jw {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kLargestIndexed = 2U << 20U;

}  // namespace

std::string lesson_name(const fs::path& file) {
    std::error_code error;
    const fs::path whole = fs::absolute(file, error).lexically_normal();
    return (whole.parent_path().filename() / whole.stem()).generic_string();
}

std::vector<std::string> names_of_lessons() {
    std::vector<std::string> names;
    for (const fs::path& file : lessons_below(catalogue_folder())) { names.push_back(lesson_name(file)); }
    std::ranges::sort(names);
    return names;
}

std::vector<IndexedExercise> exercises_named_in(const fs::path& file) {
    std::error_code error;
    // a pipe can be read only once
    if (!fs::is_regular_file(file, error)) { return {}; }
    FileText read = read_file_text(file, kLargestIndexed);
    // most lessons have no exercise: parsing them all would cost as much as reading them
    if (read.text.find("exercise") == std::string::npos) { return {}; }
    Problems problems(file.string(), read.text);
    const auto table = parse_toml(read.text, problems);
    const toml::array* const list = table ? (*table)["exercise"].as_array() : nullptr;
    if (list == nullptr) { return {}; }
    const bool in_lesson = table->contains("body") || table->contains("joint");
    std::vector<IndexedExercise> found;
    for (const toml::node& node : *list) {
        const toml::table* const exercise = node.as_table();
        if (exercise == nullptr || !(*exercise)["name"].is_string()) { continue; }
        const std::string lesson = (*exercise)["lesson"].value_or(std::string());
        found.push_back(
            {file, (*exercise)["name"].value_or(std::string()), in_lesson ? lesson_name(file) : lesson});
    }
    return found;
}

std::vector<fs::path> exercise_files_in(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        if (entry.path().extension() == ".toml" && entry.is_regular_file(error)) {
            files.push_back(entry.path());
        }
    }
    std::ranges::sort(files);
    return files;
}

std::vector<fs::path> exercise_files_of(const fs::path& lessons_folder) {
    std::error_code error;
    const fs::path whole = fs::absolute(lessons_folder, error).lexically_normal();
    // "lessons/" ends with an empty name
    const fs::path folder = whole.has_filename() ? whole : whole.parent_path();
    fs::path exercises = folder.parent_path() / kExercisesFolder;
    // a chapter is a folder of the catalogue
    if (!fs::is_directory(exercises, error)) {
        exercises = folder.parent_path().parent_path() / kExercisesFolder;
    }
    return exercise_files_in(exercises);
}

std::vector<IndexedExercise> exercises_of_course(const fs::path& lessons_folder) {
    std::vector<IndexedExercise> all;
    std::vector<fs::path> files = exercise_files_of(lessons_folder);
    std::ranges::move(lessons_below(lessons_folder), std::back_inserter(files));
    for (const fs::path& file : files) {
        std::ranges::move(exercises_named_in(file), std::back_inserter(all));
    }
    return all;
}

std::vector<IndexedExercise> exercises_of_lesson(
    const std::vector<IndexedExercise>& exercises, const std::string& lesson) {
    std::vector<IndexedExercise> found;
    std::ranges::copy_if(exercises, std::back_inserter(found), [&](const IndexedExercise& exercise) {
        return exercise.lesson == lesson;
    });
    return found;
}

}  // namespace jw
