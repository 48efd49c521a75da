#pragma once

#include <string>
#include <vector>

#include "app/session/output/describe.hpp"
#include "app/session/output/export.hpp"
#include "app/session/output/json.hpp"
#include "app/session/try/session.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/read/reader.hpp"
#include "tests/app/session/view_numbers.hpp"

/// Shipped lessons for tests of sessions.
namespace jw::test {

inline Lesson shipped(const std::filesystem::path& file) {
    const ReadResult read = read_lesson_file(file);
    if (!read.lesson) { throw std::runtime_error(read.report()); }
    return *read.lesson;
}

/// "loops/four-bar"
inline Lesson lesson_named(const std::string& name) { return shipped(catalogue_folder() / (name + ".toml")); }

inline std::vector<std::filesystem::path> all_lesson_files() { return lessons_below(catalogue_folder()); }

/// The lesson without its motion, which takes time and is not needed by tests of equations.
inline Lesson without_motion(Lesson lesson) {
    lesson.motion.reset();
    lesson.dynamics.reset();  // dynamics are a motion, too
    lesson.step_texts.times.clear();
    return lesson;
}

/// Text of a whole story, every number with all digits.
inline std::string told(const Story& story) {
    return json_of(story, static_cast<int>(story.steps().size()) - 1).dump();
}

/// Text of a view; matrix, Newton table and singular values with all digits.
inline std::string shown(const Session& session) {
    const View& view = session.view();
    return describe(view) + matrix_csv(view.matrix) + numbers_of(view);
}

/// Lessons of all kinds of joints and drivers, small enough to be told often.
inline const std::vector<std::string>& few_lessons() {
    static const std::vector<std::string> names{"loops/four-bar",   "loops/rssr",       "joints/screw",
                                                "joints/prismatic", "joints/universal", "hard/forced-drop"};
    return names;
}

}  // namespace jw::test
