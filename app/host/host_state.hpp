#pragma once

#include <string>

#include "app/host/host.hpp"

namespace jw::host {

/// State of the interface as JSON: title, step, tab, experiments, camera, and a description for people who
/// do not see the picture.
std::string state_text(const Host& host);

}  // namespace jw::host
