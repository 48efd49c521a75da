#include "core/numerics/decimal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace jw {

std::from_chars_result read_decimal(const char* first, const char* last, double& value) {
#ifdef __cpp_lib_to_chars
    return std::from_chars(first, last, value);
#else
    return read_decimal_by_strtod(first, last, value);
#endif
}

std::from_chars_result read_decimal_by_strtod(const char* first, const char* last, double& value) {
    const char* const digits = first != last && *first == '-' ? first + 1 : first;
    const auto is_skipped = [](char c) {
        return c == ' ' || (c >= '\t' && c <= '\r') || c == '+' || c == '-';
    };
    // strtod accepts characters that from_chars does not: space, signs and hexadecimal digits
    if (digits == last || is_skipped(*digits)) { return {first, std::errc::invalid_argument}; }
    std::string text(first, last);
    text.resize(std::min(text.size(), text.find_first_of("xX")));
    char* end = nullptr;
    const double read = std::strtod(text.c_str(), &end);
    if (end == text.c_str()) { return {first, std::errc::invalid_argument}; }
    const char* const stop = first + (end - text.c_str());
    // too large or too small for a double; "inf" and zeros are neither
    const char* const exponent = std::find_if(digits, stop, [](char c) { return c == 'e' || c == 'E'; });
    const bool is_zero = std::none_of(digits, exponent, [](char c) { return c >= '1' && c <= '9'; });
    const bool is_number = (*digits >= '0' && *digits <= '9') || *digits == '.';
    if (is_number && !is_zero && (read == 0.0 || std::isinf(read))) {
        return {stop, std::errc::result_out_of_range};
    }
    value = read;
    return {stop, std::errc()};
}

}  // namespace jw
