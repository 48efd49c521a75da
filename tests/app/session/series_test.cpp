#include "app/session/view/series.hpp"

#include <catch2/catch.hpp>

#include <charconv>
#include <cmath>
#include <sstream>

#include "app/session/view/view.hpp"
#include "tests/app/program.hpp"
#include "tests/app/session/catalogue_lessons.hpp"
#include "tests/app/session/picture_lessons.hpp"

namespace jw::test {

namespace {

const Series& series_named(const SeriesSet& set, const std::string& name) {
    CAPTURE(name);
    const auto found = std::ranges::find(set.series, name, &Series::name);
    REQUIRE(found != set.series.end());
    return *found;
}

bool is_complete(const SeriesSet& set) {
    return set.steps.size() == set.at.size() && std::ranges::is_sorted(set.at) &&
           std::ranges::is_sorted(set.steps) &&
           std::ranges::all_of(set.series, [&](const Series& s) { return s.values.size() == set.at.size(); });
}

/// Largest difference between `rate` and the central differences of `value`, in parts of the largest rate.
double misfit(const SeriesSet& set, const Series& value, const Series& rate) {
    double largest = 0.0;
    double wrong = 0.0;
    for (std::size_t k = 1; k + 1 < set.at.size(); ++k) {
        const double slope = (value.values[k + 1] - value.values[k - 1]) / (set.at[k + 1] - set.at[k - 1]);
        largest = std::max(largest, std::abs(rate.values[k]));
        wrong = std::max(wrong, std::abs(slope - rate.values[k]));
    }
    return wrong / std::max(largest, 1e-3);
}

}  // namespace

TEST_CASE("rates and accelerations are the slopes of what is plotted with them", "[app][series]") {
    const Lesson lesson = lesson_named("parallel/which-two-of-three");
    StoryOptions options = poses_only(true);
    options.intervals = 600;
    const Story story(lesson, options);
    const SeriesSet set = motion_series(story, {2, Vec3(0.24, 0.0, 0.0)});
    REQUIRE(is_complete(set));
    REQUIRE(set.at.size() == 601);

    // h = 0.01 s and ω up to about 3/s: differences are off by ω² h²/6 = 1.5e-4; less where ω̈ is larger
    const double tolerance = 1e-3;
    for (const Series& s : set.series) {
        CAPTURE(s.name);
        const auto check = [&](const std::string& rate) {
            CHECK(misfit(set, s, series_named(set, rate)) < tolerance);
        };
        const std::string end = s.name.size() > 2 ? s.name.substr(s.name.size() - 2) : "";
        if (s.name.ends_with(".angle_dot")) { check(s.name.substr(0, s.name.size() - 4) + "_ddot"); }
        if (s.unit == "deg") { check(s.name + "_dot"); }
        const bool is_place = s.unit == "m" && (end == ".x" || end == ".y" || end == ".z");
        const bool of_point = s.name.find(".point") != std::string::npos;
        if (is_place && !of_point) { check(s.name.substr(0, s.name.size() - 2) + ".r_dot" + end); }
        if (s.name.ends_with(".r_dot" + end)) {
            check(s.name.substr(0, s.name.size() - 8) + ".r_ddot" + end);
        }
        if (s.name.ends_with(".omega" + end)) {
            check(s.name.substr(0, s.name.size() - 8) + ".omega_dot" + end);
        }
    }
    CHECK(series_named(set, "turntable.angle").values.back() == Approx(360.0));
    CHECK(series_named(set, "|collar.r|").values.front() == Approx(0.55));
}

TEST_CASE("the speed of the traced point is the length of its path over time", "[app][series]") {
    const Lesson lesson = crank();
    const Story story(lesson);
    const Vec3 local(0.3, -0.1, 0.2);
    const SeriesSet set = motion_series(story, {1, local});
    double path = 0.0;
    double summed = 0.0;
    const auto at = [&](const char* axis, std::size_t k) {
        return series_named(set, std::string("body.point[0.3 -0.1 0.2].") + axis).values[k];
    };
    const Series& speed = series_named(set, "body.point[0.3 -0.1 0.2].speed");
    for (std::size_t k = 1; k < set.at.size(); ++k) {
        path += Vec3(at("x", k) - at("x", k - 1), at("y", k) - at("y", k - 1), at("z", k) - at("z", k - 1))
                    .norm();
        summed += 0.5 * (speed.values[k] + speed.values[k - 1]) * (set.at[k] - set.at[k - 1]);
    }
    // a chord of 270/40 deg is shorter than its arc by (0.118)²/24 = 6e-4
    CHECK(path == Approx(summed).epsilon(1e-3));
}

TEST_CASE("angles that nobody drives go on beyond half a turn", "[app][series]") {
    const Lesson lesson = lesson_named("loops/cardan");
    const Story story(lesson, poses_only(true));
    const SeriesSet set = motion_series(story);
    for (const Series& s : set.series) {
        if (s.unit != "deg") { continue; }
        for (std::size_t k = 1; k < s.values.size(); ++k) {
            CAPTURE(s.name, k);
            REQUIRE(std::abs(s.values[k] - s.values[k - 1]) < 90.0);
        }
    }
}

TEST_CASE("a mark stands where the rows were chosen anew", "[app][series]") {
    const Lesson lesson = lesson_named("parallel/which-two-of-three");
    const Story story(lesson, poses_only(true));
    const SeriesSet set = motion_series(story);
    REQUIRE(set.marks.size() == 3);
    // the lesson's own words: at 67.3, 187.3 and 307.3 deg of 60 deg/s; the first moment after it
    const double interval = 6.0 / 240.0;
    const std::vector<std::string> texts{
        "sleeve p1, p2: x is left out", "sleeve p1, p2: y is left out", "sleeve p1, p2: z is left out"};
    for (std::size_t k = 0; k < 3; ++k) {
        const double exact = (67.3 + 120.0 * static_cast<double>(k)) / 60.0;
        CHECK(set.marks[k].at > exact - 1e-3);  // because 67.3 has three digits
        CHECK(set.marks[k].at < exact + interval);
        CHECK(set.marks[k].text == texts[k]);
        CHECK(set.marks[k].brief == "sleeve switches");
    }
}

TEST_CASE("residuals of all iterations stand in one row, each under its joint", "[app][series]") {
    for (const char* name : {"loops/four-bar", "hard/anti-parallel", "hard/cannot-close"}) {
        CAPTURE(name);
        const Lesson lesson = lesson_named(name);
        const Story story(lesson, poses_only());
        const SeriesSet set = newton_series(story);
        REQUIRE(is_complete(set));
        CHECK(set.logarithmic);
        CHECK(set.series.size() <= lesson.order.size());
        for (std::size_t k = 0; k < set.at.size(); ++k) {
            const auto there =
                std::ranges::count_if(set.series, [k](const Series& s) { return !std::isnan(s.values[k]); });
            REQUIRE(there == 1);
        }
        // the iteration that a step shows is the one whose point leads to it
        for (std::size_t k = 0; k < set.at.size(); ++k) {
            const Step& step = story.steps()[static_cast<std::size_t>(set.steps[k])];
            if (step.kind != Step::Kind::iteration) { continue; }
            if (k > 0 && set.steps[k - 1] == set.steps[k]) { continue; }  // left out of the story
            const View view = view_of(story, set.steps[k]);
            const Series& own =
                *std::ranges::find_if(set.series, [k](const Series& s) { return !std::isnan(s.values[k]); });
            CHECK(own.values[k] == view.newton.back().phi_norm);
        }
    }
}

TEST_CASE("a wrong branch that was left is marked", "[app][series]") {
    const Lesson lesson = lesson_named("hard/anti-parallel");
    const Story story(lesson, poses_only());
    const SeriesSet set = newton_series(story);
    REQUIRE(set.marks.size() == 1);
    CHECK(set.marks[0].text == "left the wrong branch");
}

TEST_CASE("singular values over time are those of the ranks, with their threshold", "[app][series]") {
    const Lesson lesson = lesson_named("loops/parallelogram");
    const Story story(lesson, poses_only(true));
    const SeriesSet set = singular_value_series(story);
    REQUIRE(is_complete(set));
    REQUIRE(set.series.size() > 1);
    CHECK(set.series.back().name == "threshold");
    CHECK(set.series.front().name == "σ₁");
    for (std::size_t k = 0; k < set.at.size(); k += 17) {
        const Step& step = story.steps()[static_cast<std::size_t>(set.steps[k])];
        const RankReport report = rank_of(*step.system, step.state, step.t);
        const auto above = std::ranges::count_if(set.series, [&](const Series& s) {
            return s.name != "threshold" && s.values[k] > set.series.back().values[k];
        });
        CHECK(static_cast<int>(above) == report.rank);
    }
}

TEST_CASE("the condition of a pair of rows is one over the component that is dropped", "[app][series]") {
    const Lesson lesson = lesson_named("parallel/which-two-of-three");
    const Story story(lesson, poses_only(true));
    const SeriesSet set = condition_series(story, 1);
    REQUIRE(is_complete(set));
    REQUIRE(set.series.size() == 8);  // p1 and p2: three drops and the rows in use
    for (const char* role : {"p1", "p2"}) {
        const Series& used = series_named(set, std::string(role) + " in use");
        // √3/0.8 = 2.2 of docs/notation.md for p1 alone; p2 also has arms of up to 0.7 m, and stays near that
        for (const double condition : used.values) { CHECK(condition < 3.0); }
    }
    const Series& x = series_named(set, "p1 drop x");
    const Series& used = series_named(set, "p1 in use");
    const Series& z = series_named(set, "p1 drop z");
    CHECK(used.values.front() == z.values.front());
    // at 2 s sᵢ points along x
    CHECK(used.values[80] == x.values[80]);
    CHECK(x.values[80] == Approx(1.0).margin(1e-9));
}

TEST_CASE("directions of an axis begin with its joint and end where the step is", "[app][series]") {
    const Lesson lesson = lesson_named("parallel/which-two-of-three");
    const Story story(lesson, poses_only(true));
    CHECK(axis_directions(story, 1, 0).empty());
    const int last = static_cast<int>(story.steps().size()) - 1;
    const std::vector<Vec3> path = axis_directions(story, 1, last);
    REQUIRE(path.size() > 241);
    const auto at = [&](int second) {
        return path[path.size() - 241 + 40 * static_cast<std::size_t>(second)];
    };
    // the lesson: along z at the start and after a turn, x after two seconds, y after four
    CHECK(at(0).isApprox(Vec3::UnitZ(), 1e-9));
    CHECK(at(2).isApprox(Vec3::UnitX(), 1e-9));
    CHECK(at(4).isApprox(Vec3::UnitY(), 1e-9));
    CHECK(at(6).isApprox(Vec3::UnitZ(), 1e-9));
}

TEST_CASE("where nothing moves there are no points, and a sentence says so", "[app][series]") {
    const Lesson still = chain();
    const Story story(still);
    for (const SeriesSet& set :
         {motion_series(story), singular_value_series(story), condition_series(story, 0)}) {
        CHECK(set.at.empty());
        CHECK(set.why_empty.starts_with("Nothing moves here"));
    }
    const Lesson moving = lesson_named("loops/cardan");
    const Story with_motion(moving, poses_only(true));
    int without = -1;
    for (std::size_t j = 0; j < moving.mechanism.joints.size(); ++j) {
        if (moving.mechanism.joints[j].type->name == "universal") { without = static_cast<int>(j); }
    }
    REQUIRE(without >= 0);
    CHECK(condition_series(with_motion, without).why_empty.starts_with("This joint has no p1"));
}

TEST_CASE("Energies of a falling mechanism change into each other, and their sum stays", "[app][series]") {
    const Lesson lesson = lesson_named("dynamics/bricard-falling");
    const SeriesSet set = motion_series(Story(lesson));
    const std::vector<double>& kinetic = series_named(set, "energy.kinetic").values;
    const std::vector<double>& potential = series_named(set, "energy.potential").values;
    const std::vector<double>& sum = series_named(set, "energy.sum").values;
    CHECK(kinetic.front() == 0.0);
    const double largest = *std::ranges::max_element(kinetic);
    CHECK(largest > 1.0);
    CHECK(potential.front() - *std::ranges::min_element(potential) == Approx(largest).epsilon(0.05));
    for (const double value : sum) {
        // the lesson's tolerance is 1e-6; a hundred times that, because errors grow on the way
        CHECK(std::abs(value - sum.front()) < 1e-4 * largest);
    }
}

TEST_CASE("a CSV file reads back as the same numbers, commas and quotes in names included", "[app][series]") {
    SeriesSet set;
    set.axis = "t [s]";
    set.at = {0.0, 0.1, 1.0 / 3.0};
    set.steps = {0, 1, 2};
    const double none = std::numeric_limits<double>::quiet_NaN();
    set.series = {
        {"a, \"b\"", "m", {1e-300, -2.0 / 3.0, none}, 0.0, false}, {"c", "-", {4.0, 5e17, -0.1}, 0.0, false}};
    const std::string text = csv_of(set);
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line);
    CHECK(line == "t [s],\"a, \"\"b\"\" [m]\",c");
    for (std::size_t k = 0; k < 3; ++k) {
        std::getline(lines, line);
        std::istringstream cells(line);
        for (const double expected : {set.at[k], set.series[0].values[k], set.series[1].values[k]}) {
            std::string cell;
            std::getline(cells, cell, ',');
            if (std::isnan(expected)) {
                CHECK(cell.empty());
                continue;
            }
            double value = none;
            std::from_chars(cell.data(), cell.data() + cell.size(), value);
            CHECK(value == expected);
        }
    }
    CHECK_FALSE(std::getline(lines, line));
    CHECK(text.find('\r') == std::string::npos);
}

