#include <catch2/catch.hpp>

#include <algorithm>

#include "tests/core/rows.hpp"
#include "tests/support/singular_scenes.hpp"

using namespace jw;
using test::without_row;

namespace {

/// Removable rows, by the singular values without each row; 1e-7 is far from both 1e-16 and 1e-2.
std::vector<int> removable_by_trial(const MatrixX& jacobian, int rank) {
    std::vector<int> rows;
    for (int row = 0; row < jacobian.rows(); ++row) {
        const VectorX sigma = singular_values_of(without_row(jacobian, row));
        if ((sigma.array() > 1e-7).count() == rank) { rows.push_back(row); }
    }
    return rows;
}

/// A shaft on two revolutes in line: five rows are redundant.
Mechanism doubly_supported_shaft() {
    test::SceneBuilder scene;
    const int shaft = scene.add_body("shaft", Vec3(0.1, 0.2, 0.3));
    scene.add_joint("revolute", 0, shaft, Vec3(1.0, 0.5, 0.0), Vec3(1.0, 2.0, 2.0));
    scene.add_joint("revolute", 0, shaft, Vec3(2.0, 2.5, 2.0), Vec3(1.0, 2.0, 2.0));
    return scene.mechanism;
}

Mechanism with_form(Mechanism mechanism, ParallelForm form) {
    for (Joint& joint : mechanism.joints) { joint.parallel_form = form; }
    return mechanism;
}

}  // namespace

TEST_CASE("The removable rows are those that can go one at a time without loss of rank", "[core][rank]") {
    std::size_t removable = 0;
    std::size_t needed = 0;
    for (const Mechanism& whole :
         {test::bennett(1.1), test::four_bar_at(0.7), test::parallelogram(0.0), doubly_supported_shaft(),
          test::bricard(1.2), test::cardan(0.5, 0.3), test::rssr(0.7), test::stretched_revolutes()}) {
        for (const ParallelForm form : {ParallelForm::rule, ParallelForm::all_three, ParallelForm::pair}) {
            const Mechanism mechanism = with_form(whole, form);
            const RankReport report = test::rank_of(mechanism);
            const MatrixX jacobian = test::jacobian_of<OmegaLocal>(mechanism);
            const std::vector<int> rows = removable_rows(report);
            CAPTURE(mechanism.joints.size(), static_cast<int>(form), report.rank);
            CHECK(rows == removable_by_trial(jacobian, report.rank));
            removable += rows.size();
            needed += static_cast<std::size_t>(report.rows) - rows.size();
        }
    }
    // both kinds did occur
    CHECK(removable > 50);
    CHECK(needed > 50);
}

TEST_CASE("Where no row is redundant none is removable", "[core][rank]") {
    CHECK(removable_rows(test::rank_of(test::rssr(0.7))).empty());
    CHECK(removable_rows(RankReport{}).empty());
}
