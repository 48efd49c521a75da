#include <algorithm>

#include "lessons/fields/member_keys.hpp"
#include "lessons/format/scene_keys.hpp"
#include "lessons/lesson/enum_words.hpp"
#include "lessons/typed/typed.hpp"
#include "lessons/write/writing.hpp"

namespace jw::writing {

namespace {

void write_order(const Written& written, Lines& lines) {
    const auto is_driver = [](const Addition& a) { return a.kind == Addition::Kind::driver; };
    std::vector<Addition> as_in_file = written.order;
    std::ranges::sort(as_in_file, {}, [&](const Addition& a) { return std::pair(is_driver(a), a.index); });
    if (as_in_file == written.order) { return; }
    const auto name = [&](const Addition& addition) { return string_text(written.name_of(addition)); };
    lines.key("order", list_text(written.order, name));
}

void write_step(const std::string& at, const Text& text, Lines& lines) {
    if (text.own().empty()) { return; }
    lines.table("[[step]]");
    lines.key("at", string_text(at));
    lines.words("text", text);
}

}  // namespace

void write_head(const Written& written, Lines& lines) {
    const Lesson& lesson = *written.lesson;
    lines.key("format", "1");
    lines.words("title", lesson.title);
    if (!lesson.chapter.empty()) { lines.key("chapter", words_text(lesson.chapter)); }
    if (!lesson.source.empty()) { lines.key("source", words_text(lesson.source)); }
    if (!lesson.text.own().empty()) { lines.words("text", lesson.text); }
    if (!lesson.summary.own().empty()) { lines.words("summary", lesson.summary); }
    write_order(written, lines);
    if (lesson.coordinates != Lesson().coordinates) {
        lines.key("coordinates", string_text(word_of(kChoices, lesson.coordinates)));
    }
}

void write_precision(const Precision& precision, Lines& lines) {
    if (precision == Precision()) { return; }
    lines.table("[precision]");
    write_members(format::kPrecision, precision, lines);
}

void write_motion(const Lesson& lesson, Lines& lines) {
    if (!lesson.motion) { return; }
    const MotionPlan& plan = *lesson.motion;
    lines.table("[motion]");
    if (plan.from != 0.0) { lines.key("from_s", plan.from); }
    lines.key("to_s", plan.to);
    if (plan.duration != plan.to - plan.from) { lines.key("duration_s", plan.duration, "on the screen"); }
    lines.key("steps", std::to_string(plan.steps));
}

void write_camera(const Lesson& lesson, Lines& lines) {
    const CameraWish& camera = lesson.camera;
    if (!camera.from && !camera.target && !camera.distance && !camera.up && !camera.orthographic) { return; }
    lines.table("[camera]");
    write_members(format::kCamera, camera, lines);
}

void write_steps(const Lesson& lesson, Lines& lines) {
    write_step("bodies", lesson.step_texts.bodies, lines);
    write_step("motion", lesson.step_texts.motion, lines);
    for (const StepTexts::AtTime& text : lesson.step_texts.times) {
        lines.table("[[step]]");
        lines.key("at_s", text.from);
        lines.words("text", text.text);
    }
}

}  // namespace jw::writing