TEST_CASE("curves of dynamics are as fine as a plot is wide, and pass through the steps", "[app][series]") {
    const Lesson lesson = lesson_named("dynamics/simple-pendulum");
    const Story story(lesson);
    const SeriesSet set = motion_series(story);
    REQUIRE(is_complete(set));
    REQUIRE(set.at.size() > 900);
    const int last = static_cast<int>(story.steps().size()) - 1;
    for (int k = story.last_assembled() + 1; k <= last; ++k) {
        // questions and answers are not moments of the motion
        if (story.steps()[static_cast<std::size_t>(k)].kind != Step::Kind::motion) { continue; }
        // the last point up to a step is the step itself
        const auto above = std::ranges::upper_bound(set.steps, k);
        const auto point = static_cast<std::size_t>(above - set.steps.begin()) - 1;
        CHECK(set.at[point] == story.steps()[static_cast<std::size_t>(k)].t);
    }
    // energy is not lost between two steps either: to the tolerance of the integrator
    const Series& kinetic = series_named(set, "energy.kinetic");
    const Series& potential = series_named(set, "energy.potential");
    const double start = kinetic.values[0] + potential.values[0];
    const double most = *std::ranges::max_element(kinetic.values);
    for (std::size_t k = 0; k < set.at.size(); ++k) {
        REQUIRE(std::abs(kinetic.values[k] + potential.values[k] - start) < 1e-4 * most);
    }
}

TEST_CASE("the steps of dynamics are the same to the last bit with a curve and without", "[app][series]") {
    for (const std::string name : {"dynamics/governor", "dynamics/torsion-pendulum"}) {
        const Lesson lesson = lesson_named(name);
        StoryOptions without;
        without.curve_moments = 0;
        CHECK(told(Story(lesson)) == told(Story(lesson, without)));
    }
}

}  // namespace jw::test
