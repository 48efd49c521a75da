#include "core/equations/independent_rows.hpp"

namespace jw {

int choose_dropped(const Vec3& s_i, int previous) {
    const Vec3 magnitude = s_i.cwiseAbs();
    Eigen::Index largest = 0;
    const double maximum = magnitude.maxCoeff(&largest);
    const bool keeps = previous >= 0 && magnitude(previous) >= kKeepRatio * maximum;
    return keeps ? previous : static_cast<int>(largest);
}

int forced_drop(ParallelForm form) {
    switch (form) {
        case ParallelForm::drop_x: return 0;
        case ParallelForm::drop_y: return 1;
        case ParallelForm::drop_z: return 2;
        case ParallelForm::rule:
        case ParallelForm::all_three:
        case ParallelForm::pair: break;
    }
    return -1;
}

}  // namespace jw
