#include "app/commands/exercise_figure.hpp"

#include <algorithm>

#include <catch2/catch.hpp>

#include "tests/app/program.hpp"
#include "tests/app/session/catalogue_lessons.hpp"
#include "tests/app/session/picture_lessons.hpp"
#include "tests/support/read_png.hpp"

namespace jw::test {
namespace {

constexpr int kFigureTestWidth = 640;
constexpr int kFigureTestHeight = 400;

using Png = std::vector<std::uint8_t>;

render::Image image_of(const Png& png) {
    const Folder folder;
    return read_png(folder.file("figure.png", std::string(png.begin(), png.end())));
}

/// Part of the pixels that are not light: paper, and the grid on it, are.
double inked(const render::Image& image) {
    int dark = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const std::uint8_t* const pixel = image.at(x, y);
            dark += *std::min_element(pixel, pixel + 3) < 190 ? 1 : 0;
        }
    }
    return static_cast<double>(dark) / (image.width * image.height);
}

bool is_white(const std::uint8_t* pixel) { return *std::min_element(pixel, pixel + 3) == 255; }

/// Loops that close, one that does not, a free body, joints without a glyph.
std::vector<std::string> lessons_with_figures() {
    std::vector<std::string> names = few_lessons();
    for (const char* const more :
         {"hard/cannot-close", "dynamics/free-asymmetric-body", "vectors/perpendicular-vectors"}) {
        names.emplace_back(more);
    }
    return names;
}

/// The same lesson in another unit of length; how its bodies look is left to the picture.
Lesson in_another_unit(Lesson lesson, double factor) {
    for (Body& body : lesson.mechanism.bodies) { body.r *= factor; }
    for (Joint& joint : lesson.mechanism.joints) {
        joint.geometry.P_i_local *= factor;
        joint.geometry.P_j_local *= factor;
    }
    for (Look& look : lesson.looks) { look.shapes.clear(); }
    return lesson;
}

std::vector<Lesson> odd_lessons() {
    Lesson nothing_moves = lesson_of(SceneBuilder().mechanism);
    Lesson many = chain();
    for (int k = 0; k < 40; ++k) {
        many.mechanism.bodies.push_back(many.mechanism.bodies.back());
        many.looks.emplace_back();
    }
    Lesson upside_down = chain();
    upside_down.camera.from = Vec3::UnitZ();
    upside_down.camera.up = Vec3::UnitZ();
    Lesson far_camera = chain();
    far_camera.camera.target = Vec3(1e6, 0.0, 0.0);
    far_camera.camera.distance = 1e-3;
    return {nothing_moves,
            many,
            upside_down,
            far_camera,
            in_another_unit(chain(), 1e-6),
            in_another_unit(chain(), 1e9)};
}

}  // namespace

TEST_CASE("a figure of an exercise is a picture on white paper, as given and put together", "[app][figure]") {
    ExerciseFigures figures(kFigureTestWidth, kFigureTestHeight);
    for (const std::string& name : lessons_with_figures()) {
        for (const bool as_given : {true, false}) {
            CAPTURE(name, as_given);
            const render::Image image = image_of(figures.png_of(lesson_named(name), as_given));
            CHECK(image.width == kFigureTestWidth);
            CHECK(image.height == kFigureTestHeight);
            CHECK(inked(image) > 0.01);
            CHECK(inked(image) < 0.7);
            CHECK(is_white(image.at(0, 0)));
            CHECK(is_white(image.at(kFigureTestWidth - 1, 0)));
        }
    }
}

TEST_CASE("a figure depends on its lesson alone, not on those drawn before", "[app][figure]") {
    std::vector<Png> first;
    {
        ExerciseFigures figures(kFigureTestWidth, kFigureTestHeight);
        for (const std::string& name : lessons_with_figures()) {
            first.push_back(figures.png_of(lesson_named(name), false));
        }
    }
    ExerciseFigures figures(kFigureTestWidth, kFigureTestHeight);
    for (std::size_t k = first.size(); k-- > 0;) {
        const std::string name = lessons_with_figures()[k];
        CAPTURE(name);
        CHECK(figures.png_of(lesson_named(name), false) == first[k]);
    }
}

TEST_CASE("a lesson that cannot close has the figure of its file", "[app][figure]") {
    ExerciseFigures figures(kFigureTestWidth, kFigureTestHeight);
    const Lesson open = lesson_named("hard/cannot-close");
    CHECK(figures.png_of(open, false) == figures.png_of(open, true));
    // a mechanism that moves in order to close does not look as it was given
    const Lesson closes = lesson_named("loops/four-bar");
    CHECK(figures.png_of(closes, false) != figures.png_of(closes, true));
}

TEST_CASE("odd lessons have figures", "[app][figure]") {
    ExerciseFigures figures(kFigureTestWidth, kFigureTestHeight);
    const std::vector<Lesson> lessons = odd_lessons();
    for (std::size_t k = 0; k < lessons.size(); ++k) {
        for (const bool as_given : {true, false}) {
            CAPTURE(k, as_given);
            CHECK(image_of(figures.png_of(lessons[k], as_given)).width == kFigureTestWidth);
        }
    }
}

}  // namespace jw::test
