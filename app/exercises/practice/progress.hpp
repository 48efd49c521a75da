#pragma once

#include <filesystem>
#include <string>

#include "lessons/exercise/progress_file.hpp"

/// What a student has solved, kept between runs of the program.
namespace jw {

/// Records of all exercises by their keys, in a file that holds nothing else: no names, no times, no answers.
class Progress {
public:
    /// Reads the file. One that is not ours is set aside under another name, and nothing is known then.
    /// @param file  empty: nothing is kept
    explicit Progress(std::filesystem::path file = {});
    /// $XDG_DATA_HOME/jointwise/progress.toml or its usual place; empty if there is no home.
    static std::filesystem::path usual_file();

    const std::filesystem::path& file() const { return file_; }
    /// Of an exercise that was never tried: all zero.
    ExerciseRecord of(const std::string& key) const;
    const ExerciseRecords& all() const { return records_; }

    /// Keeps a record, in the file at once; what other windows wrote there meanwhile about other exercises
    /// stays.
    void keep(const std::string& key, const ExerciseRecord& record);

    /// What there is to say about the file since the last call, for people; mostly nothing.
    std::string take_notice();

private:
    void read();
    void set_aside(const std::string& why);
    void write();

    std::filesystem::path file_;
    ExerciseRecords records_;
    std::string notice_;
    bool writable_ = true;  ///< the file is ours, or there is none
    bool complained_ = false;
};

}  // namespace jw
