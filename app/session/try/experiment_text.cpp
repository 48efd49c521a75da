#include "app/session/try/experiment_text.hpp"

#include <algorithm>

#include "app/session/wording/labels.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/lesson/enum_words.hpp"
#include "lessons/lesson/things.hpp"
#include "lessons/typed/exact_text.hpp"
#include "lessons/typed/typed.hpp"

namespace jw {

namespace experiment_text {

template <class Part>
std::vector<std::string> names_in(const std::vector<Part>& parts) {
    std::vector<std::string> names;
    for (const Part& part : parts) { names.push_back(part.name); }
    return names;
}

std::vector<std::string> names_of_joints(const Lesson& lesson) { return names_in(lesson.mechanism.joints); }

std::vector<std::string> names_of_drivers(const Lesson& lesson) { return names_in(lesson.mechanism.drivers); }

}  // namespace experiment_text

namespace {

using namespace experiment_text;

/// Joints, then drivers: their names all differ.
std::vector<std::string> names_of_parts(const Lesson& lesson) {
    std::vector<std::string> names = names_of_joints(lesson);
    std::ranges::copy(names_of_drivers(lesson), std::back_inserter(names));
    return names;
}

std::vector<std::string> names_of_bodies(const Lesson& lesson) { return names_in(lesson.mechanism.bodies); }

Addition part_of(const Lesson& lesson, std::size_t index) {
    const std::size_t joints = lesson.mechanism.joints.size();
    const bool is_joint = index < joints;
    return {
        is_joint ? Addition::Kind::joint : Addition::Kind::driver,
        static_cast<int>(is_joint ? index : index - joints)};
}

std::string part_name(const Lesson& lesson, const Addition& part) {
    const auto k = at(part.index);
    const std::string& name = part.kind == Addition::Kind::joint ? lesson.mechanism.joints.at(k).name
                                                                 : lesson.mechanism.drivers.at(k).name;
    return quoted_name(name, names_of_parts(lesson));
}

/// The joint's equations in the form that it has. For a pair, the full equations of p1 and p2 follow: some of
/// them may have been taken out before.
std::vector<LabelledEquation> equations_of(const Joint& joint) {
    std::vector<LabelledEquation> all = equations_of(*joint.type, joint.parallel_form);
    if (joint.parallel_form == ParallelForm::pair) {
        std::ranges::copy_if(
            equations_of(*joint.type, ParallelForm::rule), std::back_inserter(all),
            [](const LabelledEquation& one) { return is_parallel(one.equation.role); });
    }
    return all;
}

Experiment read_presence(Words& words, const Lesson& lesson, bool present) {
    const std::size_t index = words.name(names_of_parts(lesson), "joint or driver");
    const Addition part = part_of(lesson, index);
    if (words.done()) { return SetPresent{part, present}; }
    if (part.kind == Addition::Kind::driver) { words.finish(); }
    const Joint& joint = lesson.mechanism.joints[index];
    const std::vector<LabelledEquation> all = equations_of(joint);
    std::vector<std::string> labels;
    for (const LabelledEquation& one : all) { labels.push_back(one.label); }
    if (words.rest() == "theta") { words = Words("θ"); }
    return SetEquationPresent{part.index, all[words.last_word(labels, "equation")].equation, present};
}

Experiment read_form(Words& words, const Lesson& lesson) {
    const auto joint = static_cast<int>(words.name(names_of_joints(lesson), "joint"));
    return SetParallelForm{joint, kParallelForms[words.last_word(words_of(kParallelForms), "form")].value};
}

Experiment read_screw(Words& words, const Lesson& lesson) {
    const auto joint = static_cast<int>(words.name(names_of_joints(lesson), "joint"));
    return SetScrewAngleForm{joint, kAngleRows[words.last_word(words_of(kAngleRows), "angle row")].value};
}

Experiment read_coordinates(Words& words) {
    if (words.take("rp-true")) { return SetCoordinates{CoordinateChoice::true_euler_parameters}; }
    return SetCoordinates{kChoices[words.last_word(words_of(kChoices), "choice")].value};
}

Experiment read_pose(Words& words, const Lesson& lesson) {
    const std::size_t index = words.name(names_of_bodies(lesson), "body");
    const Body& body = lesson.mechanism.bodies[index];
    SetPose pose{static_cast<int>(index), body.r, body.p};
    const bool at = words.take("at");
    if (at) { pose.r = words.vector("a coordinate [m]"); }
    const bool turned = words.take("turned");
    if (turned) {
        for (double& e : pose.p) { e = words.number("one of four Euler parameters"); }
    }
    if (!at && !turned) {
        throw Unreadable(
            "expected 'at' and three numbers [m] or 'turned' and four Euler parameters, for example: "
            "at 0 0 1 turned 1 0 0 0");
    }
    return pose;
}

Experiment read_drag(Words& words, const Session& session) {
    const auto body = words.name(names_of_bodies(session.lesson()), "body");
    Drag drag{static_cast<int>(body), Vec3::Zero(), Vec3::Zero()};
    if (words.take("at")) { drag.point_local = words.vector("a coordinate of the point [m]"); }
    const bool by = words.take("by");
    if (!by && !words.take("to")) {
        throw Unreadable("expected 'by' or 'to' and three numbers [m], for example: by 0 0 0.1");
    }
    drag.target = words.vector("a coordinate [m]");
    if (by) {
        const State& state = session.step().state;
        drag.target += state.r[body] + rotation_matrix(state.p[body]) * drag.point_local;
        if (drag.target.cwiseAbs().maxCoeff() > kLargestNumber) {
            throw Unreadable("that leads too far away; expected a place of at most 1e9 in magnitude [m]");
        }
    }
    return drag;
}

/// The last step about a joint or driver: where it is closed.
int closed_step_of(const Session& session, const Addition& part) {
    const std::vector<Step>& steps = session.story().steps();
    for (auto k = static_cast<int>(steps.size()) - 1; k >= 0; --k) {
        const Step& step = steps[at(k)];
        if (step.kind == Step::Kind::motion || is_asked(step.kind)) { continue; }
        if (subject_of(session.lesson(), step) == part) { return k; }
    }
    throw Unreadable(part_name(session.lesson(), part) + " is not reached in this lesson");
}

Experiment read_place(Words& words, const Session& session) {
    if (words.take("step")) {
        const int step = words.integer("a step, counted from 0");
        const auto last = static_cast<int>(session.story().steps().size()) - 1;
        if (step < 0 || step > last) {
            throw Unreadable(
                "no step " + std::to_string(step) + "; the lesson has steps 0 to " + std::to_string(last));
        }
        return GoTo{step};
    }
    if (words.take("time")) {
        const double t = words.number("a time [s]");
        words.take("s");
        return GoTo{session.index_of_time(t)};
    }
    const std::size_t part = words.name(names_of_parts(session.lesson()), "joint or driver");
    return GoTo{closed_step_of(session, part_of(session.lesson(), part))};
}

Experiment read_freedom(Words& words) {
    ShowFreedom experiment;
    experiment.motion = words.integer("the number of a free motion, counted from 1") - 1;
    experiment.part = words.done() ? 1.0 : words.number("how far, from -1 to 1");
    return experiment;
}

const std::vector<std::string>& beginnings() {
    static const std::vector<std::string> all{"form",       "screw",    "coordinates", "take out", "put back",
                                              "axis",       "point",    "length",      "driver",   "place",
                                              "drag",       "follow",   "go to",       "undo",     "redo",
                                              "start over", "geometry", "release",     "let go"};
    return all;
}

/// Experiment that edits the lesson; nothing if the words begin another one.
std::optional<Experiment> edit_in(Words& words, const Lesson& lesson) {
    if (words.take("form")) { return read_form(words, lesson); }
    if (words.take("screw")) { return read_screw(words, lesson); }
    if (words.take("coordinates")) { return read_coordinates(words); }
    if (words.take("take out")) { return read_presence(words, lesson, false); }
    if (words.take("put back")) { return read_presence(words, lesson, true); }
    if (words.take("axis")) { return read_axis(words, lesson); }
    if (words.take("point")) { return read_point(words, lesson); }
    if (words.take("length")) { return read_length(words, lesson); }
    if (words.take("geometry")) { return read_geometry(words, lesson); }
    if (words.take("driver")) { return read_driver(words, lesson); }
    if (words.take("place")) { return read_pose(words, lesson); }
    return std::nullopt;
}

Experiment read_any(Words& words, const Session& session) {
    if (const std::optional<Experiment> edit = edit_in(words, session.lesson())) { return *edit; }
    if (words.take("drag")) { return read_drag(words, session); }
    if (words.take("follow")) { return read_freedom(words); }
    if (words.take("go to")) { return read_place(words, session); }
    if (words.take("undo")) { return Undo{}; }
    if (words.take("redo")) { return Redo{}; }
    if (words.take("start over")) { return StartOver{}; }
    if (words.take("release")) { return Release{}; }
    if (words.take("let go")) { return LetGo{}; }
    words.name(beginnings(), "experiment");
    throw Unreadable("expected one of " + comma_list(beginnings()));
}

struct Teller {
    const Lesson& lesson;

