#include "tests/hard/report.hpp"

#include <cmath>
#include <cstdio>

#include "app/session/wording/text_table.hpp"

namespace jw::hard {

namespace {

/// Counts as they are, everything else with two digits.
std::string number_text(double value) {
    char text[32];
    const bool count = std::abs(value) < 1e7 && value == std::round(value);
    std::snprintf(text, sizeof text, count ? "%.0f" : "%.2g", value);
    return text;
}

std::string bounds_text(const Bounds& bounds) {
    const bool below = std::isfinite(bounds.most);
    const bool above = std::isfinite(bounds.least);
    if (below && above && bounds.least == bounds.most) { return "must be " + number_text(bounds.most); }
    if (below && above) {
        return "must lie in " + number_text(bounds.least) + " to " + number_text(bounds.most);
    }
    if (below) { return "at most " + number_text(bounds.most); }
    return above ? "at least " + number_text(bounds.least) : "";
}

std::string value_text(const std::optional<Bounded>& number) {
    return number ? number_text(number->value) : "-";
}

std::string bound_text(const std::optional<Bounded>& number) {
    return number ? bounds_text(number->bounds) : "";
}

}  // namespace

std::vector<std::string> broken_bounds(const Result& result) {
    std::vector<std::string> broken;
    const auto check = [&](const Measurement& m, const char* whose, const std::optional<Bounded>& number) {
        if (!number || number->bounds.hold(number->value)) { return; }
        broken.push_back(
            m.what + ", " + whose + ": " + number_text(number->value) + ", " + bounds_text(number->bounds));
    };
    for (const Measurement& m : result.measurements) {
        check(m, "naive", m.naive);
        check(m, "Jointwise", m.ours);
    }
    return broken;
}

std::string text_of(const Case& hard_case, const Result& result) {
    std::string out = std::string(hard_case.name) + ": " + std::string(hard_case.title) + "\n  " +
                      std::string(hard_case.hard) + "\n";
    out += "  naive      " + std::string(hard_case.naive_method) + ": " + result.naive + "\n";
    out += "  Jointwise  " + std::string(hard_case.our_method) + ": " + result.ours + "\n";
    TextRows table{{"", "naive", "Jointwise", "asked for"}};
    for (const Measurement& m : result.measurements) {
        table.push_back({m.what, value_text(m.naive), value_text(m.ours), bound_text(m.ours)});
    }
    out += text_table(table, {{false, 52, 2}, {false, 11, 0}, {false, 11, 0}, {false, 0, 0}});
    return out + "  lesson     lessons/catalogue/" + std::string(hard_case.lesson) + "\n\n";
}

std::string markdown_of(const Case& hard_case, const Result& result) {
    std::string out = "## " + std::string(hard_case.title) + "\n\n" + std::string(hard_case.hard) + "\n\n";
    out += "- **Naive**, " + std::string(hard_case.naive_method) + ": " + result.naive + "\n";
    out += "- **Jointwise**, " + std::string(hard_case.our_method) + ": " + result.ours + "\n";
    const std::string lesson(hard_case.lesson);
    out += "- Lesson: [" + lesson + "](../lessons/catalogue/" + lesson + ")\n\n";
    out += "| | naive | Jointwise | required of Jointwise |\n| --- | --- | --- | --- |\n";
    for (const Measurement& m : result.measurements) {
        out += "| " + markdown_cell(m.what) + " | " + value_text(m.naive) + " | " + value_text(m.ours) +
               " | " + bound_text(m.ours) + " |\n";
    }
    return out + "\n";
}

std::string markdown_head() {
    return "# Hard cases\n\n"
           "Written by `./dev bench hard --markdown`; do not edit. Each case runs a naive "
           "method and\n"
           "Jointwise on the same mechanism. A test checks the required limits as well, also those of the\n"
           "naive method (`tests/app/hard_cases_test.cpp`): if the naive method no longer failed, the case\n"
           "would no longer be hard.\n\n";
}

}  // namespace jw::hard
