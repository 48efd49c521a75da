#include "app/panels/plot/comparison.hpp"

#include <catch2/catch.hpp>

#include <cmath>

#include "tests/app/panels/support.hpp"

namespace jw::panels::test {

namespace {

std::vector<NewtonRun> four_newton_runs() {
    return {
        {"plain", {0.9, 1.4, 0.5, 0.03, 2e-4, 7e-9, 0.0}, 2.02, true, false, {30.0, 28.6, 5.0}},
        {"damped", {0.9, 0.7, 0.2, 5e-3, 3e-5, 1e-9, 2e-16}, 1.98, true, false, {10.0, 8.0}},
        {"Levenberg–Marquardt", {0.9, 0.6, 0.4, 0.1, 4e-16}, std::nullopt, true, true, {12.0}},
        {"a method with a name that is too long for its column",
         std::vector<double>(61, 0.9),
         std::nullopt,
         false,
         false,
         {}}};
}

}  // namespace

TEST_CASE("methods are compared by what they took and where they ended", "[panels][newton]") {
    const NewtonComparison comparison = compare(four_newton_runs());
    REQUIRE(comparison.rows.size() == 4);
    CHECK(comparison.rows[0].iterations == 6);
    CHECK(comparison.rows[0].phi_norm == 0.0);
    CHECK(comparison.rows[0].order == "2.0");
    CHECK(comparison.rows[0].turn == "30.0°");
    CHECK(comparison.rows[0].verdict == "closed");
    CHECK(comparison.rows[2].verdict == "wrong branch");
    CHECK(comparison.rows[2].order == "–");
    CHECK(comparison.rows[3].verdict == "did not converge");
    // a wrong branch is no success, however soon it was reached
    CHECK(comparison.summary.starts_with("Fewest iterations, 6: plain and damped."));
    CHECK(comparison.residuals.at.size() == 61);
    CHECK(std::isnan(comparison.residuals.series[0].values[7]));
    CHECK(compare({}).summary.empty());
    CHECK(compare({four_newton_runs()[3]}).summary.starts_with("No method closed it"));
}

TEST_CASE("the comparison stays in its box, whatever is compared", "[panels][newton]") {
    Surface surface;
    for (const std::vector<NewtonRun>& runs :
         {four_newton_runs(), std::vector<NewtonRun>{},
          std::vector<NewtonRun>{{"none", {}, {}, false, false, {}}},
          std::vector<NewtonRun>(30, four_newton_runs()[0])}) {
        for (const Box& box : kPlaces) {
            CAPTURE(runs.size(), box.width, box.height);
            surface.clear();
            PlotState state;
            state.hovered = 1;
            state.cursor = 2;
            const auto layout = newton_comparison_panel(surface.canvas(), box, compare(runs), state);
            CHECK(with_fringe(box).contains(surface.drawn()));
            CHECK(layout.rows.size() <= runs.size());
            for (const Box& row : layout.rows) { CHECK(box.contains(row)); }
        }
    }
}

TEST_CASE("where there is room for it the plot shows every method", "[panels][newton]") {
    const Surface surface;
    const auto layout = newton_comparison_panel(
        surface.canvas(), {0.0F, 0.0F, 480.0F, 520.0F}, compare(four_newton_runs()), {});
    REQUIRE(layout.plot.panes.size() == 1);
    CHECK(layout.plot.panes[0].series.size() == 4);
    CHECK(layout.plot.panes[0].plot.height > 150.0F);
}

}  // namespace jw::panels::test
