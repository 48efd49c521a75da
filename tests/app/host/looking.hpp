#pragma once

#include <set>

#include "tests/app/host/person.hpp"

/// Searches for objects to point at, and reads what is highlighted.
namespace jw::test {

/// Ids of the highlighted parts of the picture.
inline std::set<int> lit_in(const Picture& picture) {
    std::set<int> ids;
    const auto add = [&](const auto& parts) {
        for (const auto& part : parts) {
            if (part.highlighted && part.id != 0) { ids.insert(part.id); }
        }
    };
    add(picture.scene.shapes);
    add(picture.scene.arrows);
    return ids;
}

/// Points at one place of the box after the other until `fits` holds of what is pointed at.
/// @param across, down  from place to place [px]
template <class Fits>
bool look_for(Person& person, const panels::Box& box, float across, float down, const Fits& fits) {
    for (float y = box.y + 4.0F; y < box.bottom(); y += down) {
        for (float x = box.x + 4.0F; x < box.right(); x += across) {
            person.host().push(host::InputEvent::pointer(x, y));
            person.frame();
            if (fits(person.host().state().pointed_at)) {
                person.settle();
                return true;
            }
        }
    }
    return false;
}

template <class Fits>
bool look_for(Person& person, const panels::Box& box, float step, const Fits& fits) {
    return look_for(person, box, step, step, fits);
}

}  // namespace jw::test
