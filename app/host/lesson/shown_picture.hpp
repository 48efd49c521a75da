#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "app/session/try/session.hpp"

/// The 3D picture of the open lesson as the user sees it.
namespace jw::host {

/// Selection that is highlighted, with everything that belongs to it.
struct Lit {
    Pointable pointed_at;
    std::vector<int> rows;  ///< of the system

    bool operator==(const Lit&) const = default;
};

Emphasis emphasis_of(const Session& session, const Lit& lit);

/// Other poses of the bodies, to be drawn pale.
struct Ghosts {
    std::span<const State> poses;
    std::uint64_t version = 0;  ///< grows with every change of the poses
};

/// A picture that is shown in place of that of the session.
struct Replacement {
    const Picture* picture = nullptr;  ///< null: none
    std::uint64_t version = 0;         ///< above 0; grows with every change of the picture
};

/// The picture of a session with highlights and ghosts, made again only if one of these has changed.
class ShownPicture {
public:
    const Picture& of(
        const Session& session, const Lit& lit, const Ghosts& ghosts, const Replacement& other = {});
    /// A picture that does not belong to a session; it is identified by its address.
    const Picture& of(const Picture& still);
    /// The picture that was made last; empty before.
    const Picture& picture() const { return picture_; }

    /// Call when another session follows: its versions cannot be compared with those of the previous one.
    void forget_session() {
        made_of_.session = 0;
        still_ = nullptr;
    }
    /// Lets the same picture be drawn again, in other colours.
    void redraw() { ++version_; }

    /// Grows with every change of the picture.
    std::uint64_t version() const { return version_; }
    /// Counts the poses shown, over all sessions; highlighting does not count.
    std::uint64_t pose_version() const { return pose_version_; }

private:
    struct MadeOf {
        std::uint64_t session = 0;  ///< its version
        Lit lit;
        std::uint64_t ghosts = 0;
        bool has_ghosts = false;
        std::uint64_t other = 0;  ///< version of what replaces it; 0: nothing

        bool operator==(const MadeOf&) const = default;
    };

    Picture picture_;
    MadeOf made_of_;
    const Picture* still_ = nullptr;  ///< that picture_ is a copy of
    std::uint64_t version_ = 0;
    std::uint64_t pose_version_ = 0;
};

}  // namespace jw::host
