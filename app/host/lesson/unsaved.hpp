#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/session/try/session.hpp"

/// Unsaved experiments of a lesson, kept in a file, which remains however the program ends.
namespace jw::host {

/// The text of the lesson in its present state, without the claims: they are about the lesson as written.
std::string text_to_save(const Session& session);

class UnsavedCopy {
public:
    /// @param folder  of the copies, created when it is needed; empty: nothing is kept
    explicit UnsavedCopy(std::filesystem::path folder);

    /// Writes the lesson if it was changed since the last call; removes the copy if nothing is changed.
    /// @param name  of the copy without extension: that of the lesson's file
    /// @return why it cannot be written, once for each session; empty if it was written or need not be
    std::string keep(const Session& session, const std::string& name);

    /// Call when the user has saved the lesson in its present state: the copy is removed.
    void saved(const Session& session);
    /// Call when another session begins. The copy of the previous session stays.
    void begin_anew();

    /// Path of the copy; empty if there is none.
    const std::filesystem::path& path() const { return path_; }
    /// Copies of previous sessions, newest first.
    std::vector<std::filesystem::path> others() const;

private:
    void take_away();

    std::filesystem::path folder_;
    std::filesystem::path path_;
    std::uint64_t told_ = 0;  ///< telling that the copy was made of, or that needs no copy
    bool complained_ = false;
};

/// Copies in `folder`, newest first; all but the newest `kMostCopies` are removed.
std::vector<std::filesystem::path> unsaved_copies(const std::filesystem::path& folder);
inline constexpr std::size_t kMostCopies = 20;

}  // namespace jw::host
