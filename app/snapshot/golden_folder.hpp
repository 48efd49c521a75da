#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/snapshot/taken.hpp"

/// The snapshots of one lesson on disk: a folder with
///   snapshots.json     size, which steps, language
///   lesson.toml        the lesson as it was
///   NAME.json          what the snapshot says, and what it was drawn with
///   NAME.png           colours
///   NAME.ids.png       what is seen at each pixel
///   NAME.depth.png     how far away it is
namespace jw::snapshot {

struct GoldenHead {
    SnapshotSize size;
    ShotChoice choice;
    std::string language = "en";  ///< of the sentences

    bool operator==(const GoldenHead&) const = default;
};

class GoldenFolder {
public:
    explicit GoldenFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

    const std::filesystem::path& path() const { return folder_; }
    /// True once a lesson was recorded here.
    bool exists() const;
    /// @throws std::runtime_error if there is none, or it is damaged
    GoldenHead head() const;
    /// Text of the lesson as it was; empty if it is not there.
    std::string lesson() const;
    /// Names of the snapshots, sorted.
    std::vector<std::string> names() const;
    bool has(const std::string& name) const;
    /// @throws std::runtime_error naming the file that is missing or damaged, and what to do
    Snapshot read(const std::string& name) const;

    /// Names of the lessons that were recorded below a folder, sorted: the paths of their golden folders,
    /// relative to it. Links are not followed.
    static std::vector<std::string> recorded_below(const std::filesystem::path& golden);
    /// True for the copies of lessons in golden folders: they are not lessons of a suite.
    static bool is_copy_of_lesson(const std::filesystem::path& file);

    void write_head(const GoldenHead& head, const std::string& lesson_text) const;
    void write_lesson(const std::string& lesson_text) const;
    /// Writes all four files or none, so that a record never belongs to other pictures. If the program is
    /// killed while the files are put in place: a new record comes last, so that there is no snapshot yet; a
    /// record that replaces another comes first, so that its reason is kept while its pictures still differ.
    void write(const Snapshot& snapshot) const;
    void remove(const std::string& name) const;
    /// Removes all files of the lesson, and folders below `golden` that are empty then. Other files stay.
    void remove_lesson(const std::filesystem::path& golden) const;

private:
    std::filesystem::path file(const std::string& name, const char* ending) const;

    std::filesystem::path folder_;
};

}  // namespace jw::snapshot
