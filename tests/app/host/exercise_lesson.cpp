#include "tests/app/host/exercise_lesson.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "lessons/files/catalogue.hpp"

namespace jw::test {

namespace {

struct Chosen {
    const char* kind;
    const char* file;
    const char* name;
};
constexpr std::array kChosen{Chosen{"number", "vectors.toml", "n1-value"},
                             Chosen{"vector", "vectors.toml", "global-vector"},
                             Chosen{"matrix", "vectors.toml", "skew-matrix"},
                             Chosen{"pose", "orientation.toml", "pose-of-gate"},
                             Chosen{"choose", "vectors.toml", "n2-which"},
                             Chosen{"order", "vectors.toml", "proof-order"},
                             Chosen{"code", "jacobians.toml", "n1-row-code"},
                             Chosen{"repair", "clinic.toml", "tilted-axis"},
                             Chosen{"build", "building.toml", "hang-a-door"},
                             Chosen{"experiment", "experiments.toml", "best-condition"}};

constexpr const char* kLesson = R"(format = 1
title = "A hinge with exercises"
source = "slide 3"

[[body]]
name = "arm"

[[joint]]
name = "hinge"
type = "revolute"
bodies = ["ground", "arm"]
at = [0, 0, 0]
axis = [0, 0, 1]

)";

void replace_all(std::string& text, const std::string& what, const std::string& by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
        text.replace(at, what.size(), by);
    }
}

/// The table of an exercise as it stands in its file.
std::string table_of(const std::filesystem::path& folder, const Chosen& chosen) {
    std::ifstream stream(folder / chosen.file);
    std::ostringstream all;
    all << stream.rdbuf();
    const std::string text = all.str();
    const std::string head = "[[exercise]]\nname = \"" + std::string(chosen.name) + "\"\n";
    const std::size_t from = text.find(head);
    if (from == std::string::npos) { throw std::runtime_error(std::string("no exercise ") + chosen.name); }
    std::string table = text.substr(from, text.find("\n[[exercise]]\n", from) - from);
    replace_all(table, "scene = \"scenes/", "scene = \"" + (folder / "scenes").string() + "/");
    replace_all(
        table, "name = \"" + std::string(chosen.name) + "\"", "name = \"" + std::string(chosen.kind) + "\"");
    // an exercise within a lesson belongs to that lesson
    const std::size_t key = table.find("\nlesson = ");
    if (key != std::string::npos) { table.erase(key, table.find('\n', key + 1) - key); }
    return table + "\n";
}

}  // namespace

std::string lesson_with_exercises() {
    const std::filesystem::path folder = catalogue_folder().parent_path() / "exercises";
    std::string text = kLesson;
    for (const Chosen& chosen : kChosen) { text += table_of(folder, chosen); }
    return text;
}

}  // namespace jw::test
