#include "app/commands/bench/bench_hard.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "app/hard/report.hpp"
#include "app/session/output/csv.hpp"
#include "app/session/output/json.hpp"
#include "lessons/diagnostics/diagnostics.hpp"

namespace jw {

namespace {

std::vector<const hard::Case*> cases_of(const std::vector<std::string>& names) {
    std::vector<const hard::Case*> chosen;
    std::vector<std::string> known;
    for (const hard::Case& c : hard::cases()) {
        known.emplace_back(c.name);
        if (names.empty()) { chosen.push_back(&c); }
    }
    for (const std::string& name : names) {
        const auto found = std::ranges::find(hard::cases(), name, &hard::Case::name);
        if (found == hard::cases().end()) {
            const std::string hint = did_you_mean(name, known);
            throw CommandError(
                Exit::bad_input, "jointwise: error: " + in_quotes(name) +
                                     ": no such hard case; expected one of " + comma_list(known) +
                                     (hint.empty() ? "" : "\nhint: " + hint));
        }
        chosen.push_back(&*found);
    }
    return chosen;
}

void write_csv_rows(const hard::Case& c, const hard::Result& result, std::ostream& out) {
    const auto cells = [](const std::optional<hard::Bounded>& number) {
        if (!number) { return std::string(",,"); }
        const auto limit = [](double value) { return std::isfinite(value) ? csv_number(value) : ""; };
        return csv_number(number->value) + ',' + limit(number->bounds.least) + ',' +
               limit(number->bounds.most);
    };
    for (const hard::Measurement& m : result.measurements) {
        out << c.name << ',' << csv_cell(m.what) << ',' << cells(m.naive) << ',' << cells(m.ours) << '\n';
    }
}

Json json_of(const std::optional<hard::Bounded>& number) {
    if (!number) { return {}; }
    const auto limit = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
    return {
        {"value", limit(number->value)},
        {"at_least", limit(number->bounds.least)},
        {"at_most", limit(number->bounds.most)}};
}

Json json_of(const hard::Case& c, const hard::Result& result) {
    Json measurements = Json::array();
    for (const hard::Measurement& m : result.measurements) {
        measurements.push_back({{"what", m.what}, {"naive", json_of(m.naive)}, {"ours", json_of(m.ours)}});
    }
    return {{"name", c.name},        {"title", c.title},    {"lesson", c.lesson},
            {"naive", result.naive}, {"ours", result.ours}, {"measurements", measurements}};
}

}  // namespace

Exit bench_hard(const std::vector<std::string>& names, const std::string& format, const Streams& streams) {
    const std::vector<const hard::Case*> chosen = cases_of(names);
    if (format == "markdown") { streams.out << hard::markdown_head(); }
    if (format == "csv") {
        streams.out << "case,what,naive,naive_at_least,naive_at_most,ours,ours_at_least,ours_at_most\n";
    }
    Json all = Json::array();
    bool broken = false;
    for (const hard::Case* c : chosen) {
        const hard::Result result = c->run();
        if (format == "table") { streams.out << hard::text_of(*c, result) << std::flush; }
        if (format == "markdown") { streams.out << hard::markdown_of(*c, result) << std::flush; }
        if (format == "csv") { write_csv_rows(*c, result, streams.out); }
        if (format == "json") { all.push_back(json_of(*c, result)); }
        for (const std::string& sentence : hard::broken_bounds(result)) {
            streams.err << "jointwise: " << c->name << ": " << sentence << '\n';
            broken = true;
        }
    }
    if (format == "json") {
        const Json json{{"format", "jointwise hard cases"}, {"version", kJsonVersion}, {"cases", all}};
        streams.out << json_document(json);
    }
    return broken ? Exit::check_failed : Exit::done;
}

}  // namespace jw
