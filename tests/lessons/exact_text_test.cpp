#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include "lessons/typed/exact_text.hpp"
#include "lessons/typed/typed.hpp"
#include "lessons/write/writer.hpp"
#include "tests/lessons/lesson_difference.hpp"
#include "tests/lessons/support.hpp"
#include "tests/support/random_mechanisms.hpp"

using namespace jw;
using test::first_difference;
using test::lesson_of;
using test::Random;

TEST_CASE("Numbers have as few digits as read back to the same", "[lessons][writing]") {
    using writing::number_text;
    CHECK(number_text(0.1) == "0.1");
    CHECK(number_text(-0.0) == "0");
    CHECK(number_text(1e9) == "1000000000");
    CHECK(number_text(100000.0) == "100000");
    CHECK(number_text(1e-12) == "1e-12");
    CHECK(number_text(1.5e-5) == "1.5e-5");
    CHECK(number_text(1.0 / 3.0) == "0.3333333333333333");
    CHECK_THROWS_AS(number_text(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
    Random random(7);
    std::vector<double> hard{5e-324, 2.2250738585072014e-308, 1e9, -1e-9, 123456.7890625};
    for (int k = 0; k < 200; ++k) {
        hard.push_back(std::pow(10.0, random.number(-300.0, 8.0)) * random.number());
    }
    for (const double x : hard) {
        Lesson lesson = lesson_of(test::documented_lesson());
        lesson.mechanism.bodies[1].r = Vec3(x, -x, 0.0);
        CHECK(first_difference(lesson, lesson_of(lesson_text(lesson))) == "");
    }
}

TEST_CASE("Two numbers that differ get the fewest digits with which they read differently", "[lessons]") {
    using writing::digits_apart;
    CHECK(digits_apart(1.0, 2.0, 6) == 6);
    CHECK(digits_apart(1e9 + 1.0, 1e9, 6) == 10);
    CHECK(digits_apart(-1e9 - 1.0, -1e9, 6) == 10);
    CHECK(digits_apart(0.1, std::nextafter(0.1, 1.0), 6) == 17);
    // no number of digits tells them apart
    CHECK(digits_apart(0.1, 0.1, 6) == 6);
    CHECK(digits_apart(0.1, std::numeric_limits<double>::quiet_NaN(), 6) == 6);
}

TEST_CASE("Degrees are written where they read back exactly, radians elsewhere", "[lessons][writing]") {
    const double typed[] = {radians(120.0), radians(-0.7), radians(1e-9)};
    const writing::AngleTexts angles = writing::typed_angles(typed);
    CHECK(angles.unit == "deg");
    CHECK(angles.values == std::vector<double>{120.0, -0.7, 1e-9});
    Random random(3);
    int in_radians = 0;
    for (int k = 0; k < 200; ++k) {
        const double angle = random.number(-10.0, 10.0);
        const writing::AngleTexts one = writing::typed_angles({&angle, 1});
        CHECK((one.unit == "deg" ? radians(one.values[0]) : one.values[0]) == angle);
        in_radians += one.unit == "rad" ? 1 : 0;
    }
    // degrees are spaced wider than radians by up to 12 per cent: both happen
    CHECK(in_radians > 0);
    CHECK(in_radians < 100);
}

TEST_CASE("Normalising a unit vector does not change it", "[lessons][writing]") {
    Random random(11);
    for (int k = 0; k < 2000; ++k) {
        const Vec3 unit = unit_of(random.vector(random.number(1e-6, 1e6)));
        CHECK(unit_of(unit) == unit);
        CHECK(unit_of(rotation_matrix(random.unit_p()) * unit).norm() == Approx(1.0).epsilon(1e-14));
    }
    // a vector that is unit to thirteen digits is not a unit vector
    const Vec3 nearly(0.6, 0.8000000000001, 0.0);
    CHECK(unit_of(nearly) != nearly);
}
