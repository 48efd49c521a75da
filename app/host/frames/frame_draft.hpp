#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "app/host/frames/folder_lock.hpp"
#include "app/session/output/json.hpp"

namespace jw::host {

/// "frame_00042.png"
std::string frame_name(int number);
/// True for a name of this form, which cannot lead out of a folder.
bool is_frame_name(const std::string& name);

/// A folder of pictures that are being drawn, by one or several processes, in one or several runs. Its
/// `run.json` says what the pictures depend on: only equal runs may share the folder. A process that has
/// begun the folder alone removes it at the end, unless it leaves the folder for others.
class FrameDraft {
public:
    /// Role of a process that draws together with others.
    enum class Joined {
        shard,  ///< meanwhile, no run may begin, continue or finish the folder
        part,   ///< of a run that another process has begun, and waits for
    };

    explicit FrameDraft(std::filesystem::path folder) : folder_(std::move(folder)) {}
    ~FrameDraft();
    FrameDraft(const FrameDraft&) = delete;
    FrameDraft& operator=(const FrameDraft&) = delete;

    /// Begins an empty folder. Files that an earlier run of the program has left in it are removed.
    /// @param run  everything that the pictures depend on
    /// @throws std::runtime_error if another run uses the folder, or if it is a link or has foreign files
    void begin(const Json& run);
    /// Continues with the pictures that an equal run has left; begins the folder if it is empty.
    /// @throws std::runtime_error as `begin`; if the folder is of a different run, the message says how
    void go_on(const Json& run);
    /// Draws into the folder together with other processes of an equal run, and leaves it to them.
    /// @throws std::runtime_error as `go_on`
    void join(const Json& run, Joined as);
    /// Keeps the folder, even if this object is destroyed early.
    void leave() { is_own_ = false; }

    /// True if the file of the picture exists and is complete.
    bool has(int number) const;
    bool is_begun() const { return is_begun_; }

    const std::filesystem::path& folder() const { return folder_; }
    /// Removes the files of the program, and the folder if nothing else is in it.
    void clear();

private:
    /// Creates the folder if it does not exist, and locks it until it is cleared or this object is destroyed.
    /// @throws std::runtime_error if another run draws into it, or if it cannot be created
    void lock(FolderLock::Kind kind);
    void check_run(const Json& run) const;
    /// Removes the files of the program from the folder.
    void empty() const;
    /// Begins the folder, which must be locked and empty.
    void start(const Json& run);

    std::filesystem::path folder_;
    bool is_begun_ = false;
    bool is_own_ = false;
    FolderLock lock_;
};

/// Names in a folder, sorted; none if it cannot be read.
std::vector<std::string> names_in(const std::filesystem::path& folder);

/// SHA-256 of a file as hexadecimal digits. @throws std::runtime_error if it cannot be read
std::string sha256_of(const std::filesystem::path& file);
std::string sha256_of(std::span<const std::uint8_t> bytes);

}  // namespace jw::host
