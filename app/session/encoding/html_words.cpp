#include "app/session/encoding/html_words.hpp"

#include "app/session/encoding/xml_text.hpp"
#include "lessons/math/text_parts.hpp"
#include "lessons/math/write_math.hpp"

namespace jw {

std::string markup_text(std::string_view text) {
    std::string shown;
    for (const char c : xml_text(text)) {
        // both kinds of quotes, since the text may be an attribute
        shown += c == '"' ? std::string("&quot;") : c == '\'' ? std::string("&#39;") : std::string(1, c);
    }
    return shown;
}

std::string html_words(const std::string& words) {
    std::string html;
    for (const math::TextPart& part : math::text_parts(words).parts) {
        switch (part.kind) {
            case math::TextPart::Kind::words:
                for (const char c : markup_text(part.words)) {
                    html += c == '\n' ? std::string("<br>\n") : std::string(1, c);
                }
                break;
            case math::TextPart::Kind::code: html += "<code>" + markup_text(part.words) + "</code>"; break;
            case math::TextPart::Kind::formula: html += math::write_mathml(part.row, false); break;
            case math::TextPart::Kind::display: html += math::write_mathml(part.row, true); break;
        }
    }
    return html;
}

std::string markdown_words(const std::string& words) {
    std::string text;
    for (const math::TextPart& part : math::text_parts(words).parts) {
        switch (part.kind) {
            case math::TextPart::Kind::words: text += part.words; break;
            case math::TextPart::Kind::code: text += '`' + part.words + '`'; break;
            case math::TextPart::Kind::formula: text += '$' + math::write_latex(part.row) + '$'; break;
            case math::TextPart::Kind::display: text += "$$" + math::write_latex(part.row) + "$$"; break;
        }
    }
    return text;
}

}  // namespace jw
