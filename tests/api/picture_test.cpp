#include <catch2/catch.hpp>

#include <fstream>

#include "jointwise/picture.hpp"
#include "tests/support/temporary_folder.hpp"

namespace jointwise::test {
namespace {

/// Pixels that differ by more than the gradient of the backdrop can.
int different(const Image& a, const Image& b) {
    int count = 0;
    for (std::size_t k = 0; k < a.rgb.size(); k += 3) { count += std::abs(a.rgb[k] - b.rgb[k]) > 16 ? 1 : 0; }
    return count;
}

Mechanism pendulum() {
    Mechanism m;
    m.add_body("rod", {0.5, 0.0, 0.0});
    m.add_joint("pin", "revolute", 0, 1, {.at = Vector3::Zero(), .axis = Vector3::UnitY()});
    return m;
}

}  // namespace

TEST_CASE("A picture shows the pose that was asked for, and twice the same", "[api]") {
    const Mechanism m = pendulum();
    const Image level = draw(m, start_pose(m), 320, 180);
    REQUIRE(level.rgb.size() == 3U * 320U * 180U);
    CHECK(draw(m, start_pose(m), 320, 180).rgb == level.rgb);
    Pose hanging = start_pose(m);
    hanging.r[1] = {0.0, 0.0, -0.5};
    hanging.p[1] = Vector4(1.0, 0.0, 1.0, 0.0).normalized();
    // a rod covers some percent of the picture: it has left one place and has come to another
    CHECK(different(draw(m, hanging, 320, 180), level) > 320 * 180 / 100);
}

TEST_CASE("A lesson is drawn with its own shapes and written as PNG", "[api]") {
    const jw::test::TemporaryFolder folder;
    const Lesson lesson = read_lesson(JW_SOURCE_ROOT "/lessons/catalogue/loops/four-bar.toml");
    const Pose pose = assemble(lesson.mechanism());
    const Image image = draw(lesson, pose, 640, 360);
    CHECK(different(image, draw(lesson.mechanism(), pose, 640, 360)) > 0);
    write_png(image, folder.path() / "four-bar.png");
    std::ifstream file(folder.path() / "four-bar.png", std::ios::binary);
    char head[4] = {};
    file.read(head, 4);
    CHECK(std::string(head + 1, 3) == "PNG");
    CHECK_THROWS(write_png(image, folder.path() / "no" / "folder.png"));
}

}  // namespace jointwise::test
