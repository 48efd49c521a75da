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
/// True for such a name, which so leads out of no folder.
bool is_frame_name(const std::string& name);

/// A folder of pictures that are being drawn, by one process or by several, now or in several runs.
/// `run.json` in it says what they depend on: only pictures of equal runs come together. Whoever has begun it
/// alone takes it away in the end, unless it is left for others.
class FrameDraft {
public:
    /// Role of a process that draws beside others.
    enum class Joined {
        shard,  ///< nobody may begin the folder, go on with it or finish it meanwhile
        part,   ///< of a run that somebody else has begun, and waits for
    };

    explicit FrameDraft(std::filesystem::path folder) : folder_(std::move(folder)) {}
    ~FrameDraft();
    FrameDraft(const FrameDraft&) = delete;
    FrameDraft& operator=(const FrameDraft&) = delete;

    /// Begins an empty folder; what a run of ours has left in it is taken away.
    /// @param run  everything that the pictures depend on
    /// @throws std::runtime_error if there is no room for it, or if it has files of somebody else
    void begin(const Json& run);
    /// Goes on with what an equal run has left; begins anew where there is nothing.
    /// @throws std::runtime_error as `begin`, and naming what differs if it was another run
    void go_on(const Json& run);
    /// Draws into it beside others of an equal run, and leaves it to them. @throws std::runtime_error as
    /// `go_on`
    void join(const Json& run, Joined as);
    /// The folder stays as it is, even if this ends early.
    void leave() { is_own_ = false; }

    /// True if the picture is there, whole.
    bool has(int number) const;
    bool is_begun() const { return is_begun_; }

    const std::filesystem::path& folder() const { return folder_; }
    /// Takes away what is in it of ours, and the folder where nothing else is.
    void clear();

private:
    /// Makes the folder if it is not there, and keeps others out of it until it is cleared or this ends.
    /// @throws std::runtime_error if somebody draws into it, or if it cannot be made
    void lock(FolderLock::Kind kind);
    void check_run(const Json& run) const;
    /// Takes away what is of ours in the folder.
    void empty() const;
    /// Begins the folder, which is locked and empty.
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
