#include "app/panels/plot/plot.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include "app/panels/plot/plot_parts.hpp"
#include "tests/app/panels/support.hpp"

namespace jw::panels::test {

namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

/// Points on [0, 3] s, each the story's step 10 + k.
SeriesSet points(int count) {
    SeriesSet set;
    set.axis = "t [s]";
    for (int k = 0; k < count; ++k) {
        set.at.push_back(3.0 * k / std::max(1, count - 1));
        set.steps.push_back(10 + k);
    }
    return set;
}

template <class Function>
void add(SeriesSet& set, const std::string& name, const std::string& unit, const Function& f) {
    Series series{name, unit, {}, 0.0, false};
    for (const double t : set.at) { series.values.push_back(f(t)); }
    set.telling.push_back(static_cast<int>(set.series.size()));
    set.series.push_back(std::move(series));
}

SeriesSet waves() {
    SeriesSet set = points(200);
    add(set, "coupler.r_dot.x", "m/s", [](double t) { return std::sin(3.0 * t); });
    add(set, "coupler.r_dot.y", "m/s", [](double t) { return std::cos(3.0 * t); });
    add(set, "crank.angle", "deg", [](double t) { return 120.0 * t; });
    set.marks = {
        {1.0, "sleeve p1: x is left out", "sleeve switches"},
        {1.05, "wrist p1: x is left out", "wrist switches"},
        {3.0, "change point"}};
    return set;
}

/// More curves than there is room for names, all ending at the same place.
SeriesSet crowd() {
    SeriesSet set = points(40);
    for (int k = 0; k < 40; ++k) {
        add(set, "a body with a long name." + std::to_string(k), "m",
            [k](double t) { return k * (3.0 - t); });
    }
    return set;
}

SeriesSet logarithmic() {
    SeriesSet set = points(20);
    set.axis = "iteration";
    set.logarithmic = true;
    add(set, "A", "-", [](double t) { return t < 1.0 ? std::pow(10.0, -12.0 * t) : kNothing; });
    add(set, "B", "-",
        [](double t) { return t < 1.0 || t > 2.0 ? kNothing : std::pow(10.0, -20.0 * (t - 1.0)); });
    add(set, "motor", "-", [](double t) { return t < 2.0 ? kNothing : (t < 2.9 ? 0.1 : 0.0); });
    return set;
}

/// Three units, numbers of all sizes, infinities.
SeriesSet extremes() {
    SeriesSet set = points(50);
    add(set, "huge", "N", [](double t) { return 3e300 * (t - 1.5); });
    add(set, "tiny", "m", [](double t) { return 1e-300 * t; });
    add(set, "offset", "s", [](double t) { return 1e9 + t; });
    add(set, "wild", "m", [](double t) { return t < 1.0 ? HUGE_VAL : (t < 2.0 ? kNothing : -HUGE_VAL); });
    return set;
}

SeriesSet single() {
    SeriesSet set = points(1);
    add(set, "one", "m", [](double) { return 3.5; });
    return set;
}

SeriesSet nothing() {
    SeriesSet set;
    set.axis = "t [s]";
    set.why_empty = "Nothing moves here: the lesson ends once the mechanism is assembled.";
    return set;
}

const std::vector<SeriesSet>& all_sets() {
    static const std::vector<SeriesSet> sets{waves(),    crowd(),  logarithmic(),
                                             extremes(), single(), nothing()};
    return sets;
}

/// Every text of a layout.
std::vector<Box> texts_of(const PlotLayout& layout) {
    std::vector<Box> boxes;
    for (const PlotMark& mark : layout.marks) {
        if (!mark.text.empty()) { boxes.push_back(mark.box); }
    }
    for (const PlotPane& pane : layout.panes) {
        for (const PlotLabel& label : pane.labels) { boxes.push_back(label.box); }
        for (const PlotLabel& value : pane.values) { boxes.push_back(value.box); }
    }
    return boxes;
}

const Box kBoxes[] = {
    {10.0F, 20.0F, 480.0F, 260.0F}, {5.0F, 5.0F, 760.0F, 420.0F}, {0.0F, 0.0F, 1500.0F, 800.0F}};

}  // namespace

