#include "app/panels/plot/plot_axis.hpp"

#include <catch2/catch.hpp>

#include <cmath>

namespace jw::panels::test {

namespace {

const std::vector<Range> kRanges{{0.0, 1.0},     {-3.7, 4.1},   {1e-9, 2.5e-9}, {-2e17, 3e17},
                                 {359.0, 361.0}, {0.0, 1080.0}, {5.0, 5.001},   {-1e-4, 12.0}};

}  // namespace

TEST_CASE("a value is found again at the pixel where it is drawn", "[panels][plot]") {
    for (const Range& range : kRanges) {
        const Axis axis{range, false, 400.0F, 20.0F};
        for (const double part : {0.0, 0.1, 0.5, 0.93, 1.0}) {
            const double value = range.from + part * range.length();
            // a float near 400 is exact to 3e-5 pixels of 380
            CHECK(axis.value(axis.pixel(value)) == Approx(value).margin(1e-6 * range.length()));
        }
    }
    const Axis log{{1e-16, 10.0}, true, 400.0F, 20.0F};
    for (const double value : {1e-16, 3e-9, 1.0, 10.0}) {
        // the same of 17 powers of ten
        CHECK(log.value(log.pixel(value)) == Approx(value).epsilon(1e-5));
    }
    CHECK(log.pixel(0.0) == log.start);
    CHECK(log.pixel(-1.0) == log.start);
}

TEST_CASE("numbers of an axis are round, within it, evenly spaced, two at least", "[panels][plot]") {
    for (const Range& range : kRanges) {
        for (const int most : {2, 5, 11}) {
            CAPTURE(range.from, range.to, most);
            const TickMarks marks = ticks_of({range, false, 0.0F, 100.0F}, most);
            REQUIRE(marks.ticks.size() >= 2);
            // the beginning and the end are numbers too
            CHECK(static_cast<int>(marks.ticks.size()) <= most + 3);
            const double step = marks.ticks[1].at - marks.ticks[0].at;
            const double digit = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
            CHECK((digit == Approx(1.0) || digit == Approx(2.0) || digit == Approx(5.0)));
            for (std::size_t k = 0; k < marks.ticks.size(); ++k) {
                const double at = marks.ticks[k].at;
                CHECK(range.contains(at + (k == 0 ? 1e-8 : -1e-8) * step));
                // the text is the value at that place
                const double said = std::stod(marks.ticks[k].text) * std::pow(10.0, marks.exponent);
                CHECK(said == Approx(at).margin(1e-6 * step));
            }
        }
    }
}

TEST_CASE("angles are numbered in parts of a turn", "[panels][plot]") {
    const TickMarks marks = ticks_of({{0.0, 360.0}, false, 0.0F, 100.0F}, 5, Ticks::degrees);
    REQUIRE(marks.ticks.size() == 5);
    CHECK(marks.ticks[1].text == "90");
    const TickMarks small = ticks_of({{0.0, 3.0}, false, 0.0F, 100.0F}, 3, Ticks::degrees);
    CHECK(small.ticks[1].text == "1");
}

TEST_CASE("iterations have no halves", "[panels][plot]") {
    const TickMarks marks = ticks_of({{0.0, 2.0}, false, 0.0F, 100.0F}, 10, Ticks::whole);
    REQUIRE(marks.ticks.size() == 3);
    CHECK(marks.ticks[1].text == "1");
}

TEST_CASE(
    "a logarithmic axis has powers of ten, or figures between them where it is short", "[panels][plot]") {
    const auto texts = [](const Range& range, int most) {
        std::vector<std::string> found;
        for (const Tick& tick : ticks_of({range, true, 0.0F, 100.0F}, most).ticks) {
            found.push_back(tick.text);
        }
        return found;
    };
    CHECK(texts({1e-4, 1e2}, 4) == std::vector<std::string>{"10⁻⁴", "10⁻²", "10⁰", "10²"});
    CHECK(texts({0.9, 6.0}, 8) == std::vector<std::string>{"1", "2", "5"});
    CHECK(texts({1.05, 1.45}, 8).size() >= 2);
}

TEST_CASE(
    "a power of ten more is the same step up an axis of powers, and zero is at its start", "[panels][plot]") {
    const Axis axis = axis_of_powers({10.0, 0.5, 0.0}, -12, 500.0F, 100.0F);
    CHECK(axis.range.to == 10.0);
    CHECK(axis.pixel(10.0) == 100.0F);
    CHECK(axis.pixel(0.0) == 500.0F);
    CHECK(axis.pixel(1e-30) == 500.0F);
    // pixels; the positions are floats near 300
    CHECK(axis.pixel(1e-3) - axis.pixel(1e-2) == Approx(axis.pixel(1e-8) - axis.pixel(1e-7)).margin(1e-3));
    CHECK(axis_of_powers({}, -12, 500.0F, 100.0F).range.to == Approx(1e-10));
    CHECK(std::isfinite(axis_of_powers({1.7e308}, -12, 500.0F, 100.0F).range.to));
}

TEST_CASE("what never changes but by rounding is drawn as a flat line in the middle", "[panels][plot]") {
    CHECK(range_around({-1e-14, 2e-14}, 1e-12) == Range{-1.0, 1.0});
    const Range constant = range_around({3.0, 3.0}, 0.0);
    CHECK(constant.from + constant.to == Approx(6.0));
    CHECK(constant.length() > 1.0);
    const Range real = range_around({1e-14, 2e-14}, 0.0);  // small, but not rounding
    CHECK(real.length() < 1e-13);
    CHECK(std::isfinite(range_around({-1.7e308, 1.7e308}, 0.0).length()));
}

}  // namespace jw::panels::test
