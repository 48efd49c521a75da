
#include <catch2/catch.hpp>

#include "app/panels/column/panels.hpp"
#include "tests/app/panels/support.hpp"
#include "tests/app/panels/views.hpp"

namespace jw::panels::test {

namespace {

using Kind = Step::Kind;

Block fixed(float height) {
    return {[height](const Canvas&, const Box&, Density) { return height; }};
}

Block filling(float least, float good, float wish, int given_up = 0) {
    Block block = fixed(0.0F);
    block.fills = true;
    block.least = {least, least, least};
    block.good = good;
    block.wish = wish;
    block.given_up = given_up;
    return block;
}

}  // namespace

TEST_CASE("blocks keep their order and their distance, and end within the column", "[panels][column]") {
    const Surface surface;
    const Box box{10.0F, 20.0F, 400.0F, 600.0F};
    const Arrangement arrangement =
        arrange(surface.canvas(), box, {fixed(100.0F), fixed(0.0F), filling(50.0F, 200.0F, 5000.0F)});
    REQUIRE(arrangement.boxes.size() == 3);
    CHECK(arrangement.boxes[0].height == 100.0F);
    CHECK(arrangement.boxes[1].height == 0.0F);
    CHECK(arrangement.boxes[2].y > arrangement.boxes[0].bottom());
    CHECK(arrangement.boxes[2].bottom() == Approx(box.bottom()).margin(1.0));
}

TEST_CASE("all blocks that fill get a good height before one gets its best", "[panels][column]") {
    const Surface surface;
    const Arrangement arrangement = arrange(
        surface.canvas(), {0.0F, 0.0F, 400.0F, 600.0F},
        {filling(50.0F, 100.0F, 1000.0F), filling(50.0F, 120.0F, 1000.0F)});
    CHECK(arrangement.boxes[1].height == 120.0F);
    CHECK(arrangement.boxes[0].height > 400.0F);
}

TEST_CASE("where there is no room, what may go goes, the least important first", "[panels][column]") {
    const Surface surface;
    const Box box{0.0F, 0.0F, 400.0F, 600.0F};
    const Arrangement arrangement = arrange(
        surface.canvas(), box,
        {fixed(400.0F), filling(150.0F, 150.0F, 150.0F, 3), filling(150.0F, 150.0F, 150.0F, 2)});
    CHECK(arrangement.boxes[1].height == 150.0F);
    CHECK(arrangement.boxes[2].height == 0.0F);
}

TEST_CASE("panels fit the column at every size, whatever the step", "[panels][column]") {
    const auto size =
        GENERATE(Size{1280, 720}, Size{1920, 1080}, Size{960, 540}, Size{1024, 768}, Size{2560, 1080});
    const Surface surface(size);
    const Box box = shrunk(layout_of(size.width, size.height).column, 16.0F, 14.0F);
    for (const Kind kind :
         {Kind::bodies, Kind::equations, Kind::iteration, Kind::assembled, Kind::failed, Kind::motion}) {
        for (const View& view : {four_bar(kind), screw(kind), only_bodies(kind), overlong(kind)}) {
            CAPTURE(size.width, size.height, static_cast<int>(kind), view.matrix.rows.size());
            const Canvas canvas = surface.canvas();
            const Arrangement arrangement = arrange(canvas, box, blocks_of(canvas, view));
            float from = box.y;
            for (const Box& part : arrangement.boxes) {
                if (part.height <= 0.0F) { continue; }
                CHECK(part.y >= from);
                from = part.bottom();
            }
            CHECK(from <= box.bottom());
        }
    }
}

TEST_CASE("a panel takes the height that it was measured to take", "[panels][column]") {
    Surface surface;
    const Box box{780.0F, 100.0F, 480.0F, 0.0F};
    const auto density = GENERATE(Density::roomy, Density::compact, Density::tight, Density::bare);
    for (const View& view : {four_bar(Kind::equations), screw(Kind::equations)}) {
        surface.clear();
        const float measured = equations_panel(surface.canvas().measuring(), box, view.equations, density);
        CHECK(surface.vertices() == 0);
        CHECK(equations_panel(surface.canvas(), box, view.equations, density) == measured);
        // the mark behind the choice reaches a little to the left
        const Box taken{box.x - 5.0F, box.y, box.width + 5.0F, measured};
        CHECK(with_fringe(taken).contains(surface.drawn()));
    }
}

}  // namespace jw::panels::test
