#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/session/try/session.hpp"

/// Experiments of a lesson that are not saved, kept in a file meanwhile: whatever ends the program, it is
/// there.
namespace jw::host {

/// The text of the lesson as it stands, without the claims, which were made of the lesson as it was written.
std::string text_to_save(const Session& session);

class UnsavedCopy {
public:
    /// @param folder  of the copies, made when it is needed; empty: nothing is kept
    explicit UnsavedCopy(std::filesystem::path folder);

    /// Writes the lesson if it was changed since the last call; takes the copy away where nothing is changed.
    /// @param name  of the copy without ending: that of the lesson's file
    /// @return why it cannot be written, once for each session; empty if it was, or need not be
    std::string keep(const Session& session, const std::string& name);

    /// The lesson as it stands was saved by the person: the copy is taken away.
    void saved(const Session& session);
    /// Another session begins. The copy of the one before stays.
    void begin_anew();

    /// Empty where there is no copy.
    const std::filesystem::path& path() const { return path_; }
    /// Copies of sessions before this one, newest first.
    std::vector<std::filesystem::path> others() const;

private:
    void take_away();

    std::filesystem::path folder_;
    std::filesystem::path path_;
    std::uint64_t told_ = 0;  ///< telling of the session that the copy is of, or that needs none
    bool complained_ = false;
};

/// Copies in `folder`, newest first; all but the newest `kMostCopies` are removed.
std::vector<std::filesystem::path> unsaved_copies(const std::filesystem::path& folder);
inline constexpr std::size_t kMostCopies = 20;

}  // namespace jw::host
