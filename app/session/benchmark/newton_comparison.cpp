#include "app/session/benchmark/newton_comparison.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw {

namespace {

int iterations_of(const NewtonRun& run) { return std::max(0, static_cast<int>(run.phi_norms.size()) - 1); }

std::string verdict_of(const NewtonRun& run) {
    if (!run.converged) { return tr("did not converge"); }
    return run.wrong_branch ? tr("wrong branch") : tr("closed");
}

NewtonRunRow row_of(const NewtonRun& run) {
    NewtonRunRow row;
    row.name = run.name;
    row.iterations = iterations_of(run);
    row.phi_norm = run.phi_norms.empty() ? std::numeric_limits<double>::quiet_NaN() : run.phi_norms.back();
    row.order = run.order ? fixed_text(*run.order, 1) : "–";
    row.turn = run.turns_deg.empty() ? "–" : fixed_text(*std::ranges::max_element(run.turns_deg), 1) + "°";
    row.closed = run.converged && !run.wrong_branch;
    row.verdict = verdict_of(run);
    return row;
}

SeriesSet residuals_of(const std::vector<NewtonRun>& runs) {
    SeriesSet set;
    set.axis = tr_later("iteration");
    set.logarithmic = true;
    std::size_t longest = 0;
    for (const NewtonRun& run : runs) { longest = std::max(longest, run.phi_norms.size()); }
    for (std::size_t k = 0; k < longest; ++k) {
        set.at.push_back(static_cast<double>(k));
        set.steps.push_back(static_cast<int>(k));
    }
    for (const NewtonRun& run : runs) {
        Series series{run.name, "-", run.phi_norms, 0.0, false};
        series.values.resize(longest, std::numeric_limits<double>::quiet_NaN());
        set.telling.push_back(static_cast<int>(set.series.size()));
        set.series.push_back(std::move(series));
    }
    if (set.at.empty()) { set.why_empty = tr("Nothing to compare yet: no method has been run."); }
    return set;
}

std::string summary_of(const std::vector<NewtonRun>& runs) {
    std::vector<std::string> first;
    std::vector<std::string> wrong;
    std::vector<std::string> lost;
    int fewest = std::numeric_limits<int>::max();
    for (const NewtonRun& run : runs) {
        if (!run.converged) {
            lost.push_back(run.name);
        } else if (run.wrong_branch) {
            wrong.push_back(run.name);
        } else {
            if (iterations_of(run) < fewest) { first.clear(); }
            fewest = std::min(fewest, iterations_of(run));
            if (iterations_of(run) == fewest) { first.push_back(run.name); }
        }
    }
    if (runs.empty()) { return {}; }
    std::string text = first.empty() ? tr("No method closed it from here.")
                                     : tr("Fewest iterations, {0}: {1}.", fewest, listed(first));
    if (!wrong.empty()) { text = followed(text, tr("At a wrong branch: {0}.", listed(wrong))); }
    if (!lost.empty()) { text = followed(text, tr("Did not converge: {0}.", listed(lost))); }
    return text;
}

}  // namespace

NewtonComparison compare(const std::vector<NewtonRun>& runs) {
    NewtonComparison comparison;
    for (const NewtonRun& run : runs) { comparison.rows.push_back(row_of(run)); }
    comparison.residuals = residuals_of(runs);
    comparison.summary = summary_of(runs);
    return comparison;
}

}  // namespace jw
