#include "app/panels/plot/comparison.hpp"

#include <catch2/catch.hpp>

#include <cmath>

#include "tests/app/panels/support.hpp"

namespace jw::panels::test {

namespace {

BenchRun run(Method method, double cost, double failed_from) {
    BenchRun out;
    out.method = method;
    for (int digits = 1; digits <= 12; ++digits) {
        BenchPoint point;
        point.cpu = cost * digits;
        point.position = digits < failed_from ? std::pow(10.0, -digits) : std::nan("");
        out.points.push_back(point);
    }
    return out;
}

std::vector<BenchRun> four_runs() {
    return {
        run(Method::explicit_5, 1e-4, 8), run(Method::explicit_8, 2e-4, 20), run(Method::implicit_5, 1e-3, 0),
        run(Method::implicit_9, 123.456, 20)};
}

}  // namespace

TEST_CASE("the prices stay in their box, whatever was measured", "[panels][prices]") {
    Surface surface;
    for (const std::vector<BenchRun>& runs :
         {four_runs(), std::vector<BenchRun>{}, std::vector<BenchRun>{run(Method::explicit_8, 1.0, 0)},
          std::vector<BenchRun>(30, four_runs()[0])}) {
        for (const Box& box : kPlaces) {
            CAPTURE(runs.size(), box.width, box.height);
            surface.clear();
            PlotState state;
            state.hovered = 1;
            const auto layout = price_panel(surface.canvas(), box, prices_of(runs), "andrews", state);
            CHECK(with_fringe(box).contains(surface.drawn()));
            CHECK(layout.rows.size() <= runs.size());
            for (const Box& row : layout.rows) { CHECK(box.contains(row)); }
        }
    }
}

TEST_CASE("where there is room for it the plot has a curve for every method", "[panels][prices]") {
    const Surface surface;
    const auto layout =
        price_panel(surface.canvas(), {0.0F, 0.0F, 480.0F, 560.0F}, prices_of(four_runs()), "", {});
    CHECK(layout.rows.size() == 4);
    REQUIRE(layout.plot.panes.size() == 1);
    CHECK(layout.plot.panes[0].series.size() == 4);
    CHECK(layout.plot.panes[0].plot.height > 150.0F);
}

}  // namespace jw::panels::test
