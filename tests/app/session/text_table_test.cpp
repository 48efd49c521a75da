#include "app/session/wording/text_table.hpp"

#include <limits>

#include <catch2/catch.hpp>

namespace jw::test {

TEST_CASE("Cells of a column of a text table begin, or end, at the same place", "[app][table]") {
    const TextRows rows{{"", "Φ", "unit"}, {"hinge", "1.25", "m"}, {"a", "-10.5", ""}};
    CHECK(
        text_table(rows, columns_of_numbers(3, 2)) ==
        "             Φ  unit\n"
        "  hinge   1.25  m\n"
        "  a      -10.5\n");
}

TEST_CASE("A column of a text table has its least width, and more where a cell needs it", "[app][table]") {
    const std::vector<TextColumn> columns{{false, 4, 0}, {true, 3, 1}};
    CHECK(text_table({{"ab", "1"}}, columns) == "ab     1\n");
    CHECK(text_table({{"ab", "12345"}, {"abcdef"}}, columns) == "ab     12345\nabcdef\n");
    CHECK_THROWS_AS(text_table({{"a", "b", "c"}}, columns), std::invalid_argument);
}

TEST_CASE("A number that is undefined leaves a dash in its cell", "[app][table]") {
    CHECK(number_cell("%.1e", 0.00124) == "1.2e-03");
    CHECK(number_cell("%.1e", std::numeric_limits<double>::quiet_NaN()) == "-");
}

}  // namespace jw::test
