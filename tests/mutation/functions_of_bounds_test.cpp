#include <catch2/catch.hpp>

#include "core/elementary/elementary.hpp"
#include "core/jets/majorants.hpp"

/// Bounds of functions of one operand, against the largest derivatives of the function in closed form.
using namespace jw;

TEST_CASE("A function has the bounds of its largest derivatives in the whole range", "[core][majorants]") {
    Jet<Majorants, Content::jacobian, 1, kBodyI> x;
    x.value(0) = 1.0;
    x.away = 0.5;
    x.size = 1.5;
    x.bounds.first.fill(1.0);
    for (auto& row : x.bounds.second) { row.fill(0.0); }
    const auto out = applied(FormulaStep{FormulaStep::Kind::power, -1.5}, x);
    // at the lower end, x = 0.5: f' = -1.5 x^-2.5, f'' = 3.75 x^-3.5
    const double first = 1.5 * elementary::pow(0.5, -2.5);
    const double second = 3.75 * elementary::pow(0.5, -3.5);
    CHECK(out.value(0) == 1.0);
    CHECK(out.away == Approx(0.5 * first));
    CHECK(out.bounds.first[0] == Approx(first));
    CHECK(out.bounds.second[0][0] == Approx(second));
}