    std::string joint(int index) const {
        const std::vector<std::string> names = names_of_joints(lesson);
        return quoted_name(names.at(at(index)), names);
    }

    std::string operator()(const GoTo& a) const { return "go to step " + std::to_string(a.step); }
    std::string operator()(const SetParallelForm& a) const {
        return "form " + joint(a.joint) + " " + word_of(kParallelForms, a.form);
    }
    std::string operator()(const SetScrewAngleForm& a) const {
        return "screw " + joint(a.joint) + " " + word_of(kAngleRows, a.form);
    }
    std::string operator()(const SetCoordinates& a) const {
        return std::string("coordinates ") + name_of_choice(a.choice);
    }
    std::string operator()(const SetPresent& a) const {
        return (a.present ? "put back " : "take out ") + part_name(lesson, a.what);
    }
    std::string operator()(const SetEquationPresent& a) const {
        const std::vector<LabelledEquation> all = equations_of(lesson.mechanism.joints.at(at(a.joint)));
        const auto found = std::ranges::find(all, a.equation, &LabelledEquation::equation);
        return (a.present ? "put back " : "take out ") + part_name(lesson, {Addition::Kind::joint, a.joint}) +
               " " + (found != all.end() ? found->label : "?");
    }
    std::string operator()(const SetGeometry& a) const { return experiment_text::text_of(a, lesson); }
    std::string operator()(const SetDriver& a) const { return experiment_text::text_of(a, lesson); }
    std::string body(int index) const {
        const std::vector<std::string> names = names_of_bodies(lesson);
        return quoted_name(names.at(at(index)), names);
    }
    std::string operator()(const SetPose& a) const {
        const Body& before = lesson.mechanism.bodies.at(at(a.body));
        const bool at = a.r != before.r || a.p == before.p;
        std::string turned = a.p == before.p ? "" : " turned";
        for (int k = 0; k < 4 && !turned.empty(); ++k) { turned += " " + writing::number_text(a.p[k]); }
        return "place " + body(a.body) + (at ? " at " + numbers_text(a.r) : "") + turned;
    }
    std::string operator()(const Drag& a) const {
        const std::string at = a.point_local.isZero(0.0) ? "" : " at " + numbers_text(a.point_local);
        return "drag " + body(a.body) + at + " to " + numbers_text(a.target);
    }
    std::string operator()(const Release&) const { return "release"; }
    std::string operator()(const ShowFreedom& a) const {
        const std::string part = a.part == 1.0 ? "" : " " + writing::number_text(a.part);
        return "follow " + std::to_string(a.motion + 1) + part;
    }
    std::string operator()(const LetGo&) const { return "let go"; }
    std::string operator()(const Undo&) const { return "undo"; }
    std::string operator()(const Redo&) const { return "redo"; }
    std::string operator()(const StartOver&) const { return "start over"; }
};

}  // namespace

std::optional<Experiment> read_experiment(
    const std::string& text, const Session& session, std::string& error) {
    try {
        Words words(text);
        if (words.done()) { throw Unreadable("nothing to try; expected one of " + comma_list(beginnings())); }
        const Experiment experiment = read_any(words, session);
        words.finish();
        return experiment;
    } catch (const Unreadable& problem) {
        error = problem.what();
        return std::nullopt;
    }
}

std::optional<Experiment> read_edit(const std::string& text, const Lesson& lesson) {
    try {
        Words words(text);
        const std::optional<Experiment> edit = edit_in(words, lesson);
        if (edit) { words.finish(); }
        return edit;
    } catch (const Unreadable&) { return std::nullopt; }
}

std::string text_of(const Experiment& experiment, const Lesson& lesson) {
    return std::visit(Teller{lesson}, experiment);
}

}  // namespace jw
