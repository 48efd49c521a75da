#pragma once

#include <vector>

#include "app/panels/parts.hpp"
#include "app/session/view.hpp"

/// Small plots over a logarithmic scale.
namespace jw::panels {

/// Powers of ten from `low` to `high`, drawn from `bottom` up to `top`.
struct LogScale {
    int low = -16;
    int high = 0;
    float bottom = 0.0F;
    float top = 0.0F;

    /// Where `value` is drawn; what is smaller than the scale, and zero, at its bottom.
    float y(double value) const;
};

/// Whole powers from `low` (at most) up to the largest of `values`.
LogScale log_scale_for(const std::vector<double>& values, int low, float bottom, float top);

/// Singular values, largest first: hollow under the threshold, which is where zero begins.
void singular_values_plot(const Canvas& canvas, const Box& box, const RankView& rank);

/// ‖Φ‖ of every iteration; the last one is the step's.
void convergence_plot(const Canvas& canvas, const Box& box, const std::vector<NewtonRow>& rows);

}  // namespace jw::panels
