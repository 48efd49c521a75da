#pragma once

#include <string>
#include <vector>

#include "app/session/output/json.hpp"
#include "app/snapshot/suite.hpp"

/// What a comparison has found, for people and for programs.
namespace jw::snapshot {

/// What came out for one lesson, as text.
std::string describe(const LessonResult& result);
/// "3 lessons, 40 snapshots: 38 same, 2 differ"
std::string summary(const std::vector<LessonResult>& results);

Json json_of(const std::vector<LessonResult>& results);
/// JUnit: a suite for each lesson, a case for each snapshot and each negative control.
std::string junit_of(const std::vector<LessonResult>& results);
/// One page that needs no other file: for each snapshot that is not the same what was expected, what came
/// out, where they differ, and the numbers that changed.
std::string html_of(const std::vector<LessonResult>& results);

/// "differs"
const char* word_of(Verdict verdict);
/// What keeps a snapshot from being the same, in the order of the layers; empty if nothing does.
std::vector<std::string> reasons_of(const SnapshotResult& result);

}  // namespace jw::snapshot
