#include "lessons/read/reader.hpp"
#include "lessons/write/writer.hpp"
#include "tests/fuzz/diagnostics.hpp"
#include "tests/fuzz/targets.hpp"
#include "tests/lessons/lesson_difference.hpp"
#include "tests/support/sound_lesson.hpp"

namespace jw::fuzz {

bool check_lesson(const std::string& input) {
    const ReadResult read = read_lesson(input, "input.toml");
    promise_places(read.diagnostics, read.source);
    promise(
        read.lesson.has_value() != has_error(read.diagnostics),
        "a lesson or an error, never both:\n" + read.report());
    if (!read.lesson) { return false; }
    promise(test::is_sound(*read.lesson), "a lesson that was read is sound");
    const ReadResult again = read_lesson(lesson_text(*read.lesson), "written.toml");
    promise(again.lesson.has_value(), "what is written can be read:\n" + again.report());
    const std::string difference = test::first_difference(*read.lesson, *again.lesson);
    promise(difference.empty(), "what is written reads the same: " + difference);
    return true;
}

}  // namespace jw::fuzz
