#pragma once

#include <string>
#include <vector>

#include "app/session/output/json.hpp"
#include "app/snapshot/suite.hpp"

/// Reports on a comparison, for people and for programs.
namespace jw::snapshot {

/// The result for one lesson, as text.
std::string describe(const LessonResult& result);
/// "3 lessons, 40 snapshots: 38 same, 2 different"
std::string summary(const std::vector<LessonResult>& results);

Json json_of(const std::vector<LessonResult>& results);
/// JUnit: a suite for each lesson, a case for each snapshot and each negative control.
std::string junit_of(const std::vector<LessonResult>& results);
/// One page that needs no other file. For each snapshot that is not the same, it shows the expected picture,
/// the actual one, where they differ, and the numbers that changed.
std::string html_of(const std::vector<LessonResult>& results);

/// "different"
const char* word_of(Verdict verdict);
/// The reasons why a snapshot is not the same, in the order of the layers; empty if it is.
std::vector<std::string> reasons_of(const SnapshotResult& result);

}  // namespace jw::snapshot
