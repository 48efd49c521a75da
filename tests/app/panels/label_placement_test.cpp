#include <random>

#include <catch2/catch.hpp>

#include "app/panels/frame/annotations.hpp"
#include "tests/app/panels/support.hpp"

namespace jw::panels::test {

namespace {

constexpr Box kArea{0.0F, 60.0F, 768.0F, 490.0F};
constexpr float kGap = 9.0F;

std::vector<Label> random_labels(unsigned seed, int count, float spread) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(-1.0F, 1.0F);
    std::vector<Label> labels;
    for (int k = 0; k < count; ++k) {
        Label label;
        label.at = {384.0F + spread * 380.0F * uniform(random), 305.0F + spread * 240.0F * uniform(random)};
        label.towards = {uniform(random), uniform(random)};
        label.width = 20.0F + 10.0F * uniform(random);
        label.height = 22.0F;
        label.optional = k % 5 == 4;
        labels.push_back(label);
    }
    return labels;
}

}  // namespace

TEST_CASE("labels never touch each other, a named point, or the edge", "[panels][labels]") {
    const auto seed = GENERATE(1U, 2U, 3U, 4U);
    const auto spread = GENERATE(0.05F, 0.3F, 1.0F);
    const std::vector<Label> labels = random_labels(seed, 24, spread);
    const std::vector<PlacedLabel> placed = place_labels(labels, {}, kArea, kGap);
    REQUIRE(placed.size() == labels.size());
    for (std::size_t a = 0; a < labels.size(); ++a) {
        if (!placed[a].shown) { continue; }
        CHECK(kArea.contains(placed[a].box));
        for (std::size_t b = 0; b < labels.size(); ++b) {
            CHECK((a == b || !placed[b].shown || !overlap(placed[a].box, placed[b].box)));
            CHECK((labels[b].optional || !placed[a].box.contains(labels[b].at)));
        }
    }
}

TEST_CASE("with room for all, all labels of vectors are shown", "[panels][labels]") {
    const std::vector<Label> labels = random_labels(GENERATE(1U, 2U, 3U), 12, 0.5F);
    const std::vector<PlacedLabel> placed = place_labels(labels, {}, kArea, kGap);
    for (std::size_t k = 0; k < labels.size(); ++k) { CHECK((labels[k].optional || placed[k].shown)); }
}

TEST_CASE("a label alone goes where there is room for it", "[panels][labels]") {
    const Label label{{300.0F, 300.0F}, {0.0F, -1.0F}, 20.0F, 20.0F, false};
    const PlacedLabel placed = place_labels({label}, {}, kArea, kGap)[0];
    REQUIRE(placed.shown);
    CHECK(placed.box.bottom() < 300.0F);
    CHECK(placed.box.centre().x == Approx(300.0F).margin(1.0));
    CHECK_FALSE(placed.far);
}

TEST_CASE("a label keeps off a drawn line if that costs little", "[panels][labels]") {
    const Label label{{300.0F, 300.0F}, {0.0F, -1.0F}, 20.0F, 20.0F, false};
    const Segment line{{300.0F, 300.0F}, {300.0F, 100.0F}};
    const PlacedLabel placed = place_labels({label}, {line}, kArea, kGap)[0];
    REQUIRE(placed.shown);
    CHECK_FALSE(crosses(line, placed.box));
}

TEST_CASE("names of bodies give way, vectors do not", "[panels][labels]") {
    // many names at one point: rings near it are soon full
    std::vector<Label> labels(12, Label{{300.0F, 300.0F}, {}, 60.0F, 20.0F, false});
    for (std::size_t k = 0; k < 6; ++k) { labels[k].optional = true; }
    const std::vector<PlacedLabel> placed = place_labels(labels, {}, kArea, kGap);
    int names = 0;
    for (std::size_t k = 0; k < 6; ++k) { names += placed[k].shown ? 1 : 0; }
    for (std::size_t k = 6; k < 12; ++k) { CHECK(placed[k].shown); }
    CHECK(names < 6);
}

TEST_CASE("points outside the picture are not named", "[panels][labels]") {
    const Label label{{-20.0F, 300.0F}, {}, 20.0F, 20.0F, false};
    CHECK_FALSE(place_labels({label}, {}, kArea, kGap)[0].shown);
}

TEST_CASE("a segment crosses a box that it enters, not one that it passes", "[panels][labels]") {
    const Box box{10.0F, 10.0F, 10.0F, 10.0F};
    CHECK(crosses({{0.0F, 0.0F}, {30.0F, 30.0F}}, box));
    CHECK(crosses({{15.0F, 15.0F}, {15.0F, 15.0F}}, box));
    CHECK(crosses({{15.0F, 0.0F}, {15.0F, 40.0F}}, box));
    CHECK_FALSE(crosses({{0.0F, 15.0F}, {5.0F, 15.0F}}, box));
    CHECK_FALSE(crosses({{0.0F, 25.0F}, {40.0F, 25.0F}}, box));
    CHECK_FALSE(crosses({{0.0F, 19.0F}, {19.0F, 40.0F}}, box));
}

}  // namespace jw::panels::test
