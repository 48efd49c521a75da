#include "lessons/reader.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "lessons/reading.hpp"

namespace jw {

namespace reading {

std::vector<std::string> Reading::body_names() const {
    std::vector<std::string> names;
    for (const Body& body : lesson.mechanism.bodies) { names.push_back(body.name); }
    return names;
}

std::vector<std::string> Reading::joint_names() const {
    std::vector<std::string> names;
    for (const Joint& joint : lesson.mechanism.joints) { names.push_back(joint.name); }
    return names;
}

namespace {

std::optional<int> find_name(
    const Located<std::string>& name, const std::vector<std::string>& names, const char* what,
    Problems& problems) {
    const auto found = std::ranges::find(names, name.value);
    if (found != names.end()) { return static_cast<int>(found - names.begin()); }
    problems.add(
        name.span,
        "unknown " + std::string(what) + " '" + name.value + "'; expected one of " + comma_list(names),
        did_you_mean(name.value, names));
    return std::nullopt;
}

}  // namespace

std::optional<int> Reading::body(const Located<std::string>& name) const {
    return find_name(name, body_names(), "body", *problems);
}

std::optional<int> Reading::joint(const Located<std::string>& name) const {
    return find_name(name, joint_names(), "joint", *problems);
}

namespace {

constexpr int kFormat = 1;

void read_head(Fields& root, Lesson& lesson) {
    const auto format = root.integer("format");
    if (!root.has("format")) { root.missing("format", "format = 1 as the first key"); }
    if (format && format->value != kFormat) {
        root.problems().add(
            format->span, "format " + std::to_string(format->value) + " is not known; expected format = 1");
    }
    const auto title = root.text("title");
    if (!root.has("title")) { root.missing("title", "what the lesson is called"); }
    const auto take = [&](const char* key, std::string& into) {
        if (const auto text = root.text(key)) { into = text->value; }
    };
    if (title) { lesson.title = title->value; }
    take("chapter", lesson.chapter);
    take("source", lesson.source);
    take("text", lesson.text);
    while (lesson.text.ends_with('\n')) { lesson.text.pop_back(); }
    const auto choice = root.word("coordinates", {"rp", "rp-modified", "omega-local", "omega-global"});
    if (choice) { lesson.coordinates = static_cast<CoordinateChoice>(*choice); }
}

void read_motion(Fields& root, Lesson& lesson) {
    auto fields = root.table("motion");
    if (!fields) { return; }
    MotionPlan plan;
    if (const auto from = fields->number("from_s")) { plan.from = from->value; }
    const auto to = fields->number("to_s");
    if (!fields->has("to_s")) { fields->missing("to_s", "the time at which the motion ends"); }
    if (to) {
        plan.to = to->value;
        if (plan.to <= plan.from) {
            root.problems().add(to->span, "the motion ends before it starts; expected 'to_s' above 'from_s'");
        }
    }
    plan.duration = plan.to - plan.from;
    if (const auto duration = fields->positive("duration_s")) { plan.duration = duration->value; }
    if (const auto steps = fields->integer("steps")) {
        plan.steps = steps->value;
        if (plan.steps < 1 || plan.steps > 100000) {
            root.problems().add(steps->span, "'steps' is out of range; expected 1 to 100000");
        }
    }
    fields->finish();
    lesson.motion = plan;
}

void read_camera(Fields& root, Lesson& lesson) {
    auto fields = root.table("camera");
    if (!fields) { return; }
    if (const auto from = fields->direction("from")) { lesson.camera.from = from->value.normalized(); }
    if (const auto target = fields->vector("target")) { lesson.camera.target = target->value; }
    if (const auto distance = fields->positive("distance")) { lesson.camera.distance = distance->value; }
    if (const auto up = fields->direction("up")) { lesson.camera.up = up->value.normalized(); }
    if (const auto flat = fields->flag("orthographic")) { lesson.camera.orthographic = flat->value; }
    fields->finish();
    const Vec3 up = lesson.camera.up.value_or(Vec3::UnitZ());
    if (lesson.camera.from && lesson.camera.from->cross(up).norm() < 1e-3) {
        root.problems().add(
            fields->span("from"), "the camera looks along 'up'; expected another direction",
            "give 'up' as well, for example up = [0, 1, 0]");
    }
}

/// The order that the author wants: names of joints and drivers; what is not named follows.
void read_order(Fields& root, Lesson& lesson) {
    const auto names = root.texts("order");
    if (!names) { return; }
    const auto name_of = [&](const Addition& a) {
        const auto k = static_cast<std::size_t>(a.index);
        return a.kind == Addition::Kind::joint ? lesson.mechanism.joints[k].name
                                               : lesson.mechanism.drivers[k].name;
    };
    std::vector<std::string> known;
    for (const Addition& a : lesson.order) { known.push_back(name_of(a)); }
    std::vector<Addition> order;
    for (const auto& name : names->value) {
        const auto found = std::ranges::find(lesson.order, name.value, name_of);
        if (found == lesson.order.end()) {
            root.problems().add(
                name.span, "no joint or driver '" + name.value + "'; expected one of " + comma_list(known),
                did_you_mean(name.value, known));
        } else if (std::ranges::find(order, *found) != order.end()) {
            root.problems().add(name.span, "'" + name.value + "' is there twice; expected each name once");
        } else {
            order.push_back(*found);
        }
    }
    for (const Addition& a : lesson.order) {
        if (std::ranges::find(order, a) == order.end()) { order.push_back(a); }
    }
    lesson.order = order;
}

void read_steps(Fields& root, Reading& reading) {
    StepTexts& texts = reading.lesson.step_texts;
    for (Fields& fields : root.tables("step")) {
        const auto at = fields.text("at");
        const auto at_s = fields.number("at_s");
        const auto text = fields.text("text");
        if (!fields.has("text")) { fields.missing("text", "the words to show"); }
        if (!fields.has("at") && !fields.has("at_s")) {
            fields.missing("at", "\"bodies\", \"motion\", a joint or a driver, or 'at_s' for a time");
        }
        fields.finish();
        if (!text) { continue; }
        if (at_s) { texts.times.push_back({at_s->value, text->value}); }
        if (!at) { continue; }
        if (at->value == "bodies") {
            texts.bodies = text->value;
            continue;
        }
        if (at->value == "motion") {
            texts.motion = text->value;
            continue;
        }
        const Mechanism& m = reading.lesson.mechanism;
        const auto joint = std::ranges::find(m.joints, at->value, &Joint::name);
        const auto driver = std::ranges::find(m.drivers, at->value, &Driver::name);
        if (joint != m.joints.end()) {
            texts.joints[static_cast<std::size_t>(joint - m.joints.begin())] = text->value;
        } else if (driver != m.drivers.end()) {
            texts.drivers[static_cast<std::size_t>(driver - m.drivers.begin())] = text->value;
        } else {
            reading.problems->add(
                at->span,
                "no step '" + at->value + "'; expected bodies, motion, or the name of a joint or driver");
        }
    }
    std::ranges::sort(texts.times, {}, &StepTexts::AtTime::from);
}

Lesson read_root(const toml::table& table, Problems& problems) {
    Reading reading;
    reading.problems = &problems;
    Fields root(table, "the lesson", problems);
    read_head(root, reading.lesson);
    read_motion(root, reading.lesson);
    read_camera(root, reading.lesson);
    read_bodies(root, reading);
    read_joints(root, reading);
    read_drivers(root, reading);
    read_order(root, reading.lesson);
    read_claims(root, reading);
    read_steps(root, reading);
    root.finish();
    return std::move(reading.lesson);
}

}  // namespace
}  // namespace reading

namespace {

constexpr std::size_t kLargestFile = 10U << 20U;
constexpr std::size_t kMostReported = 50;

}  // namespace

std::string ReadResult::report() const {
    std::string text;
    for (std::size_t k = 0; k < std::min(kMostReported, diagnostics.size()); ++k) {
        text += to_string(diagnostics[k], source);
    }
    if (diagnostics.size() > kMostReported) {
        text += "... and " + std::to_string(diagnostics.size() - kMostReported) + " more errors\n";
    }
    return text;
}

ReadResult read_lesson(std::string source, std::string file_name) {
    ReadResult result;
    result.source = std::move(source);
    Problems problems(file_name, result.source);
    try {
        const toml::table table = toml::parse(result.source, file_name);
        Lesson lesson = reading::read_root(table, problems);
        if (problems.empty()) {
            lesson.file_name = file_name;
            result.lesson = std::move(lesson);
        }
    } catch (const toml::parse_error& error) {
        const SourceSpan span{
            static_cast<int>(error.source().begin.line), static_cast<int>(error.source().begin.column), 1};
        problems.add(span, "this is not TOML: " + std::string(error.description()));
    }
    result.diagnostics = problems.take();
    return result;
}

ReadResult read_lesson_file(const std::filesystem::path& path) {
    const auto fail = [&](const std::string& message) {
        ReadResult result;
        result.diagnostics.push_back({path.string(), {}, message, {}});
        return result;
    };
    std::error_code error;
    if (!std::filesystem::exists(path, error)) {
        return fail("there is no such file; expected a lesson (.toml)");
    }
    if (std::filesystem::is_directory(path, error)) {
        return fail("this is a folder; expected a lesson (.toml)");
    }
    if (std::filesystem::file_size(path, error) > kLargestFile && !error) {
        return fail("the file is larger than 10 MB; expected a lesson");
    }
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream) { return fail("the file cannot be read; expected a lesson (.toml)"); }
    return read_lesson(text.str(), path.string());
}

std::vector<std::filesystem::path> lessons_below(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, error)) {
        if (entry.is_regular_file() && entry.path().extension() == ".toml") { files.push_back(entry.path()); }
    }
    std::ranges::sort(files);
    return files;
}

}  // namespace jw
