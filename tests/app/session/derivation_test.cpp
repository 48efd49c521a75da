#include <catch2/catch.hpp>

#include "app/session/view/derivation.hpp"
#include "app/session/view/view.hpp"
#include "app/session/wording/numbers.hpp"
#include "tests/app/session/catalogue_lessons.hpp"

namespace jw::test {

TEST_CASE("the row of a derivation has the entry of the matrix, in all coordinates", "[app][derivation]") {
    int entries = 0;
    for (const std::string& name : few_lessons()) {
        for (const CoordinateChoice choice :
             {CoordinateChoice::true_euler_parameters, CoordinateChoice::modified_euler_parameters,
              CoordinateChoice::omega_local, CoordinateChoice::omega_global}) {
            Lesson lesson = without_motion(lesson_named(name));
            lesson.coordinates = choice;
            const Story story(lesson);
            const int index = story.last_assembled();
            const Step& step = story.steps()[static_cast<std::size_t>(index)];
            const MatrixView matrix = view_of(story, index).matrix;
            for (int row = 0; row < matrix.values.rows(); ++row) {
                for (int column = 0; column < matrix.values.cols(); ++column) {
                    const auto derivation = derivation_of(step, matrix.choice, row, column);
                    if (!derivation) { continue; }
                    CAPTURE(name, row, column, derivation->formula, derivation->row);
                    CHECK(derivation->entry == Approx(matrix.values(row, column)).margin(1e-13));
                    CHECK_THAT(derivation->row, Catch::Contains(number_text(derivation->entry, 3)));
                    ++entries;
                }
            }
        }
    }
    CHECK(entries > 1000);
}

}  // namespace jw::test
