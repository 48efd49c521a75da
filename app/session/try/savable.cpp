#include "app/session/try/savable.hpp"

#include <algorithm>
#include <stdexcept>

#include "app/session/wording/messages.hpp"
#include "lessons/read/reader.hpp"
#include "lessons/write/writer.hpp"

namespace jw {

namespace {

/// The first error in the file that the lesson would become; empty if there is none.
std::string mistake_in(const Lesson& lesson) {
    try {
        const ReadResult read = read_lesson(lesson_text(lesson), lesson.file_name);
        if (read.lesson) { return {}; }
        return std::ranges::find(read.diagnostics, Severity::error, &Diagnostic::severity)->message;
    } catch (const std::invalid_argument& error) { return error.what(); }
}

}  // namespace

std::string why_not_savable(const Lesson& changed, const Lesson& before) {
    const std::string mistake = mistake_in(changed);
    if (mistake.empty() || !mistake_in(before).empty()) { return {}; }
    return tr("this cannot be written as a lesson: {0}", mistake);
}

}  // namespace jw
