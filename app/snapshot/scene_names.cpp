#include "app/snapshot/scene_names.hpp"

#include "app/session/picture/pointable.hpp"
#include "lessons/lesson/things.hpp"

namespace jw::snapshot {

std::string name_of_part(int id, const Mechanism& mechanism) {
    const Pointable link = pointable_of(id);
    switch (link.kind) {
        case Pointable::Kind::body: return name_of(Thing::body(link.index), mechanism);
        case Pointable::Kind::joint: return name_of(Thing::joint(link.index), mechanism);
        case Pointable::Kind::vector: return name_of(Thing::vector(link.index, link.part), mechanism);
        case Pointable::Kind::none:
        case Pointable::Kind::row:
        case Pointable::Kind::column:
        case Pointable::Kind::symbol:
        case Pointable::Kind::equation: break;
    }
    return "ground and paths";
}

}  // namespace jw::snapshot
