#include "app/panels/parts/characters.hpp"

#include <set>

#include "app/session/wording/messages.hpp"
#include "app/session/wording/text_width.hpp"
#include "lessons/lesson/in_language.hpp"
#include "render/fonts/fonts.hpp"

namespace jw::panels {

std::u32string characters_in(std::string_view text) {
    std::set<char32_t> characters;
    for (const char32_t c : from_utf8(text)) {
        if (c >= 0x80) { characters.insert(c); }
    }
    return {characters.begin(), characters.end()};
}

std::u32string characters_of(const Lesson& lesson) {
    std::string all = lesson.source + lesson.file_name;
    for_each_text(lesson, [&](const Text& text) { all += text; });
    for (const Body& body : lesson.mechanism.bodies) { all += body.name; }
    for (const Joint& joint : lesson.mechanism.joints) { all += joint.name; }
    for (const Driver& driver : lesson.mechanism.drivers) { all += driver.name; }
    return characters_in(all);
}

std::u32string characters_of_messages() {
    std::string all;
    for (const Language& one : languages()) {
        if (one.tag != language()) { continue; }
        all += one.name;
        for (std::size_t k = 1; k < one.messages.size(); ++k) { all += one.messages.translation(k); }
    }
    return characters_in(all);
}

std::string advice_for(std::u32string_view characters) {
    if (characters.empty()) { return {}; }
    const std::string package = render::package_of_missing_chinese();
    if (package.empty() || render::characters_without_glyph(characters).empty()) { return {}; }
    return tr("Some characters are shown as boxes: install the Debian package {0}", package);
}

}  // namespace jw::panels
