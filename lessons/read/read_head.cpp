#include "lessons/fields/member_keys.hpp"
#include "lessons/format/scene_keys.hpp"
#include "lessons/read/reading.hpp"
#include "lessons/typed/exact_text.hpp"

namespace jw::reading {

namespace {

// a camera that looks along `up` within this does not have an upright picture (0.06 deg)
constexpr double kAlongUp = 1e-3;

}  // namespace

void read_head(Fields& root, Lesson& lesson) {
    if (const auto title = root.plain_words("title")) { lesson.title = title->value; }
    root.require("title", "the title of the lesson");
    if (const auto chapter = root.text("chapter")) { lesson.chapter = chapter->value; }
    if (const auto source = root.text("source")) { lesson.source = source->value; }
    for (std::string* text : {&lesson.chapter, &lesson.source}) {
        while (text->ends_with('\n')) { text->pop_back(); }
    }
    if (const auto words = root.words("text")) { lesson.text = words->value; }
    if (const auto words = root.words("summary")) { lesson.summary = words->value; }
    for (Text* text : {&lesson.title, &lesson.text, &lesson.summary}) { text->drop_line_feeds(); }
    lesson.coordinates = root.word("coordinates", kChoices).value_or(lesson.coordinates);
}

void read_motion(Fields& root, Lesson& lesson) {
    auto fields = root.table("motion");
    if (!fields) { return; }
    MotionPlan plan;
    if (const auto from = fields->number("from_s")) { plan.from = from->value; }
    fields->require("to_s");
    if (const auto to = fields->number("to_s")) {
        plan.to = to->value;
        if (plan.to <= plan.from) {
            const int digits = writing::digits_apart(plan.to, plan.from, 6);
            root.report(
                Code::ends_before_start, to->span,
                "the motion ends at " + short_number(plan.to, digits) + " s and starts at " +
                    short_number(plan.from, digits) + " s; expected 'to_s' above 'from_s'");
        }
    }
    plan.duration = plan.to - plan.from;
    if (const auto duration = fields->positive("duration_s")) { plan.duration = duration->value; }
    if (const auto steps = fields->integer("steps")) { plan.steps = steps->value; }
    fields->finish();
    lesson.motion = plan;
}

void read_camera(Fields& root, Lesson& lesson) {
    auto fields = root.table("camera");
    if (!fields) { return; }
    CameraWish& camera = lesson.camera;
    read_members(*fields, format::kCamera, camera);
    fields->finish();
    if (camera.from && camera.from->cross(camera.up.value_or(Vec3::UnitZ())).norm() < kAlongUp) {
        root.report(
            Code::camera_along_up, fields->span("from"),
            "the camera looks along 'up'; expected another direction",
            camera.up ? "" : "'up' is z; give another one, for example up = [0, 1, 0]");
    }
}

}  // namespace jw::reading
