#include "app/session/story/story.hpp"
#include "app/session/output/describe.hpp"
#include "app/session/output/json.hpp"
#include "app/session/picture/picture.hpp"
#include "app/session/view/view.hpp"
#include "lessons/read/reader.hpp"
#include "tests/fuzz/targets.hpp"

namespace jw::fuzz {

namespace {

// a lesson takes longer with every body and joint; what is promised here does not depend on their number
constexpr std::size_t kMostBodies = 6;
constexpr std::size_t kMostAdditions = 8;

bool is_small(const Mechanism& m) {
    return m.bodies.size() <= kMostBodies && m.joints.size() + m.drivers.size() <= kMostAdditions;
}

}  // namespace

bool check_story(const std::string& input) {
    const ReadResult read = read_lesson(input, "input.toml");
    if (!read.lesson || !is_small(read.lesson->mechanism)) { return false; }
    StoryOptions options;
    options.with_motion = false;
    const Story story(*read.lesson, options);
    promise(!story.steps().empty(), "a story has steps");
    const PictureStyle style = picture_style(story);
    promise(
        style.bounds.lowest().allFinite() && style.bounds.highest().allFinite(),
        "what is drawn is somewhere");
    for (int k = 0; k < static_cast<int>(story.steps().size()); ++k) {
        promise(!describe(view_of(story, k)).empty(), "a step has a text");
        promise(!picture_of(story, style, k).scene.shapes.empty(), "a step has something to draw");
    }
    const int last = static_cast<int>(story.steps().size()) - 1;
    const Json json = Json::parse(json_document(json_of(story, last)), nullptr, false);
    promise(json.is_object() || json.is_array(), "a story has a JSON document");
    return true;
}

}  // namespace jw::fuzz
