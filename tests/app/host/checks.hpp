#pragma once

#include <string>

#include "app/host/host.hpp"

/// What must hold at any time, whatever somebody did.
namespace jw::test {

/// The first thing that is wrong, empty if nothing is: numbers that are not finite, an index out of range,
/// a matrix of another size than its labels, vertices nowhere.
std::string fault_of(const host::Host& host);

/// Everything of a view, numbers in full: equal texts are equal views.
std::string text_of(const View& view);

}  // namespace jw::test
