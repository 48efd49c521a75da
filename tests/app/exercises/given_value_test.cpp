#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <string>

#include "app/exercises/answers/given_value.hpp"

using namespace jw;

namespace {

double one(const std::string& text, const std::string& unit = "") {
    const GivenValue given = read_given_value(text, unit);
    CAPTURE(text, unit, given.problem);
    REQUIRE(given.problem.empty());
    REQUIRE(given.value.size() == 1);
    return given.value(0, 0);
}

}  // namespace

TEST_CASE("Numbers are read as students write them", "[exercises]") {
    const double half_root = std::sqrt(3.0) / 2.0;
    CHECK(one("0.5236") == 0.5236);
    CHECK(one(" -1/4 ") == -0.25);
    CHECK(one("−1/4") == -0.25);
    CHECK(one("0,25") == 0.25);
    CHECK(one("sqrt(3)/2") == Approx(half_root));
    CHECK(one("√(3)/2") == Approx(half_root));
    CHECK(one("2*pi/3") == Approx(2.0 * std::numbers::pi / 3.0));
    CHECK(one("2·π/3") == Approx(2.0 * std::numbers::pi / 3.0));
    CHECK(one("1e-3") == 1e-3);
    CHECK(one("3 - 1") == 2.0);
    CHECK(one("2^3") == 8.0);
    CHECK(one("-2^2") == -4.0);
}

TEST_CASE("A unit behind the answer is converted to the one that is asked for", "[exercises]") {
    CHECK(one("30 deg", "rad") == Approx(std::numbers::pi / 6.0));
    CHECK(one("30°", "rad") == Approx(std::numbers::pi / 6.0));
    CHECK(one("0.5235987755982988 rad", "deg") == Approx(30.0));
    CHECK(one("0.5", "deg") == 0.5);
    CHECK(one("12 mm", "m") == Approx(0.012));
    CHECK(one("90 deg/s", "rad/s") == Approx(std::numbers::pi / 2.0));
    CHECK(one("2 m/s²", "m/s^2") == 2.0);
    CHECK(one("3 N m", "N m") == 3.0);
    CHECK(one("3 kN m", "N m") == 3000.0);
}

TEST_CASE("Vectors and matrices are read with any of the usual brackets", "[exercises]") {
    for (const char* text :
         {"[1, -2, 3]", "(1, -2, 3)", "1, -2, 3", "1 -2 3", "[1 -2 3]", "[1; -2; 3]", "[[1, -2, 3]]"}) {
        CAPTURE(text);
        const GivenValue given = read_given_value(text, "");
        REQUIRE(given.problem.empty());
        REQUIRE(given.value.size() == 3);
        CHECK(given.value.sum() == 2.0);
    }
    for (const char* text :
         {"[[1, 2], [3, 4]]", "[1, 2; 3, 4]", "[1 2; 3 4]", "((1, 2), (3, 4))", "1 2; 3 4"}) {
        CAPTURE(text);
        const GivenValue given = read_given_value(text, "");
        REQUIRE(given.problem.empty());
        REQUIRE(given.value.rows() == 2);
        CHECK(given.value(0, 1) == 2.0);
        CHECK(given.value(1, 0) == 3.0);
    }
}

TEST_CASE("Signs of other keyboards, and factors before a function, are read", "[exercises]") {
    for (const auto& [text, value] :
         {std::pair<const char*, double>{"０．５", 0.5},
          {"－１／４", -0.25},
          {"2π", 2.0 * std::numbers::pi},
          {"2 pi", 2.0 * std::numbers::pi},
          {"π/2", 0.5 * std::numbers::pi},
          {"2√(3)", 2.0 * std::numbers::sqrt3},
          {"—3", -3.0},
          {"-2,5", -2.5}}) {
        CAPTURE(text);
        const GivenValue given = read_given_value(text, "");
        REQUIRE(given.problem.empty());
        REQUIRE(given.value.size() == 1);
        CHECK(std::abs(given.value(0, 0) - value) < 1e-12);
    }
    CHECK(std::abs(read_given_value("30º", "rad").value(0, 0) - std::numbers::pi / 6.0) < 1e-12);
    CHECK(read_given_value("1/2pi", "").problem.find("1/(2*pi)") != std::string::npos);
}

TEST_CASE("A comma is decimal where so many numbers are expected", "[exercises]") {
    for (const auto& [text, entries, first, last] :
         {std::tuple<const char*, int, double, double>{"1,2", 2, 1.0, 2.0},
          {"0,5; 1,25", 2, 0.5, 1.25},
          {"[0,5; 1; -1,25]", 3, 0.5, -1.25},
          {"(0,5; 1,5; 2)", 3, 0.5, 2.0},
          {" (-0,5; 1,25) ", 2, -0.5, 1.25},
          {"[1, 2; 3, 4]", 4, 1.0, 4.0},
          {"1/2, sqrt(3)/2", 2, 0.5, std::numbers::sqrt3 / 2.0},
          {"1/2, (1+2)/4", 2, 0.5, 0.75},
          {"[1 2pi]", 2, 1.0, 2.0 * std::numbers::pi},
          {"(1 2 -3)", 3, 1.0, -3.0},
          {"[1 sqrt(9) 3]", 3, 1.0, 3.0},
          {"1  2*2  √(16)", 3, 1.0, 4.0},
          {"((1, 2), (3, 4))", 4, 1.0, 4.0},
          {"(((1), 2, 3))", 3, 1.0, 3.0},
          {"((1), 2, (3))", 3, 1.0, 3.0},
          {"(1 + 2) (3 + 4)", 2, 3.0, 7.0},
          {"(1+2)/4 1", 2, 0.75, 1.0},
          {"2**0.5, 3 ** 2", 2, std::numbers::sqrt2, 9.0}}) {
        CAPTURE(text);
        const GivenValue given = read_given_value(text, "", entries);
        REQUIRE(given.problem.empty());
        REQUIRE(given.value.size() == entries);
        CHECK(given.value(0, 0) == first);
        CHECK(std::abs(given.value(given.value.rows() - 1, given.value.cols() - 1) - last) < 1e-12);
    }
    CHECK(read_given_value("[30 deg, 40 deg]", "deg", 2).problem.find("after the list") != std::string::npos);
}

TEST_CASE("What cannot be read is refused with the reason, and nothing crashes", "[exercises]") {
    const std::string deep(5000, '(');
    const std::string minus(5000, '-');
    const std::string deep_list(19000, '[');
    const std::string list = "[" + std::string(30000, '1') + "]";
    for (const std::string& text :
         {std::string(),
          std::string("  "),
          std::string("abc"),
          std::string("1 2 3 x"),
          std::string("[1, 2"),
          std::string("nan"),
          std::string("1/0"),
          std::string("sqrt(-1)"),
          std::string("[[1, 2], [3]]"),
          std::string("1e999"),
          deep,
          deep_list,
          deep + "1,2",
          minus,
          list,
          std::string("5 furlongs"),
          std::string("\x1b[31m"),
          std::string("\xff\xfe"),
          std::string("1//2"),
          std::string("sin"),
          std::string("[]"),
          std::string("()"),
          std::string("2^999999")}) {
        CAPTURE(text.substr(0, 40));
        CHECK_FALSE(read_given_value(text, "").problem.empty());
    }
    CHECK(read_given_value("3 kg", "m").problem.find("in m") != std::string::npos);
}
