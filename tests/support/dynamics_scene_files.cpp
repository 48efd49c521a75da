#include "tests/support/dynamics_scene_texts.hpp"
#include "tests/support/dynamics_scenes.hpp"

namespace jw::test {

namespace {

/// A lesson of the course, with the questions, trials and summary of its author.
SceneFile lesson_of_course(std::string_view file, const Lesson& scene) {
    return {
        std::filesystem::path("catalogue/dynamics") / (std::string(file) + ".toml"),
        with_course_texts(scene, file)};
}

}  // namespace

std::vector<SceneFile> dynamics_scene_files() {
    // too many bodies to be explained joint by joint: for measurements
    const std::filesystem::path benchmark = "benchmark";
    return {
        lesson_of_course("simple-pendulum", simple_pendulum()),
        lesson_of_course("four-bar-1", n_four_bar(1)),
        lesson_of_course("four-bar-4", n_four_bar(4)),
        {benchmark / "four-bar-16.toml", n_four_bar(16)},
        {benchmark / "four-bar-40.toml", n_four_bar(40)},
        lesson_of_course("andrews", andrews_mechanism()),
        lesson_of_course("bricard-falling", falling_bricard()),
        lesson_of_course("governor", flyball_governor()),
        lesson_of_course("chain-revolute-4", chain(ChainJoint::revolute, 4)),
        {benchmark / "chain-revolute-16.toml", chain(ChainJoint::revolute, 16)},
        {benchmark / "chain-revolute-64.toml", chain(ChainJoint::revolute, 64)},
        lesson_of_course("chain-spherical-4", chain(ChainJoint::spherical, 4)),
        {benchmark / "chain-spherical-16.toml", chain(ChainJoint::spherical, 16)},
        {benchmark / "chain-spherical-64.toml", chain(ChainJoint::spherical, 64)},
        lesson_of_course("spatial-slider-crank-falling", falling_slider_crank()),
        lesson_of_course("spinning-top", spinning_top()),
        lesson_of_course("free-asymmetric-body", free_asymmetric_body()),
    };
}

}  // namespace jw::test
