#pragma once

#include <span>
#include <string>
#include <string_view>

/// Names that authors try instead of a key: symbols of the book, words of other programs.
namespace jw {

struct OtherName {
    std::string_view tried;
    std::string_view meant;  ///< a key, without the unit at its end
};

std::span<const OtherName> other_names();

/// The key that an author who typed `tried` meant; empty if it is not among `keys`.
std::string key_meant_by(std::string_view tried, std::span<const std::string> keys);

}  // namespace jw
