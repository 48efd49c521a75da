#include "tests/support/dynamics_scenes.hpp"

namespace jw::test {

std::vector<SceneFile> dynamics_scene_files() {
    const std::filesystem::path catalogue = "catalogue/dynamics";
    // too many bodies to be told joint by joint: to measure with
    const std::filesystem::path benchmark = "benchmark";
    return {
        {catalogue / "simple-pendulum.toml", simple_pendulum()},
        {catalogue / "four-bar-1.toml", n_four_bar(1)},
        {catalogue / "four-bar-4.toml", n_four_bar(4)},
        {benchmark / "four-bar-16.toml", n_four_bar(16)},
        {benchmark / "four-bar-40.toml", n_four_bar(40)},
        {catalogue / "andrews.toml", andrews_mechanism()},
        {catalogue / "bricard-falling.toml", falling_bricard()},
        {catalogue / "governor.toml", flyball_governor()},
        {catalogue / "chain-revolute-4.toml", chain(ChainJoint::revolute, 4)},
        {benchmark / "chain-revolute-16.toml", chain(ChainJoint::revolute, 16)},
        {benchmark / "chain-revolute-64.toml", chain(ChainJoint::revolute, 64)},
        {catalogue / "chain-spherical-4.toml", chain(ChainJoint::spherical, 4)},
        {benchmark / "chain-spherical-16.toml", chain(ChainJoint::spherical, 16)},
        {benchmark / "chain-spherical-64.toml", chain(ChainJoint::spherical, 64)},
        {catalogue / "spatial-slider-crank-falling.toml", falling_slider_crank()},
        {catalogue / "spinning-top.toml", spinning_top()},
        {catalogue / "free-asymmetric-body.toml", free_asymmetric_body()},
    };
}

}  // namespace jw::test