TEST_CASE("a plot stays in its box and its texts apart, whatever is plotted", "[panels][plot]") {
    Surface surface;
    for (const Box& box : kBoxes) {
        for (std::size_t s = 0; s < all_sets().size(); ++s) {
            const SeriesSet& set = all_sets()[s];
            for (const int cursor : {-1, 0, 3, static_cast<int>(set.at.size()) - 1}) {
                CAPTURE(box.width, s, cursor);
                surface.clear();
                PlotState state;
                state.cursor = cursor;
                const PlotLayout layout = layout_plot(surface.canvas(), box, set, state);
                draw_plot(surface.canvas(), layout, set, state);
                CHECK(with_fringe(box).contains(surface.drawn()));
                const std::vector<Box> texts = texts_of(layout);
                for (std::size_t a = 0; a < texts.size(); ++a) {
                    CHECK(with_fringe(box).contains(texts[a]));
                    for (std::size_t b = 0; b < a; ++b) { CHECK_FALSE(overlap(texts[a], texts[b])); }
                }
            }
        }
    }
}

TEST_CASE("curves of one unit share an axis, other units have their own", "[panels][plot]") {
    const Surface surface;
    const PlotLayout layout = layout_plot(surface.canvas(), kBoxes[1], waves(), {});
    REQUIRE(layout.panes.size() == 2);
    CHECK(layout.panes[0].series == std::vector<int>{0, 1});
    CHECK(layout.panes[0].caption == "in m/s");
    CHECK(layout.panes[1].caption == "in °");
    CHECK(layout.panes[0].plot.x == layout.panes[1].plot.x);
    CHECK(layout.panes[0].plot.bottom() < layout.panes[1].plot.y);
    CHECK(layout.left_out == 0);
}

TEST_CASE("each point of a curve is drawn at its value", "[panels][plot]") {
    const Surface surface;
    const SeriesSet set = waves();
    const PlotLayout layout = layout_plot(surface.canvas(), kBoxes[2], set, {});
    const PlotPane& pane = layout.panes[0];
    const auto runs = curve_of(layout, pane, set, 0);
    REQUIRE(runs.size() == 1);
    REQUIRE(runs[0].size() == set.at.size());  // 1500 pixels for 200 points: none is left out
    for (std::size_t k = 0; k < set.at.size(); ++k) {
        CHECK(layout.x.value(runs[0][k].x) == Approx(set.at[k]).margin(1e-5));
        CHECK(pane.y.value(runs[0][k].y) == Approx(set.series[0].values[k]).margin(1e-5));
    }
}

TEST_CASE("of a hundred thousand points the peaks are seen and few are drawn", "[panels][plot]") {
    const Surface surface;
    SeriesSet set = points(100000);
    add(set, "spike", "m", [](double t) { return std::abs(t - 1.2345) < 2e-5 ? 5.0 : std::sin(900.0 * t); });
    const PlotLayout layout = layout_plot(surface.canvas(), kBoxes[0], set, {});
    const PlotPane& pane = layout.panes[0];
    const auto runs = curve_of(layout, pane, set, 0);
    REQUIRE(runs.size() == 1);
    CHECK(runs[0].size() <= 4 * static_cast<std::size_t>(pane.plot.width + 2.0F));
    float highest = pane.plot.bottom();
    float last = 0.0F;
    for (const Point p : runs[0]) {
        highest = std::min(highest, p.y);
        CHECK(p.x >= last);
        last = p.x;
    }
    CHECK(pane.y.value(highest) == Approx(5.0).epsilon(1e-5));
}

