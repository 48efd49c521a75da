#include "app/session/benchmark/prices.hpp"

#include <algorithm>
#include <cmath>

#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "core/elementary/elementary.hpp"

namespace jw {

namespace {

double finest_of(const BenchRun& run) {
    double finest = kNotKnown;
    for (const BenchPoint& point : run.points) {
        // every comparison with NaN is false
        if (!(finest <= point.position)) { finest = point.position; }
    }
    return finest;
}

/// Fastest method at a level: "1e-6 m: explicit-8 in 1.4 ms, 3.2 times as fast as implicit-9. "
std::string winner_at(const std::vector<PriceRow>& rows, std::size_t level) {
    const PriceRow* first = nullptr;
    const PriceRow* second = nullptr;
    for (const PriceRow& row : rows) {
        if (!row.milliseconds[level]) { continue; }
        if (first == nullptr || *row.milliseconds[level] < *first->milliseconds[level]) {
            second = first;
            first = &row;
        } else if (second == nullptr || *row.milliseconds[level] < *second->milliseconds[level]) {
            second = &row;
        }
    }
    const std::string error = level_text(level);
    if (first == nullptr) { return tr("{0}: out of reach.", error) + ' '; }
    const double time = *first->milliseconds[level];
    const std::string milliseconds = number_text(time, 2);
    if (second == nullptr) {
        return tr("{0}: {1} in {2} ms; no other method reached it.", error, first->name, milliseconds) + ' ';
    }
    return tr("{0}: {1} in {2} ms, {3} times as fast as {4}.", error, first->name, milliseconds,
              number_text(*second->milliseconds[level] / time, 2), second->name) +
           ' ';
}

}  // namespace

std::string level_text(std::size_t level) {
    return "1e-" + std::to_string(static_cast<int>(std::lround(-elementary::log10(kErrorLevels[level])))) +
           " m";
}

Prices prices_of(const std::vector<BenchRun>& runs) {
    Prices prices;
    for (const BenchRun& run : runs) {
        PriceRow& row = prices.rows.emplace_back();
        row.name = entry_of(run.method).name;
        row.finest = finest_of(run);
        for (std::size_t level = 0; level < kErrorLevels.size(); ++level) {
            if (const auto time = run.time_to(kErrorLevels[level])) { row.milliseconds[level] = 1e3 * *time; }
        }
    }
    for (std::size_t level = 0; level < kErrorLevels.size() && !runs.empty(); ++level) {
        prices.summary += winner_at(prices.rows, level);
    }
    prices.curves = work_precision(runs);
    return prices;
}

SeriesSet work_precision(const std::vector<BenchRun>& runs) {
    SeriesSet set;
    set.axis = tr_later("digits of position");
    set.logarithmic = true;
    // computed by division, not by summing: three digits are exactly at 3
    constexpr int most_tenths = 140;
    for (int tenths = 0; tenths <= most_tenths; ++tenths) { set.at.push_back(tenths / 10.0); }
    set.steps.assign(set.at.size(), 0);
    for (const BenchRun& run : runs) {
        Series series;
        series.name = entry_of(run.method).name;
        series.unit = "ms";
        for (const double digits : set.at) {
            const auto time = run.time_to(elementary::pow(10.0, -digits));
            series.values.push_back(time ? 1e3 * *time : kNotKnown);
        }
        set.telling.push_back(static_cast<int>(set.series.size()));
        set.series.push_back(std::move(series));
    }
    // the curves end at the most digits that any method reaches
    while (!set.at.empty() &&
           std::ranges::all_of(set.series, [](const Series& s) { return std::isnan(s.values.back()); })) {
        set.at.pop_back();
        set.steps.pop_back();
        for (Series& series : set.series) { series.values.pop_back(); }
    }
    if (set.at.empty()) { set.why_empty = tr("No method reached the end."); }
    return set;
}

}  // namespace jw
