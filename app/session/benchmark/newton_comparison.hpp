#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session/view/series.hpp"

/// Newton with different methods from the same start, side by side.
namespace jw {

/// One way of iterating, and its outcome.
struct NewtonRun {
    std::string name;               ///< "plain", "damped", ...
    std::vector<double> phi_norms;  ///< ‖Φ‖ before the first step and after each; the last is the outcome
    std::optional<double> order;    ///< measured order of convergence, 2 for quadratic
    bool converged = false;         ///< Φ = 0 was reached
    bool wrong_branch = false;      ///< reached, but on another branch than intended
    std::vector<double> turns_deg;  ///< largest turn of a body in each step; may be empty
};

struct NewtonRunRow {
    std::string name;
    int iterations = 0;     ///< steps taken
    double phi_norm = 0.0;  ///< after the last step
    std::string order;      ///< "2.0", "–" where it could not be measured
    std::string turn;       ///< the largest of all steps, "12.3°"; "–" where unknown
    bool closed = false;
    std::string verdict;  ///< "closed", "wrong branch", "did not converge"
};

struct NewtonComparison {
    std::vector<NewtonRunRow> rows;
    SeriesSet residuals;  ///< ‖Φ‖ over iterations, logarithmic, a series per method; steps are the iterations
    std::string summary;  ///< which methods took the fewest iterations, which failed
};

NewtonComparison compare(const std::vector<NewtonRun>& runs);

}  // namespace jw
