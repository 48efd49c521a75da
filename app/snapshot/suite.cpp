#include "app/snapshot/suite.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "app/session/wording/numbers.hpp"
#include "app/snapshot/explanation.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/files/catalogue.hpp"
#include "render/files/png.hpp"

namespace jw::snapshot {

namespace {

namespace fs = std::filesystem;

void add(std::vector<SuiteLesson>& suite, const fs::path& file, const fs::path& name) {
    const fs::path plain = name.parent_path() / name.stem();
    // the name becomes a folder below that of the golden snapshots
    if (std::ranges::any_of(plain, [](const fs::path& part) { return part == "." || part == ".."; })) {
        throw std::runtime_error(
            "'" + file.string() +
            "' has no name before .toml, so its folder of snapshots cannot be named after it; expected a "
            "file such as crank.toml");
    }
    const std::string text = plain.generic_string();
    const auto other = std::ranges::find(suite, text, &SuiteLesson::name);
    if (other != suite.end()) {
        throw std::runtime_error(
            "'" + other->file.string() + "' and '" + file.string() + "' have the same name " +
            in_quotes(text) + "; expected lessons of different names (give the folder that holds both)");
    }
    suite.push_back({file, text});
}

Verdict verdict_of(const Difference& difference) {
    if (difference.fails()) { return Verdict::differs; }
    return difference.colour.broken.empty() ? Verdict::same : Verdict::drawn_otherwise;
}

void keep_pictures(const Snapshot* golden, const Snapshot* actual, SnapshotResult& result) {
    if (golden != nullptr) { result.golden_png = render::encode_png(golden->colour); }
    if (actual != nullptr) { result.actual_png = render::encode_png(actual->colour); }
    const Difference& d = result.difference;
    if (d.colour.marked.width > 0) { result.marked_png = render::encode_png(d.colour.marked); }
    const render::Image& layer = d.ids.marked.width > 0 ? d.ids.marked : d.depth.marked;
    if (layer.width > 0) { result.marked_ids_png = render::encode_png(layer); }
}

/// Compares the present snapshot with the golden one.
SnapshotResult compared(
    const GoldenFolder& folder, Camera& camera, const Shot& shot, Snapshot actual,
    const SnapshotRules& rules) {
    SnapshotResult result;
    result.name = actual.record.name;
    result.title = actual.record.title;
    result.failed =
        std::ranges::find(actual.record.facts, "failure", &Fact::name) != actual.record.facts.end();
    if (!folder.has(result.name)) {
        result.verdict = Verdict::is_new;
        keep_pictures(nullptr, &actual, result);
        return result;
    }
    try {
        const Snapshot golden = folder.read(result.name);
        // everything except the number of the step must look the same
        if (const auto number = other_steps(golden.record, actual.record)) {
            actual.colour = camera.colour_as(shot, *number);
        }
        result.difference = difference_of(golden, actual, rules);
        result.verdict = verdict_of(result.difference);
        if (result.verdict != Verdict::same) { keep_pictures(&golden, &actual, result); }
    } catch (const std::runtime_error& error) {
        result.verdict = Verdict::broken;
        result.problem = error.what();
    }
    return result;
}

std::vector<std::string> gone_from(const GoldenFolder& folder, const Camera& camera) {
    std::set<std::string> names;
    for (const Shot& shot : camera.shots()) { names.insert(shot.name); }
    std::vector<std::string> left = folder.names();
    std::erase_if(left, [&](const std::string& name) { return names.contains(name); });
    return left;
}

/// Words about a step at which the mechanism now fails, or that is gone; empty if there is none.
std::string lost_step(const std::vector<SnapshotResult>& snapshots) {
    for (const SnapshotResult& s : snapshots) {
        const bool fails_now =
            s.failed &&
            (s.verdict == Verdict::is_new ||
             (!s.difference.facts.empty() && s.difference.facts.front().weight == Weight::failure));
        if (fails_now) { return "in '" + s.name + "' the mechanism fails"; }
    }
    const auto gone = std::ranges::find(snapshots, Verdict::gone, &SnapshotResult::verdict);
    return gone == snapshots.end() ? "" : "the lesson has no step '" + gone->name + "' any more";
}

/// Sentence about the most important changed fact: "... in 'A' rank is another: 5 → 4"; empty without one.
std::string first_fact(const std::vector<SnapshotResult>& snapshots) {
    const auto weight = [](const SnapshotResult& s) { return s.difference.facts.front().weight; };
    const SnapshotResult* first = nullptr;
    for (const SnapshotResult& s : snapshots) {
        if (s.difference.facts.empty()) { continue; }
        if (first == nullptr || weight(s) < weight(*first)) { first = &s; }
    }
    if (first == nullptr) { return {}; }
    const FactChange& change = first->difference.facts.front();
    const std::string values = change.before.empty()  ? "new, " + change.after
                               : change.after.empty() ? "gone, was " + change.before
                                                      : change.before + " → " + change.after;
    return "no value of the lesson has changed, and in '" + first->name + "' " + change.name +
           " is another: " + values;
}

/// Reason why snapshots differ if neither the lesson nor the facts do.
std::string differing_otherwise(const std::vector<SnapshotResult>& snapshots) {
    const auto has = [&](Verdict verdict) {
        return std::ranges::find(snapshots, verdict, &SnapshotResult::verdict) != snapshots.end();
    };
    const auto is_loose = [](const SnapshotResult& s) { return !s.difference.loose.empty(); };
    if (std::ranges::any_of(snapshots, is_loose)) {
        return "golden files allow more than the program does; nothing that they say is proved";
    }
    if (has(Verdict::differs)) { return "lesson and numbers are as they were; only pixels differ"; }
    if (has(Verdict::broken)) { return "golden snapshots are damaged; no value of the lesson has changed"; }
    return "other steps were recorded than are compared; no value of the lesson has changed";
}

}  // namespace

std::vector<SuiteLesson> suite_of(const std::vector<std::string>& paths, EmptyFolders empty) {
    std::vector<SuiteLesson> suite;
    for (const std::string& path : paths) {
        std::error_code error;
        if (!fs::is_directory(path, error)) {
            add(suite, path, fs::path(path).filename());
            continue;
        }
        std::vector<fs::path> files = lessons_below(path);
        std::erase_if(files, GoldenFolder::is_copy_of_lesson);
        if (files.empty() && empty == EmptyFolders::refused) {
            throw std::runtime_error(
                "'" + path + "': there is no lesson below this folder; expected files *.toml");
        }
        // links are not followed: a lesson that is a link keeps its name here
        for (const fs::path& file : files) { add(suite, file, file.lexically_relative(path)); }
    }
    return suite;
}

SnapshotResult gone_snapshot(const GoldenFolder& folder, const std::string& name) {
    SnapshotResult result;
    result.name = name;
    try {
        const Snapshot golden = folder.read(name);
        result.title = golden.record.title;
        result.verdict = Verdict::gone;
        keep_pictures(&golden, nullptr, result);
    } catch (const std::runtime_error& error) {
        result.verdict = Verdict::broken;
        result.problem = error.what();
    }
    return result;
}

bool fails(Verdict verdict) { return verdict != Verdict::same && verdict != Verdict::drawn_otherwise; }

bool LessonResult::fails() const {
    const auto blind = [](const ControlResult& control) { return !control.noticed; };
    return is_deleted || !problem.empty() || !steps_line().empty() ||
           std::ranges::any_of(snapshots, [](const auto& s) { return snapshot::fails(s.verdict); }) ||
           std::ranges::any_of(controls.made, blind);
}

std::string LessonResult::explanation() const {
    if (is_deleted) {
        return "the lesson is deleted, and its golden snapshots are there; 'jointwise snapshot bless' of the "
               "folder of lessons, with --reason, removes them";
    }
    const auto same = [](const SnapshotResult& s) { return s.verdict == Verdict::same; };
    if (std::ranges::all_of(snapshots, same) && steps_line().empty()) { return {}; }
    if (!lesson_changes.empty()) {
        const std::size_t others = lesson_changes.size() - 1;
        return lesson_changes.front() +
               (others == 0   ? ""
                : others == 1 ? "; and another change of the lesson"
                              : "; and " + std::to_string(others) + " other changes of the lesson");
    }
    if (const std::string lost = lost_step(snapshots); !lost.empty()) {
        return "no value of the lesson has changed, and " + lost;
    }
    if (std::string fact = first_fact(snapshots); !fact.empty()) { return fact; }
    if (const std::string line = steps_line(); !line.empty()) { return line; }
    for (const SnapshotResult& s : snapshots) {
        if (!s.difference.drawn_otherwise.empty()) {
            return "lesson and numbers are as they were; drawn with something else: " +
                   s.difference.drawn_otherwise;
        }
    }
    return differing_otherwise(snapshots);
}

std::string LessonResult::steps_line() const {
    for (const SnapshotResult& s : snapshots) {
        if (!s.difference.steps_before) { continue; }
        return "the lesson has " + count_text(steps, "step", "steps") + ", " +
               std::to_string(s.difference.steps_before->steps) + " before";
    }
    return {};
}

RecordResult record(
    const Lesson& lesson, const std::string& lesson_text, const GoldenFolder& folder,
    const GoldenHead& head) {
    Camera camera(lesson, head.size, head.choice, UnknownShots::refused);
    if (!folder.exists() || folder.head() != head) { folder.write_head(head, lesson_text); }
    RecordResult result;
    for (const Shot& shot : camera.shots()) {
        if (folder.has(shot.name)) {
            ++result.kept;
            continue;
        }
        folder.write(camera.take(shot));
        ++result.written;
    }
    return result;
}

LessonResult compare(
    const Lesson& lesson, const std::string& lesson_text, const SuiteLesson& of, const GoldenFolder& folder,
    const SnapshotRules& rules, const std::set<Fault>& controls) {
    LessonResult result;
    result.lesson = of;
    result.title = lesson.title;
    const GoldenHead head = folder.head();
    result.lesson_changes = lesson_changes(folder.lesson(), lesson_text);
    Camera camera(lesson, head.size, head.choice, UnknownShots::left_out);
    for (const Shot& shot : camera.shots()) {
        result.snapshots.push_back(compared(folder, camera, shot, camera.take(shot), rules));
    }
    result.steps = static_cast<int>(camera.story().steps().size());
    for (const std::string& name : gone_from(folder, camera)) {
        result.snapshots.push_back(gone_snapshot(folder, name));
    }
    if (!controls.empty() && !camera.shots().empty()) {
        result.controls = control(camera, shot_for_controls(camera), rules, controls);
    }
    return result;
}

std::vector<std::string> bless(
    const Lesson& lesson, const std::string& lesson_text, const GoldenFolder& folder,
    const SnapshotRules& rules, const std::vector<std::string>& only, const std::string& reason) {
    const GoldenHead head = folder.head();
    Camera camera(lesson, head.size, head.choice, UnknownShots::left_out);
    std::vector<std::string> changed;
    const auto is_meant = [&](const std::string& name) {
        return only.empty() || std::ranges::find(only, name) != only.end();
    };
    for (const Shot& shot : camera.shots()) {
        if (!is_meant(shot.name)) { continue; }
        Snapshot actual = camera.take(shot);
        const SnapshotResult now = compared(folder, camera, shot, actual, rules);
        const Difference& found = now.difference;
        const bool is_as_now = !found.steps_before && found.drawn_otherwise.empty();
        if (now.verdict == Verdict::same && is_as_now) { continue; }
        try {
            if (folder.has(shot.name)) { actual.record.blessed = folder.read(shot.name).record.blessed; }
        } catch (const std::runtime_error&) {  // what cannot be read is replaced
        }
        // not twice, if blessing was interrupted before
        std::vector<std::string>& reasons = actual.record.blessed;
        if (reasons.empty() || reasons.back() != reason) { reasons.push_back(reason); }
        folder.write(actual);
        changed.push_back(shot.name);
    }
    for (const std::string& name : gone_from(folder, camera)) {
        if (!is_meant(name)) { continue; }
        folder.remove(name);
        changed.push_back(name);
    }
    if (only.empty()) { folder.write_lesson(lesson_text); }
    return changed;
}

}  // namespace jw::snapshot
