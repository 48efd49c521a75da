#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/scene/camera.hpp"

/// Addresses of states of the window: `four-bar/12?try=form+D+drop+x&tab=plots`. They follow the # of a
/// page's URL, or `jointwise open`; docs/command-line.md describes them.
namespace jw::host {

/// State of the window: a lesson as it was written, experiments with it, a place in it, tab and camera. An
/// empty part is as when the lesson is opened.
struct Address {
    std::string lesson;  ///< "four-bar", "loops/four-bar", "mine.toml"; empty: the list of lessons
    std::string at;      ///< a place as step_at (app/session/story/timeline.hpp) finds it: "12", "D", "t=0.5"
    std::vector<std::string> experiments;  ///< sentences (app/session/try/experiment_text.hpp)
    std::string joint;                     ///< whose vectors and equations are shown
    std::string tab;                       ///< a word of kTabs
    std::string exercise;  ///< its name; then the tab is that of exercises, and there is no place
    std::optional<render::Camera> camera;

    bool operator==(const Address&) const = default;
};

/// True if an address can describe this camera: eye and target differ, and the numbers are not larger than
/// lessons allow.
bool can_be_told(const render::Camera& camera);

/// The address as text, with exact numbers; empty for the list of lessons.
/// @throws std::invalid_argument for a camera that cannot be described, and for parts without a lesson
std::string fragment_of(const Address& address);

/// Reads a text of fragment_of, which may also follow a `#`, or the # of a whole URL.
/// @throws std::runtime_error that says what is wrong, at which character, and what was expected. Whether the
///         lesson, the place and the experiments exist is not checked here.
Address read_address(std::string_view text);

}  // namespace jw::host
