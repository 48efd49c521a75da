#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/snapshot/comparison.hpp"
#include "app/snapshot/controls.hpp"
#include "app/snapshot/golden_folder.hpp"

/// Lessons against their golden snapshots.
namespace jw::snapshot {

/// A lesson of a suite: the folder of its snapshots has its name.
struct SuiteLesson {
    std::filesystem::path file;
    std::string name;  ///< "loops/four-bar"
};

enum class EmptyFolders { refused, allowed };

/// The lessons that paths name. Those below a folder have their path from there as a name, a single file its
/// own name.
/// @throws std::runtime_error for two lessons of one name, and for a folder without lessons if that is
/// refused
std::vector<SuiteLesson> suite_of(
    const std::vector<std::string>& paths, EmptyFolders empty = EmptyFolders::refused);

enum class Verdict {
    same,
    drawn_otherwise,  ///< the colours differ, and are drawn with something else: they do not count
    differs,
    is_new,  ///< there is no golden snapshot of it
    gone,    ///< there is a golden snapshot, and the lesson has no such step any more
    broken,  ///< the golden snapshot cannot be read
};
/// True for verdicts that a comparison fails by.
bool fails(Verdict verdict);

struct SnapshotResult {
    std::string name;
    std::string title;
    Verdict verdict = Verdict::same;
    Difference difference;
    std::string problem;  ///< of a broken one
    bool failed = false;  ///< the mechanism fails at this step
    // of those that are not the same, for a report
    std::vector<std::uint8_t> golden_png;
    std::vector<std::uint8_t> actual_png;
    std::vector<std::uint8_t> marked_png;      ///< colours that differ
    std::vector<std::uint8_t> marked_ids_png;  ///< things that differ
};

struct LessonResult {
    SuiteLesson lesson;
    std::string title;
    bool is_deleted = false;  ///< there are golden snapshots, and no such lesson any more
    std::string problem;      ///< the lesson, or its folder, cannot be read; then there are no snapshots
    std::vector<std::string> lesson_changes;  ///< in its file, since the snapshots were taken
    int steps = 0;                            ///< of the story
    std::vector<SnapshotResult> snapshots;    ///< in the order of the story
    ControlResults controls;                  ///< faults that no lesson before has had room for

    bool fails() const;
    /// "the lesson has 23 steps, 24 before"; empty if it has as many. It counts once, whatever else differs.
    std::string steps_line() const;
    /// The one line that explains what is seen; empty if nothing differs.
    std::string explanation() const;
};

struct RecordResult {
    int written = 0;
    int kept = 0;  ///< that were there already, whether they are the same or not
};

/// Takes the snapshots that are not there yet. `lesson_text` is the lesson's file.
RecordResult record(
    const Lesson& lesson, const std::string& lesson_text, const GoldenFolder& folder, const GoldenHead& head);

/// Result of the comparison of a golden snapshot of which there is no step any more.
SnapshotResult gone_snapshot(const GoldenFolder& folder, const std::string& name);

/// Compares the lesson with its golden snapshots.
/// @param controls  tries whether the rules notice these faults, too
/// @throws std::runtime_error if its head cannot be read
LessonResult compare(
    const Lesson& lesson, const std::string& lesson_text, const SuiteLesson& of, const GoldenFolder& folder,
    const SnapshotRules& rules, const std::set<Fault>& controls);

/// Puts what is seen now in place of golden snapshots that differ, are drawn with something else, are new or
/// gone, with the reason.
/// @param only  some snapshots; empty: all of the lesson, and the copy of the lesson as well
/// @return names of those that were changed
std::vector<std::string> bless(
    const Lesson& lesson, const std::string& lesson_text, const GoldenFolder& folder,
    const SnapshotRules& rules, const std::vector<std::string>& only, const std::string& reason);

}  // namespace jw::snapshot
