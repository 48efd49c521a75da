#pragma once

/// As core.hpp, for the session and all code that shows it or asks it.
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string_view>

#include <nlohmann/json.hpp>

#include "app/session/picture/picture.hpp"
#include "app/session/story/story.hpp"
#include "app/session/view/view.hpp"
#include "app/session/wording/messages.hpp"
#include "cmake/precompiled/core.hpp"
#include "lessons/lesson/lesson.hpp"
