#include "app/session/benchmark/prices.hpp"

#include <catch2/catch.hpp>

#include <chrono>
#include <cmath>

#include "app/session/benchmark/bench_job.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/read/reader.hpp"

namespace jw {
namespace {

BenchPoint point(double cpu, double position) {
    BenchPoint out;
    out.cpu = cpu;
    out.position = position;
    return out;
}

std::vector<BenchRun> three_runs() {
    const double failed = std::nan("");
    return {
        {"", Method::explicit_5, {}, {point(1e-3, 1e-2), point(2e-3, 5e-5), point(9e-3, 2e-7)}},
        {"", Method::explicit_8, {}, {point(3e-3, 1e-4), point(4e-3, 1e-8), point(5e-3, 1e-12)}},
        {"", Method::implicit_5, {}, {point(7e-3, failed)}}};
}

Lesson pendulum() {
    return *read_lesson_file(catalogue_folder() / "dynamics" / "simple-pendulum.toml").lesson;
}

BenchPlan one_method() {
    BenchPlan plan;
    plan.methods = {Method::explicit_8};
    plan.least_time = 0.0;
    return plan;
}

BenchJob::News waited_for(const BenchJob& job) {
    while (!job.news().done) { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }
    return job.news();
}

}  // namespace

TEST_CASE("The price of a digit is the cheapest run that has it, of runs that reached the end") {
    const Prices prices = prices_of(three_runs());
    REQUIRE(prices.rows.size() == 3);
    CHECK(prices.rows[0].name == "explicit-5");
    CHECK(prices.rows[0].milliseconds[0] == Approx(2.0));
    CHECK(prices.rows[0].milliseconds[1] == Approx(9.0));
    CHECK_FALSE(prices.rows[0].milliseconds[2]);
    CHECK(prices.rows[1].milliseconds[2] == Approx(5.0));
    CHECK(prices.rows[1].finest == 1e-12);
    CHECK_FALSE(prices.rows[2].milliseconds[0]);
    CHECK(std::isnan(prices.rows[2].finest));
    CHECK(
        prices.summary ==
        "1e-3 m: explicit-5 in 2 ms, 1.5 times as fast as explicit-8. "
        "1e-6 m: explicit-8 in 4 ms, 2.2 times as fast as explicit-5. "
        "1e-9 m: explicit-8 in 5 ms; no other method reached it. ");
    CHECK(prices_of({}).summary.empty());
    CHECK_FALSE(prices_of({}).curves.why_empty.empty());
}

TEST_CASE("Measured beside something else, the errors are the same") {
    const Lesson lesson = pendulum();
    const auto reference = stored_reference(catalogue_folder() / "dynamics" / "simple-pendulum.toml");
    REQUIRE(reference);
    const std::vector<BenchRun> alone = bench_dynamics(lesson, *reference, one_method());
    const BenchJob job(lesson, reference, one_method());
    const BenchJob::News news = waited_for(job);
    CHECK(news.failure.empty());
    CHECK(news.origin == reference->origin);
    REQUIRE(news.runs.size() == 1);
    REQUIRE(news.runs[0].points.size() == alone[0].points.size());
    for (std::size_t k = 0; k < alone[0].points.size(); ++k) {
        CHECK(news.runs[0].points[k].position == alone[0].points[k].position);
        CHECK(news.runs[0].points[k].counts.evaluations == alone[0].points[k].counts.evaluations);
    }
}

TEST_CASE("A measurement that nobody waits for any more stops within its run") {
    BenchPlan plan = one_method();
    plan.least_time = 1e6;  // repeated for days, if it could not be stopped
    { const BenchJob job(pendulum(), std::nullopt, plan); }
    std::stop_source nobody_waits;
    nobody_waits.request_stop();
    CHECK_THROWS_AS(own_reference(pendulum(), nobody_waits.get_token()), Stopped);
    const BenchJob job(
        pendulum(), stored_reference(catalogue_folder() / "dynamics" / "simple-pendulum.toml"), plan);
    while (job.news().origin.empty()) { std::this_thread::yield(); }
    CHECK_FALSE(job.news().done);
}

TEST_CASE("The stored reference is that of the shipped file, not of one that is called the same") {
    CHECK_FALSE(stored_reference("simple-pendulum.toml"));
    CHECK_FALSE(stored_reference(catalogue_folder() / ".." / ".." / "simple-pendulum.toml"));
}

TEST_CASE("A reference that is made where none is stored is the stored one") {
    for (const char* name : {"simple-pendulum.toml", "spatial-slider-crank-falling.toml"}) {
        const std::filesystem::path file = catalogue_folder() / "dynamics" / name;
        const Reference made = own_reference(*read_lesson_file(file).lesson);
        const Reference stored = *stored_reference(file);
        REQUIRE(made.positions.size() == stored.positions.size());
        double apart = 0.0;
        for (std::size_t k = 0; k < made.positions.size(); ++k) {
            apart = std::max(apart, (made.positions[k] - stored.positions[k]).norm());
        }
        CAPTURE(name, made.origin);
        // the two ways are 1e-11 m and 1e-13 m apart
        CHECK(apart < 1e-9);
        CHECK(made.origin.find("digits agree") != std::string::npos);
    }
}

TEST_CASE("Where a lesson cannot be integrated to its end there is nothing to compare with") {
    Lesson tilted = *read_lesson_file(catalogue_folder() / "dynamics" / "four-bar-1.toml").lesson;
    Vec3& axis = tilted.mechanism.joints.back().geometry.s_j_local;
    axis = (axis + 0.1 * perpendicular_to(axis)).normalized();
    CHECK_THROWS_AS(own_reference(tilted), std::runtime_error);
    const BenchJob job(tilted, std::nullopt, one_method());
    CHECK(waited_for(job).failure.find("nothing to compare with") != std::string::npos);
}

TEST_CASE("A plan that no method can follow is told as it is") {
    BenchPlan plan;
    plan.methods = {Method::implicit_5};
    plan.treatment = Treatment::none;
    const BenchJob job(
        pendulum(), stored_reference(catalogue_folder() / "dynamics" / "simple-pendulum.toml"), plan);
    CHECK(waited_for(job).failure.find("implicit methods keep the constraints") != std::string::npos);
}

}  // namespace jw
