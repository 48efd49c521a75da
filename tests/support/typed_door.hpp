#pragma once

#include <string>

namespace jw::test {

/// Lesson of a door on two hinges whose common axis was typed with five digits.
inline std::string typed_door() {
    const std::string hinge =
        "type = \"revolute\"\nbodies = [\"ground\", \"door\"]\naxis = [0.21822, 0.43644, 0.87287]\n";
    return "format = 1\ntitle = \"A door\"\n[[body]]\nname = \"door\"\n"
           "[[joint]]\nname = \"lower\"\nat = [0, 0, 0]\n" +
           hinge + "[[joint]]\nname = \"upper\"\nat = [0.5, 1.0, 2.0]\n" + hinge;
}

}  // namespace jw::test