TEST_CASE("a curve is broken where it has no values", "[panels][plot]") {
    const Surface surface;
    SeriesSet set = points(90);
    add(set, "torn", "m", [](double t) { return t > 1.0 && t < 2.0 ? kNothing : 1.0; });
    const PlotLayout layout = layout_plot(surface.canvas(), kBoxes[1], set, {});
    const auto runs = curve_of(layout, layout.panes[0], set, 0);
    REQUIRE(runs.size() == 2);
    CHECK(runs[0].back().x <= layout.x.pixel(1.0));
    CHECK(runs[1].front().x >= layout.x.pixel(2.0));
}

TEST_CASE("no two of twelve curves look the same, even without colours", "[panels][plot]") {
    const SeriesSet set = crowd();
    PlotPane pane;
    for (int k = 0; k < 12; ++k) { pane.series.push_back(k); }
    for (std::size_t a = 0; a < 12; ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            const CurveStyle x = style_of(pane, a, set, {});
            const CurveStyle y = style_of(pane, b, set, {});
            CHECK((x.dashes != y.dashes || x.mark != y.mark));
        }
    }
}

TEST_CASE("lines are spread no farther than they must", "[panels][plot]") {
    CHECK(spread_lines({10.0F, 50.0F}, 16.0F, 0.0F, 100.0F) == std::vector<float>{10.0F, 50.0F});
    CHECK(spread_lines({50.0F, 50.0F}, 16.0F, 0.0F, 100.0F) == std::vector<float>{42.0F, 58.0F});
    CHECK(spread_lines({-5.0F, 0.0F, 99.0F}, 20.0F, 0.0F, 100.0F) == std::vector<float>{0.0F, 20.0F, 80.0F});
}

TEST_CASE("the name of the curve that is pointed at is there however many there are", "[panels][plot]") {
    const Surface surface;
    PlotState state;
    state.hovered = 33;
    const PlotLayout layout = layout_plot(surface.canvas(), kBoxes[0], crowd(), state);
    const PlotPane& pane = layout.panes[0];
    CHECK(std::ranges::count(pane.labels, 33, &PlotLabel::series) == 1);
    CHECK(pane.unnamed == 40 - static_cast<int>(pane.labels.size()));
}

TEST_CASE("the cursor reads the values of its point", "[panels][plot]") {
    const Surface surface;
    const SeriesSet set = waves();
    PlotState state;
    state.cursor = point_of_step(set, 110);
    REQUIRE(state.cursor == 100);
    const PlotLayout layout = layout_plot(surface.canvas(), kBoxes[1], set, state);
    REQUIRE(layout.cursor.has_value());
    CHECK(layout.cursor_text == "1.508 s");
    REQUIRE(layout.panes[1].values.size() == 1);
    CHECK(layout.panes[1].values[0].text == "180.9");
}

TEST_CASE("a step between two points belongs to the one before it", "[panels][plot]") {
    SeriesSet set = points(3);
    set.steps = {4, 6, 9};
    CHECK(point_of_step(set, 3) == -1);
    CHECK(point_of_step(set, 4) == 0);
    CHECK(point_of_step(set, 8) == 1);
    CHECK(point_of_step(set, 100) == 2);
    CHECK(point_near(set, 0.8) == 1);
    CHECK(point_near(set, -7.0) == 0);
    CHECK(point_near(set, 7.0) == 2);
    CHECK(point_near(nothing(), 1.0) == -1);
}

TEST_CASE("a mouse finds the curve that it points at", "[panels][plot]") {
    const Surface surface;
    const SeriesSet set = waves();
    const PlotLayout layout = layout_plot(surface.canvas(), kBoxes[1], set, {});
    const PlotPane& pane = layout.panes[0];
    const Point at{layout.x.pixel(set.at[70]) + 0.5F, pane.y.pixel(set.series[1].values[70]) + 1.0F};
    const auto hit = hit_of(layout, set, at, 6.0F);
    REQUIRE(hit.has_value());
    CHECK(hit->series == 1);
    CHECK(hit->point == 70);
    CHECK(*at_of_pixel(layout, at) == Approx(set.at[70]).margin(0.01));
    CHECK_FALSE(hit_of(layout, set, {pane.plot.x + 1.0F, pane.plot.bottom() - 1.0F}, 6.0F).has_value());
    CHECK_FALSE(at_of_pixel(layout, {0.0F, 0.0F}).has_value());
}

