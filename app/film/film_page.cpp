#include "app/film/film_page.hpp"

#include <sstream>

#include "app/film/captions.hpp"
#include "app/film/film_page_parts.hpp"
#include "app/session/encoding/base64.hpp"
#include "app/session/encoding/xml_text.hpp"
#include "app/session/output/json.hpp"
#include "app/session/wording/messages.hpp"
#include "render/animation/animation.hpp"
#include "render/files/png.hpp"

namespace jw::film {

namespace {

// a jump into the motion draws at most this many parts, which takes a fraction of a second
constexpr std::size_t kMostBetween = 24;

/// Pictures as parts: a whole one at intervals, and between them only the area that has changed.
class Parts {
public:
    void add(const FilmPicture& picture, render::Image image) {
        const bool is_whole = !before_ || since_whole_ + 1 >= kMostBetween;
        const auto area = is_whole
                              ? render::PixelArea{0, 0, image.width, image.height}
                              : render::changed_area(*before_, image).value_or(render::PixelArea{0, 0, 1, 1});
        const render::Image part = is_whole || !image.alpha.empty()
                                       ? render::cut_out(image, area)
                                       : render::changes_within(area, *before_, image);
        since_whole_ = is_whole ? 0 : since_whole_ + 1;
        parts_.push_back(
            {{"step", picture.step},
             {"seconds", picture.seconds},
             {"whole", is_whole},
             {"x", area.x},
             {"y", area.y},
             {"png", base64(render::encode_png(part))}});
        before_ = std::move(image);
    }
    Json& json() { return parts_; }

private:
    Json parts_ = Json::array();
    std::optional<render::Image> before_;
    std::size_t since_whole_ = 0;
};

Json lines_of(const std::string& text) {
    Json lines = Json::array();
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) { lines.push_back(line); }
    return lines;
}

/// Text of each step that is shown, by its number.
Json captions_by_step(const Story& story, const std::vector<FilmPicture>& pictures) {
    Json captions = Json::object();
    for (const FilmPicture& picture : pictures) {
        Json& lines = captions[std::to_string(picture.step)];
        if (lines.is_null()) {
            lines = lines_of(caption_of(view_of(story, picture.step, ViewParts::without_matrix)));
        }
    }
    return captions;
}

Json chapters_json(const std::vector<Chapter>& chapters) {
    Json json = Json::array();
    for (const Chapter& chapter : chapters) {
        json.push_back({{"title", chapter.title}, {"from", chapter.from}});
    }
    return json;
}

/// JSON for a script of the page, escaped so that it cannot end the script.
std::string in_script(const Json& json) {
    std::string text;
    for (const char c : json_document(json, -1)) {
        if (c == '<') {
            text += "\\u003c";
        } else {
            text += c;
        }
    }
    return text;
}

}  // namespace

std::string film_page(
    const Story& story, const std::vector<FilmPicture>& pictures,
    const std::function<render::Image(std::size_t)>& picture) {
    Parts parts;
    int width = 0;
    int height = 0;
    bool is_opaque = true;
    for (std::size_t k = 0; k < pictures.size(); ++k) {
        render::Image image = picture(k);
        width = image.width;
        height = image.height;
        is_opaque = image.alpha.empty();
        parts.add(pictures[k], std::move(image));
    }
    const Json film{
        {"width", width},
        {"height", height},
        {"opaque", is_opaque},
        {"chapters", chapters_json(chapters_of(story, pictures))},
        {"captions", captions_by_step(story, pictures)},
        {"pictures", std::move(parts.json())}};
    const std::string title = xml_text(caption_title(story));
    std::string page = "<!doctype html>\n<html lang=\"" + std::string(language()) +
                       "\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
                       title + "</title>\n<style>\n";
    page += kPageStyle;
    page += "</style>\n</head>\n<body>\n<main>\n<h1>" + title + "</h1>\n";
    page +=
        "<noscript><p>This page moves with JavaScript, which is off here.</p></noscript>\n</main>\n"
        "<script type=\"application/json\" id=\"film\">";
    page += in_script(film);
    page += "</script>\n<script>\n";
    page += kPageScript;
    page += "</script>\n</body>\n</html>\n";
    return page;
}

}  // namespace jw::film
