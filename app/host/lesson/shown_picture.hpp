#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "app/session/try/session.hpp"

/// The 3D picture of the open lesson as a person sees it.
namespace jw::host {

/// Selection that lights up, with everything that belongs to it.
struct Lit {
    Pointable pointed_at;
    std::vector<int> rows;  ///< of the system

    bool operator==(const Lit&) const = default;
};

Emphasis emphasis_of(const Session& session, const Lit& lit);

/// Other poses of the bodies, to be drawn pale.
struct Ghosts {
    std::span<const State> poses;
    std::uint64_t version = 0;  ///< grows with every change of them
};

/// The picture of a session with what is lit and what is pale, made anew only where one of them changed.
class ShownPicture {
public:
    const Picture& of(const Session& session, const Lit& lit, const Ghosts& ghosts);
    /// A picture that is not one of a session; the same one as long as it has the same address.
    const Picture& of(const Picture& still);
    /// The picture that was made last; empty before.
    const Picture& picture() const { return picture_; }

    /// Another session follows: its versions say nothing about those of the one before.
    void forget_session() {
        made_of_.session = 0;
        still_ = nullptr;
    }
    /// Has the same picture drawn again, in other colours.
    void redraw() { ++version_; }

    /// Grows with every change of the picture.
    std::uint64_t version() const { return version_; }
    /// Counts the poses shown, over all sessions: what lights up does not count.
    std::uint64_t pose_version() const { return pose_version_; }

private:
    struct MadeOf {
        std::uint64_t session = 0;  ///< its version
        Lit lit;
        std::uint64_t ghosts = 0;
        bool has_ghosts = false;

        bool operator==(const MadeOf&) const = default;
    };

    Picture picture_;
    MadeOf made_of_;
    const Picture* still_ = nullptr;  ///< that picture_ is a copy of
    std::uint64_t version_ = 0;
    std::uint64_t pose_version_ = 0;
};

}  // namespace jw::host