TEST_CASE("zooming keeps what is under the mouse, panning takes it along", "[panels][plot]") {
    const Surface surface;
    for (const SeriesSet& set : {waves(), logarithmic()}) {
        const PlotLayout before = layout_plot(surface.canvas(), kBoxes[1], set, {});
        const Point at{300.0F, before.panes[0].plot.y + 60.0F};
        const double t = before.x.value(at.x);
        const double y = before.panes[0].y.value(at.y);

        PlotState state = zoomed({}, before, at, 2.0);
        const PlotLayout nearer = layout_plot(surface.canvas(), kBoxes[1], set, state);
        CHECK(nearer.x.range.length() == Approx(0.5 * before.x.range.length()));
        // numbers at the axis may be wider now and move it by some pixels: compare fractions of the axis
        const auto part = [](const Axis& axis, double value) {
            return (axis.pixel(value) - axis.start) / (axis.end - axis.start);
        };
        CHECK(part(nearer.x, t) == Approx(part(before.x, t)).margin(1e-3));
        CHECK(part(nearer.panes[0].y, y) == Approx(part(before.panes[0].y, y)).margin(1e-3));

        state = panned(state, nearer, at, {20.0F, 10.0F});
        const PlotLayout moved = layout_plot(surface.canvas(), kBoxes[1], set, state);
        const float length = nearer.x.end - nearer.x.start;
        CHECK(part(moved.x, t) - part(nearer.x, t) == Approx(20.0F / length).margin(1e-3));

        const PlotState whole = unzoomed(state);
        CHECK_FALSE(whole.window.has_value());
        CHECK(whole.heights.empty());
    }
}

TEST_CASE("zoomed again and again, numbers stay apart at the end of double precision", "[panels][plot]") {
    const Surface surface;
    const SeriesSet set = waves();
    const Box plot_box = layout_plot(surface.canvas(), kBoxes[1], set, {}).panes[0].plot;
    PlotState deep;
    for (int k = 0; k < 200; ++k) {
        const PlotLayout layout = layout_plot(surface.canvas(), kBoxes[1], set, deep);
        deep = zoomed(deep, layout, {300.0F, plot_box.y + 60.0F}, 3.0);
        REQUIRE(layout.x.range.length() > 0.0);
    }
}

TEST_CASE("marks that would bury the curves become one stretch with their number", "[panels][plot]") {
    Surface surface;
    SeriesSet set = waves();
    set.marks = {{0.1, "change point"}};
    for (int k = 0; k < 60; ++k) {
        set.marks.push_back(
            {1.0 + 0.01 * k, "sleeve p1: x is left out", "sleeve switches", "switches of rows"});
    }
    set.marks.push_back({2.8, "wrist p1: x is left out", "wrist switches", "switches of rows"});
    const PlotLayout layout = layout_plot(surface.canvas(), {10.0F, 20.0F, 760.0F, 420.0F}, set, {});
    REQUIRE(layout.marks.size() == 3);
    CHECK(layout.marks[1].count == 60);
    CHECK(layout.marks[1].text == "60 switches of rows");
    CHECK(layout.marks[1].end > layout.marks[1].x);
    CHECK(layout.marks[2].count == 1);
    // zoomed in, each mark has enough room
    PlotState near;
    near.window = Range{1.0, 1.05};
    const PlotLayout zoomed = layout_plot(surface.canvas(), {10.0F, 20.0F, 760.0F, 420.0F}, set, near);
    CHECK(std::ranges::all_of(zoomed.marks, [](const PlotMark& mark) { return mark.count == 1; }));
}

}  // namespace jw::panels::test
