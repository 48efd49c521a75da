#pragma once

#include <map>
#include <string>

/// The file that keeps what a student has solved.
namespace jw {

/// Results of an exercise so far.
struct ExerciseRecord {
    int tried = 0;    ///< answers that were judged
    int solved = 0;   ///< variants answered correctly before their solution was shown
    int streak = 0;   ///< how many of these in a row, up to now
    int variant = 0;  ///< number of the variant that comes next

    bool operator==(const ExerciseRecord&) const = default;
};
/// By the keys of exercises.
using ExerciseRecords = std::map<std::string, ExerciseRecord>;

/// The text of the file: the records and nothing else.
std::string progress_text(const ExerciseRecords& records);

struct ProgressRead {
    ExerciseRecords records;
    std::string problem;  ///< why the text is not a progress file, as part of a sentence; empty if it is
};
ProgressRead read_progress(std::string text);

}  // namespace jw
