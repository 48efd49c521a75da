#include "lessons/text/text.hpp"

namespace jw {

namespace {

void drop_line_feeds_of(std::string& text) {
    while (text.ends_with('\n')) { text.pop_back(); }
}

}  // namespace

void Text::show(std::string_view tag) {
    std::string own = this->own();
    own_.reset();
    for (; !tag.empty(); tag = tag.substr(0, tag.find('-') == std::string_view::npos ? 0 : tag.rfind('-'))) {
        const auto found = translations_.find(tag);
        if (found == translations_.end()) { continue; }
        std::string::operator=(found->second);
        own_ = std::move(own);
        return;
    }
    std::string::operator=(std::move(own));
}

void Text::drop_line_feeds() {
    drop_line_feeds_of(*this);
    if (own_) { drop_line_feeds_of(*own_); }
    for (auto& [tag, text] : translations_) { drop_line_feeds_of(text); }
}

bool same_in_all_languages(const Text& a, const Text& b) {
    return a.own() == b.own() && a.translations() == b.translations();
}

}  // namespace jw
