#pragma once

#include <string>

#include "app/host/host.hpp"

/// Checks that must hold at any time, whatever a person did.
namespace jw::test {

/// The first thing that is wrong, empty if nothing is: numbers that are not finite, an index out of range,
/// a matrix of another size than its labels, vertices nowhere.
std::string fault_of(const host::Host& host);

/// Contents of a view as text with all digits: equal texts are equal views.
std::string text_of(const View& view);

}  // namespace jw::test
