#pragma once

#include <filesystem>
#include <string>

#include "lessons/exercise/handed_in.hpp"

/// What a student has solved, kept between runs of the program.
namespace jw {

/// Records of all exercises by their keys. Their file holds nothing else: no names, no times, no answers.
class Progress {
public:
    /// Reads the file. If it is not a file of this program, it is renamed and no progress is known.
    /// @param file  empty: nothing is kept
    explicit Progress(std::filesystem::path file = {});
    /// $XDG_DATA_HOME/jointwise/progress.toml or its usual place; empty if there is no home.
    static std::filesystem::path usual_file();

    const std::filesystem::path& file() const { return file_; }
    /// All zero for an exercise that was never tried.
    ExerciseRecord of(const std::string& key) const;
    const ExerciseRecords& all() const { return records_; }

    /// Keeps a record, and writes it to the file at once. Records of other exercises that other windows have
    /// written meanwhile stay.
    void keep(const std::string& key, const ExerciseRecord& record);

    /// New message about the file since the last call, for people; usually empty.
    std::string take_notice();

private:
    void read();
    void set_aside(const std::string& why);
    void write();

    std::filesystem::path file_;
    ExerciseRecords records_;
    std::string notice_;
    bool writable_ = true;  ///< the file is one of this program, or there is none
    bool complained_ = false;
};

}  // namespace jw
