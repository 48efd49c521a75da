#pragma once

#include <string>
#include <vector>

#include "app/session/story/story.hpp"

/// Places of a story that the page of its lesson describes: the bodies, each joint and driver, the motion.
namespace jw::site {

struct Station {
    std::string id;        ///< of its part of the page: "step-5"
    int equations = -1;    ///< step at which its equations are shown; -1: it has none
    int told = 0;          ///< step whose text and numbers are shown
    bool moves = false;    ///< a moment of the motion
    bool pictured = true;  ///< in a long story only with a text of the author
};

std::vector<Station> stations_of(const Story& story);

}  // namespace jw::site
