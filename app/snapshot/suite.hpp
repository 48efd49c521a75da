#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/snapshot/comparison.hpp"
#include "app/snapshot/controls.hpp"
#include "app/snapshot/golden_folder.hpp"

/// Compares lessons with their golden snapshots.
namespace jw::snapshot {

/// A lesson of a suite; the folder of its snapshots has the same name.
struct SuiteLesson {
    std::filesystem::path file;
    std::string name;  ///< "loops/four-bar"
};

enum class EmptyFolders { refused, allowed };

/// The lessons that paths name. The name of a lesson below a folder is its path from there; the name of a
/// single file is its file name.
/// @throws std::runtime_error for two lessons with the same name, and for a folder without lessons if that is
/// refused
std::vector<SuiteLesson> suite_of(
    const std::vector<std::string>& paths, EmptyFolders empty = EmptyFolders::refused);

enum class Verdict {
    same,
    drawn_otherwise,  ///< the colours differ, but other software draws them: they do not count
    differs,
    is_new,  ///< it has no golden snapshot
    gone,    ///< it has a golden snapshot, but the lesson has no such step any more
    broken,  ///< the golden snapshot cannot be read
};
/// True for verdicts with which a comparison fails.
bool fails(Verdict verdict);

struct SnapshotResult {
    std::string name;
    std::string title;
    Verdict verdict = Verdict::same;
    Difference difference;
    std::string problem;  ///< of a broken one
    bool failed = false;  ///< the mechanism fails at this step
    // for snapshots that are not the same, for a report
    std::vector<std::uint8_t> golden_png;
    std::vector<std::uint8_t> actual_png;
    std::vector<std::uint8_t> marked_png;      ///< colours that differ
    std::vector<std::uint8_t> marked_ids_png;  ///< things or depths that differ
};

struct LessonResult {
    SuiteLesson lesson;
    std::string title;
    bool is_deleted = false;  ///< there are golden snapshots, but no such lesson any more
    std::string problem;      ///< why the lesson or its folder cannot be read; then there are no snapshots
    std::vector<std::string> lesson_changes;  ///< changes in its file since the snapshots were taken
    int steps = 0;                            ///< of the story
    std::vector<SnapshotResult> snapshots;    ///< in the order of the story
    ControlResults controls;                  ///< faults that could not be made in earlier lessons

    bool fails() const;
    /// "the lesson has 23 steps, 24 before"; empty if the number is the same. It counts once, whatever else
    /// differs.
    std::string steps_line() const;
    /// The one line that explains the differences; empty if there are none.
    std::string explanation() const;
};

struct RecordResult {
    int written = 0;
    int kept = 0;  ///< that existed already, whether they are the same or not
};

/// Takes the snapshots that do not exist yet. `lesson_text` is the lesson's file.
RecordResult record(
    const Lesson& lesson, const std::string& lesson_text, const GoldenFolder& folder, const GoldenHead& head);

/// Result of the comparison for a golden snapshot that has no step any more.
SnapshotResult gone_snapshot(const GoldenFolder& folder, const std::string& name);

/// Compares the lesson with its golden snapshots.
/// @param controls  faults for which it is also tested whether the rules notice them
/// @throws std::runtime_error if the head of the golden folder cannot be read
LessonResult compare(
    const Lesson& lesson, const std::string& lesson_text, const SuiteLesson& of, const GoldenFolder& folder,
    const SnapshotRules& rules, const std::set<Fault>& controls);

/// Replaces golden snapshots by the present ones, with the reason, if they differ, are new or gone, or were
/// drawn by other software.
/// @param only  some snapshots; empty: all of the lesson, and its copy of the lesson as well
/// @return names of the changed snapshots
std::vector<std::string> bless(
    const Lesson& lesson, const std::string& lesson_text, const GoldenFolder& folder,
    const SnapshotRules& rules, const std::vector<std::string>& only, const std::string& reason);

}  // namespace jw::snapshot
