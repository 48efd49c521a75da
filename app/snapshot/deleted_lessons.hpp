#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/snapshot/suite.hpp"

/// Lessons that were deleted but still have golden snapshots.
namespace jw::snapshot {

/// Names of recorded lessons that are not in the suite of `paths`. Empty if no path is a folder: single files
/// do not tell which lessons there are.
std::vector<std::string> deleted_lessons(
    const std::vector<std::string>& paths, const std::vector<SuiteLesson>& suite,
    const std::filesystem::path& golden);

/// The lessons that paths name. A folder without lessons is accepted if lessons were deleted from it: there
/// are still golden snapshots of them, or the reasons for removing these. Otherwise it is probably the wrong
/// folder, and is refused.
/// @throws std::runtime_error as `suite_of` does, and for a damaged `removed.json`
std::vector<SuiteLesson> suite_or_emptied(
    const std::vector<std::string>& paths, const std::filesystem::path& golden);

/// Result of the comparison of a deleted lesson: all of its snapshots are gone.
LessonResult result_of_deleted(const std::string& name, const std::filesystem::path& golden);

/// Removes the golden snapshots of a deleted lesson. Before the first file is removed, the reason is written
/// to `removed.json` of `golden`.
/// @throws std::runtime_error if `removed.json` is damaged or cannot be written
void bless_deletion(const std::string& name, const std::filesystem::path& golden, const std::string& reason);

}  // namespace jw::snapshot
