#pragma once

#include <string>
#include <vector>

#include "app/film/film_pictures.hpp"
#include "app/session/view/view.hpp"

/// Captions and chapters of a film: its text in addition to its pictures.
namespace jw::film {

/// Text that is shown below the pictures for some time.
struct Caption {
    double from = 0.0;  ///< [s]
    double to = 0.0;
    std::string text;  ///< lines of Unicode, also for formulas
};

/// A part of a film to jump to: a joint, a driver, the motion.
struct Chapter {
    double from = 0.0;  ///< [s]
    double to = 0.0;
    std::string title;
};

/// Text of a step as lines of Unicode: its title, what happened, the text of the author; or a question with
/// its choices. A moment of the motion has only title and text of the author, without its numbers.
std::string caption_of(const View& view);

/// Title of the lesson in one line of Unicode.
std::string caption_title(const Story& story);

/// Captions of all pictures, without gaps.
std::vector<Caption> captions_of(const Story& story, const std::vector<FilmPicture>& pictures);
std::vector<Chapter> chapters_of(const Story& story, const std::vector<FilmPicture>& pictures);

/// WebVTT, as players and browsers read it.
std::string webvtt(const std::vector<Caption>& captions);
/// Title and chapters as ffmpeg reads them.
std::string ffmetadata(const std::string& title, const std::vector<Chapter>& chapters);

}  // namespace jw::film
