#include "lessons/lesson/enum_words.hpp"

#include <set>

#include <catch2/catch.hpp>

using namespace jw;

namespace {

/// The table has every value from the first on once, and no word twice.
template <class E, std::size_t N>
void check_table(const std::array<EnumWord<E>, N>& table) {
    std::set<std::string> words;
    for (std::size_t k = 0; k < N; ++k) {
        const auto value = static_cast<E>(k);
        CAPTURE(k, word_of(table, value));
        CHECK(value_of(table, word_of(table, value)) == value);
        words.insert(word_of(table, value));
    }
    CHECK(words.size() == N);
    CHECK_FALSE(value_of(table, "no such word").has_value());
    CHECK_THROWS_AS(word_of(table, static_cast<E>(N)), std::invalid_argument);
}

}  // namespace

TEST_CASE("Words of enumerators lead back to them") {
    check_table(kChoices);
    check_table(kParallelForms);
    check_table(kAngleRows);
    check_table(kFrames);
    check_table(kCounts);
    check_table(kBounds);
    check_table(kVerdicts);
}
