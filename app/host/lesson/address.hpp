#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/camera.hpp"

/// Addresses of what the window shows: `four-bar/12?try=form+D+drop+x&tab=plots`. They stand behind the # of
/// a page's address and after `jointwise open`; docs/command-line.md describes them.
namespace jw::host {

/// State of the window: a lesson as it was written, what was tried with it, a place in it, tab and camera.
/// Whatever is empty is as when the lesson is opened.
struct Address {
    std::string lesson;  ///< "four-bar", "loops/four-bar", "mine.toml"; empty: the list of lessons
    std::string at;      ///< a place as step_at (app/session/story/timeline.hpp) finds it: "12", "D", "t=0.5"
    std::vector<std::string> experiments;  ///< sentences (app/session/try/experiment_text.hpp)
    std::string joint;                     ///< whose vectors and equations were asked for
    std::string tab;                       ///< a word of kTabs
    std::string exercise;  ///< name of one of the lesson; it stands in the tab of exercises, and at no place
    std::optional<render::Camera> camera;

    bool operator==(const Address&) const = default;
};

/// Whether an address can hold this camera: an eye apart from what it looks at, no larger numbers than
/// lessons have.
bool can_be_told(const render::Camera& camera);

/// The address as text, every number exact; empty for the list of lessons.
/// @throws std::invalid_argument for a camera that cannot be told, and for parts without a lesson
std::string fragment_of(const Address& address);

/// Reads what fragment_of has written; also behind a `#`, and behind the # of a whole URL.
/// @throws std::runtime_error saying what is wrong, at which character, and what was expected. Whether there
/// is
///         such a lesson, place or experiment is found out by whoever goes there.
Address read_address(std::string_view text);

}  // namespace jw::host
