#include <iostream>

#include "lessons/write/writer.hpp"
#include "tests/support/dynamics_scenes.hpp"

/// Writes the lessons of dynamics that the program ships: ./dev scenes.
int main() {
    for (const auto& [path, lesson] : jw::test::dynamics_scene_files()) {
        const std::filesystem::path file = std::filesystem::path(JW_SOURCE_ROOT) / "lessons" / path;
        std::filesystem::create_directories(file.parent_path());
        std::string error;
        if (!jw::write_lesson_file(file, jw::lesson_text(lesson), error)) {
            std::cerr << error << '\n';
            return 1;
        }
        std::cout << file.string() << '\n';
    }
    return 0;
}
