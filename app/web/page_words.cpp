#include "app/web/page_words.hpp"

#include <array>

#include "app/session/output/json.hpp"
#include "app/session/wording/messages.hpp"

namespace jw::web {

namespace {

constexpr std::array kWords{
    tr_later("Lessons"),
    tr_later("Step back"),
    tr_later("Next step"),
    tr_later("Play"),
    tr_later("Fit"),
    tr_later("Undo"),
    tr_later("Redo"),
    tr_later("Edit the text"),
    tr_later("Copy link"),
    tr_later("Text of the step"),
    tr_later("Full screen"),
    tr_later("Keys"),
    tr_later("Stop"),
    tr_later("Open …"),
    tr_later("Save"),
    tr_later("Close"),
    tr_later("A link to what you see was copied."),
    tr_later("The browser does not let this page write into the clipboard."),
    tr_later("Reload the page to see the letters of this language."),
    tr_later("The graphics card is not available at the moment; waiting for it."),
    tr_later(
        "The browser cannot store more: its storage is full or not allowed. Save what you need as a file."),
    tr_later("The list of lessons is shown. Arrows choose, Enter opens."),
};

}  // namespace

std::string words_of_page() {
    Json words = Json::object();
    for (const char* english : kWords) { words[english] = tr(english); }
    return json_document(words, -1);
}

}  // namespace jw::web
