#include <catch2/catch.hpp>

#include <cmath>
#include <cstring>
#include <random>
#include <string>

#include "core/numerics/decimal.hpp"

namespace jw::test {

namespace {

/// Value to the bit, end and error of a reading.
struct Reading {
    std::uint64_t bits = 0;
    std::ptrdiff_t length = 0;
    std::errc error{};

    bool operator==(const Reading&) const = default;
};

template <class Read>
Reading reading(const Read& read, const std::string& text) {
    double value = 0.25;
    const std::from_chars_result result = read(text.data(), text.data() + text.size(), value);
    Reading found{0, result.ptr - text.data(), result.ec};
    // the payload of a NaN is not compared
    if (!std::isnan(value)) { std::memcpy(&found.bits, &value, sizeof value); }
    return found;
}

}  // namespace

TEST_CASE("Both ways of reading a number agree on any text", "[numerics]") {
    constexpr unsigned seed = 20261126;
    std::mt19937 random(seed);
    INFO("seed " << seed);
    constexpr std::string_view letters = "0123456789012345678901234567890123456789....eE+--  xXinfaN()_,";
    std::uniform_int_distribution<std::size_t> letter(0, letters.size() - 1);
    std::uniform_int_distribution<int> length(0, 24);
    std::vector<std::string> texts{"inf",      "-inf",
                                   "infinity", "nan",
                                   "-nan",     "nan(1)",
                                   "0x1p3",    "1e400",
                                   "-1e400",   "1e-400",
                                   "4e-324",   "2e-324",
                                   "0e999",    "-0",
                                   "+1",       " 1",
                                   "--1",      "-",
                                   "",         ".",
                                   ".5",       "5.",
                                   "1e",       "1e+",
                                   "1.e5",     "1.7976931348623159e308"};
    for (int k = 0; k < 200000; ++k) {
        std::string text;
        for (int n = length(random); n > 0; --n) { text += letters[letter(random)]; }
        texts.push_back(text);
    }
    for (const std::string& text : texts) {
        CAPTURE(text);
        const auto standard = [](const char* first, const char* last, double& value) {
            return std::from_chars(first, last, value);
        };
        REQUIRE(reading(standard, text) == reading(read_decimal_by_strtod, text));
    }
}

}  // namespace jw::test
