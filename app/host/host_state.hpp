#pragma once

#include <string>

#include "app/host/host.hpp"

namespace jw::host {

/// State of the interface as JSON: title, step, tab, what was tried, where the eye is, and a description for
/// those who do not see the picture.
std::string state_text(const Host& host);

}  // namespace jw::host
