#include "app/host/lesson/shown_picture.hpp"

#include <utility>

#include "app/session/picture/pointable.hpp"

namespace jw::host {

Emphasis emphasis_of(const Session& session, const Lit& lit) {
    const System& system = *session.step().system;
    const int angular = angular_of(session.lesson().coordinates);
    Emphasis all(system, angular, lit.pointed_at);
    const std::vector<SymbolView>& symbols = session.view().symbols;
    const auto k = static_cast<std::size_t>(lit.pointed_at.index);
    if (lit.pointed_at.kind == Pointable::Kind::symbol && k < symbols.size()) {
        for (const Pointable& link : links_of(symbols[k], system)) { all.light(system, angular, link); }
    }
    light_answer(session.step(), session.lesson().coordinates, session.view(), all);
    for (const int row : lit.rows) { all.light(system, angular, Pointable::row(row)); }
    return all;
}

const Picture& ShownPicture::of(
    const Session& session, const Lit& lit, const Ghosts& ghosts, const Replacement& other) {
    const std::uint64_t replaced = other.picture != nullptr ? other.version : 0;
    MadeOf wanted{session.version(), lit, ghosts.version, !ghosts.poses.empty(), replaced};
    if (made_of_ == wanted) { return picture_; }
    still_ = nullptr;
    picture_ = other.picture != nullptr ? *other.picture : session.picture();
    add_ghosts(session.lesson(), session.style(), ghosts.poses, picture_);
    light_up(picture_, emphasis_of(session, lit));
    if (made_of_.session != wanted.session || made_of_.other != wanted.other) { ++pose_version_; }
    ++version_;
    made_of_ = std::move(wanted);
    return picture_;
}

const Picture& ShownPicture::of(const Picture& still) {
    if (still_ == &still) { return picture_; }
    picture_ = still;
    still_ = &still;
    made_of_ = {};
    ++pose_version_;
    ++version_;
    return picture_;
}

}  // namespace jw::host
