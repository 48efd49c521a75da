#include <catch2/catch.hpp>

#include <random>

#include "app/film/draw_pictures.hpp"
#include "app/film/film_pictures.hpp"
#include "core/jets/euler_parameters.hpp"
#include "lessons/read/reader.hpp"
#include "tests/app/program.hpp"

namespace jw::film::test {
namespace {

Vec4 random_p(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return Vec4(normal(random), normal(random), normal(random), normal(random)).normalized();
}

/// Angle of the turn from one orientation to the other [rad].
double turn_between(const Vec4& a, const Vec4& b) {
    const Mat3 turn = rotation_matrix(a).transpose() * rotation_matrix(b);
    return std::acos(std::clamp(0.5 * (turn.trace() - 1.0), -1.0, 1.0));
}

}  // namespace

TEST_CASE("On its way a body turns evenly, the shorter way round, and its point goes straight", "[film]") {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int sample = 0; sample < 1000; ++sample) {
        State from{{Vec3::Random()}, {random_p(random)}, {0.5}};
        State to{{Vec3::Random()}, {random_p(random)}, {7.5}};
        const double s = share(random);
        const State between = pose_between(from, to, s);
        CHECK(std::abs(between.p[0].norm() - 1.0) < 1e-12);
        // arc cosines of two matrices, each with errors of 1e-16: 1e-8 near 0 and π
        const double whole = turn_between(from.p[0], to.p[0]);
        CHECK(std::abs(turn_between(from.p[0], between.p[0]) - s * whole) < 1e-7);
        CHECK(std::abs(turn_between(between.p[0], to.p[0]) - (1.0 - s) * whole) < 1e-7);
        CHECK((between.r[0] - ((1.0 - s) * from.r[0] + s * to.r[0])).norm() < 1e-15);
        CHECK(between.theta[0] == Approx(0.5 + 7.0 * s));
    }
}

TEST_CASE("A film has every step in order, and its ways take none of the time to read", "[film]") {
    const Lesson lesson = read_lesson_file(jw::test::lesson_path("loops/four-bar.toml")).lesson.value();
    StoryOptions how;
    how.intervals = 20;
    const Story story(lesson, how);
    const int last = static_cast<int>(story.steps().size()) - 1;
    const auto tweened = pictures_of_film(story, 0, last, {20.0, true});
    const auto plain = pictures_of_film(story, 0, last, {20.0, false});
    CHECK(plain.size() == story.steps().size());
    CHECK(tweened.size() > plain.size());
    CHECK(seconds_of(tweened) == Approx(seconds_of(plain)));
    int before = 0;
    double share = 1.0;
    bool moves_in_newton = false;
    for (const FilmPicture& picture : tweened) {
        CHECK(picture.seconds > 0.0);
        CHECK((picture.step == before || (picture.step == before + 1 && share == 1.0)));
        if (picture.step == before) { CHECK((picture.share > share || share == 1.0)); }
        const Step::Kind kind = story.steps()[static_cast<std::size_t>(picture.step)].kind;
        if (picture.share < 1.0) { CHECK(kind != Step::Kind::motion); }
        moves_in_newton = moves_in_newton || (picture.share < 1.0 && kind == Step::Kind::iteration);
        before = picture.step;
        share = picture.share;
    }
    CHECK(before == last);
    CHECK(share == 1.0);
    CHECK(moves_in_newton);
}

TEST_CASE("Parts of a run hold every picture once, and are of one size", "[film]") {
    std::vector<NumberedPicture> all;
    for (int k = 0; k < 103; ++k) { all.push_back({k, {}}); }
    for (const int parts : {1, 2, 7, 103, 200}) {
        int next = 0;
        for (int part = 0; part < parts; ++part) {
            const auto mine = part_of(all, part, parts);
            CHECK(
                mine.size() <=
                (all.size() + static_cast<std::size_t>(parts) - 1) / static_cast<std::size_t>(parts));
            for (const NumberedPicture& numbered : mine) { CHECK(numbered.number == next++); }
        }
        CHECK(next == 103);
    }
}

}  // namespace jw::film::test
