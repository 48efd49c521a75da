#include "app/session/wording/numbers.hpp"

#include <cmath>
#include <cstdio>

#include "app/session/wording/messages.hpp"
#include "core/elementary/elementary.hpp"

namespace jw {

namespace {

// below this a number of a scene in metres and radians is rounding
constexpr double kRounding = 1e-15;

}  // namespace

std::string number_text(double value, int digits) {
    if (!std::isfinite(value)) { return value > 0.0 ? "∞" : (value < 0.0 ? "−∞" : "undefined"); }
    if (std::abs(value) < kRounding) { return "0"; }
    char text[64];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

std::string fixed_text(double value, int decimals) {
    if (!std::isfinite(value)) { return number_text(value); }
    // no "-0.000"
    const double unit = elementary::pow(10.0, -decimals);
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, std::abs(value) < 0.5 * unit ? 0.0 : value);
    return text;
}

std::string small_text(double value) {
    if (!std::isfinite(value)) { return number_text(value); }
    if (value == 0.0) { return "0"; }
    char text[64];
    std::snprintf(text, sizeof text, "%.1e", value);
    return text;
}

std::string vector_text(const Vec3& v, int digits) {
    return "(" + number_text(v.x(), digits) + ", " + number_text(v.y(), digits) + ", " +
           number_text(v.z(), digits) + ")";
}

std::string count_text(int count, const std::string& singular, const std::string& plural) {
    return std::to_string(count) + " " + (count == 1 ? singular : (plural.empty() ? singular + "s" : plural));
}

std::string listed(const std::vector<std::string>& items) {
    if (items.empty()) { return {}; }
    std::string text = items.front();
    for (std::size_t k = 1; k + 1 < items.size(); ++k) { text = tr("{0}, {1}", text, items[k]); }
    return items.size() == 1 ? text : tr("{0} and {1}", text, items.back());
}

std::string alternatives(const std::vector<std::string>& items) {
    if (items.empty()) { return {}; }
    std::string text = items.front();
    for (std::size_t k = 1; k + 1 < items.size(); ++k) { text = tr("{0}, {1}", text, items[k]); }
    return items.size() == 1 ? text : tr("{0} or {1}", text, items.back());
}

std::string followed(const std::string& sentence, const std::string& next) {
    if (sentence.empty() || next.empty()) { return sentence + next; }
    return tr("{0} {1}", sentence, next);
}

}  // namespace jw
