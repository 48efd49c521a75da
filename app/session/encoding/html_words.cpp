#include "app/session/encoding/html_words.hpp"

#include "app/session/encoding/xml_text.hpp"
#include "lessons/math/text_parts.hpp"
#include "lessons/math/write_math.hpp"

namespace jw {

std::string markup_text(std::string_view text) {
    std::string shown;
    for (const char c : xml_text(text)) {
        // between quotes of either kind, too
        shown += c == '"' ? std::string("&quot;") : c == '\'' ? std::string("&#39;") : std::string(1, c);
    }
    return shown;
}

std::string html_words(const std::string& words) {
    std::string html;
    for (const math::TextPart& part : math::text_parts(words).parts) {
        if (part.kind == math::TextPart::Kind::words) {
            for (const char c : markup_text(part.words)) {
                html += c == '\n' ? std::string("<br>\n") : std::string(1, c);
            }
        } else {
            html += math::write_mathml(part.row, part.kind == math::TextPart::Kind::display);
        }
    }
    return html;
}

std::string markdown_words(const std::string& words) {
    std::string text;
    for (const math::TextPart& part : math::text_parts(words).parts) {
        if (part.kind == math::TextPart::Kind::words) {
            text += part.words;
        } else {
            const std::string mark = part.kind == math::TextPart::Kind::display ? "$$" : "$";
            text += mark + math::write_latex(part.row) + mark;
        }
    }
    return text;
}

}  // namespace jw
