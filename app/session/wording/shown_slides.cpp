#include "app/session/wording/shown_slides.hpp"

#include <string_view>

#include "app/session/wording/messages.hpp"

namespace jw {

std::string shown_slides(const std::string& source) {
    constexpr std::string_view kOne = "slide ";
    constexpr std::string_view kSeveral = "slides ";
    if (source.starts_with(kOne)) { return tr("slide {0}", source.substr(kOne.size())); }
    if (source.starts_with(kSeveral)) { return tr("slides {0}", source.substr(kSeveral.size())); }
    return source;
}

}  // namespace jw
