#include "app/film/captions.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "app/session/encoding/html_words.hpp"
#include "app/session/story/timeline.hpp"
#include "app/session/wording/text_width.hpp"
#include "lessons/math/text_parts.hpp"

namespace jw::film {

namespace {

/// A text in plain Unicode, in one line.
std::string line_of(const std::string& words) { return in_one_line(math::plain_words(words)); }

std::string text_of(const QuestionView& question) {
    std::string text = line_of(question.ask);
    if (!question.answered) {
        for (std::size_t k = 0; k < question.choices.size(); ++k) {
            text += "\n" + std::to_string(k + 1) + ") " + line_of(question.choices[k]);
        }
        return text;
    }
    return text + "\n" + line_of(question.answer) +
           (question.why.empty() ? "" : "\n" + line_of(question.why));
}

std::string clock_text(double seconds) {
    const long long all = std::llround(seconds * 1000.0);
    std::array<char, 48> text{};
    std::snprintf(
        text.data(), text.size(), "%02lld:%02lld:%02lld.%03lld", all / 3600000, all / 60000 % 60,
        all / 1000 % 60, all % 1000);
    return text.data();
}

/// A value of ffmetadata, with a backslash before special characters.
std::string escaped(const std::string& text) {
    std::string value;
    for (const char c : text) {
        if (std::string_view("=;#\\\n").find(c) != std::string_view::npos) { value += '\\'; }
        value += c;
    }
    return value;
}

}  // namespace

std::string caption_of(const View& view) {
    if (view.question) { return text_of(*view.question); }
    std::string text;
    for (const std::string& line :
         {line_of(view.title), view.kind == Step::Kind::motion ? "" : line_of(view.sentence),
          line_of(view.author_text)}) {
        if (!line.empty()) { text += (text.empty() ? "" : "\n") + line; }
    }
    return text;
}

std::string caption_title(const Story& story) { return line_of(story.lesson().title); }

std::vector<Caption> captions_of(const Story& story, const std::vector<FilmPicture>& pictures) {
    std::vector<Caption> captions;
    double time = 0.0;
    int step = -1;
    for (const FilmPicture& picture : pictures) {
        const double end = time + picture.seconds;
        if (picture.step != step) {
            std::string text = caption_of(view_of(story, picture.step, ViewParts::without_matrix));
            if (captions.empty() || captions.back().text != text) {
                captions.push_back({time, end, std::move(text)});
            }
        }
        step = picture.step;
        captions.back().to = end;
        time = end;
    }
    return captions;
}

std::vector<Chapter> chapters_of(const Story& story, const std::vector<FilmPicture>& pictures) {
    const std::vector<Stretch> stretches = stretches_of(story);
    std::vector<Chapter> chapters;
    std::size_t place = stretches.size();
    double time = 0.0;
    for (const FilmPicture& picture : pictures) {
        std::size_t now = 0;
        while (stretches[now].last < picture.step) { ++now; }
        if (now != place) { chapters.push_back({time, time, stretches[now].name}); }
        place = now;
        time += picture.seconds;
        chapters.back().to = time;
    }
    return chapters;
}

std::string webvtt(const std::vector<Caption>& captions) {
    std::string text = "WEBVTT\n";
    for (const Caption& caption : captions) {
        // an arrow "-->" in a text would be read as that of a time range: its '>' is escaped
        text += "\n" + clock_text(caption.from) + " --> " + clock_text(caption.to) + "\n" +
                xml_text(caption.text) + "\n";
    }
    return text;
}

std::string ffmetadata(const std::string& title, const std::vector<Chapter>& chapters) {
    std::string text = ";FFMETADATA1\ntitle=" + escaped(line_of(title)) + "\n";
    for (const Chapter& chapter : chapters) {
        text += "\n[CHAPTER]\nTIMEBASE=1/1000\nSTART=" + std::to_string(std::llround(1000.0 * chapter.from)) +
                "\nEND=" + std::to_string(std::llround(1000.0 * chapter.to)) +
                "\ntitle=" + escaped(chapter.title) + "\n";
    }
    return text;
}

}  // namespace jw::film
