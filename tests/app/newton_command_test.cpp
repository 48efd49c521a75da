#include <catch2/catch.hpp>

#include "app/session/benchmark/newton_runs.hpp"
#include "app/session/output/json.hpp"
#include "tests/app/program.hpp"
#include "tests/app/session/catalogue_lessons.hpp"

namespace jw::test {

TEST_CASE("newton compares methods and coordinates for every lesson", "[app][commands]") {
    for (const auto& file : all_lesson_files()) {
        // a free body: nothing is solved
        if (shipped(file).mechanism.joints.empty()) { continue; }
        for (const std::string compare : {"methods", "coordinates"}) {
            const Ran ran = run({"newton", file.string(), "--compare", compare, "--format", "json"});
            INFO(file << " " << compare << ran.err);
            // the story of a lesson that cannot close ends before its last joint
            if (ran.status == 3) { continue; }
            REQUIRE(ran.status == 0);
            const Json json = Json::parse(ran.out);
            REQUIRE(json.at("runs").size() == 4);
            for (const Json& one : json.at("runs")) {
                CHECK(one.at("iterates").size() >= 1);
                for (const Json& iterate : one.at("iterates")) { CHECK(iterate.at("phi_norm").is_number()); }
            }
            CHECK_FALSE(json.at("summary").get<std::string>().empty());
        }
    }
}

TEST_CASE("the first numbers of all methods are those of one and the same start", "[app][commands]") {
    const Ran ran = run({"newton", lesson_path("loops/four-bar.toml"), "--at", "D", "--format", "json"});
    const Json json = Json::parse(ran.out);
    const Json& runs = json.at("runs");
    for (const Json& one : runs) {
        CHECK(one.at("converged") == true);
        CHECK(one.at("iterates")[0].at("phi_norm") == runs[0].at("iterates")[0].at("phi_norm"));
    }
    // quadratic near a regular solution; measured from three residuals only
    CHECK(runs[1].at("order").get<double>() == Approx(2.0).margin(0.2));
}

TEST_CASE("newton says which solutions are not meant", "[app][commands]") {
    const Ran ran = run({"newton", lesson_path("hard/anti-parallel.toml"), "--at", "hinge"});
    CHECK(ran.status == 0);
    CHECK(ran.out.find("wrong branch") != std::string::npos);
    CHECK(ran.out.find("point in opposite directions (cosine -1)") != std::string::npos);
    const Ran none = run({"newton", lesson_path("hard/cannot-close.toml"), "--at", "D"});
    CHECK(none.out.find("No method closed it from here.") != std::string::npos);
    CHECK(none.err.find("No method closed it from here.") != std::string::npos);
    CHECK(none.status == 3);
}

TEST_CASE("without a name newton compares where most happens", "[app][commands]") {
    // its driver, added last, takes more iterations, but the wrong branch is what the lesson is about
    const std::string lesson = lesson_path("hard/anti-parallel.toml");
    const Ran ran = run({"newton", lesson, "--format", "json"});
    CHECK(ran.out == run({"newton", lesson, "--at", "hinge", "--format", "json"}).out);
    for (const auto& file : all_lesson_files()) {
        const Lesson told = shipped(file);
        const Story story(told, poses_only());
        const int start = start_of_telling_closing(story);
        CAPTURE(file, start);
        if (told.order.empty()) {
            CHECK(start == -1);
            continue;
        }
        REQUIRE(start >= 0);
        const auto events_from = [&](int first) {
            std::size_t events = 0;
            for (std::size_t k = static_cast<std::size_t>(first) + 1; k < story.steps().size(); ++k) {
                if (story.steps()[k].kind == Step::Kind::equations) { break; }
                events = std::max(events, story.steps()[k].events.size());
            }
            return events;
        };
        const auto has_branch_from = [&](int first) {
            const Step& next = story.steps()[static_cast<std::size_t>(first) + 1];
            const auto all = events_from(first);
            std::size_t k = static_cast<std::size_t>(first) + 1;
            while (story.steps()[k].additions == next.additions && story.steps()[k].events.size() < all) {
                ++k;
            }
            return std::ranges::any_of(story.steps()[k].events, [](const PositionEvent& event) {
                return std::holds_alternative<WrongBranch>(event);
            });
        };
        for (int k = 0; k < static_cast<int>(story.steps().size()); ++k) {
            const Step& step = story.steps()[static_cast<std::size_t>(k)];
            if (step.kind != Step::Kind::equations) { continue; }
            CHECK((events_from(start) >= events_from(k) || has_branch_from(start)));
        }
    }
}

TEST_CASE("without normalisation rows Newton goes another way", "[app][commands]") {
    const std::string revolute = lesson_path("joints/revolute.toml");
    const auto iterations = [&](std::vector<std::string> more) {
        std::vector<std::string> arguments{"newton", revolute, "--at", "hinge", "--format", "csv"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const std::string csv = run(arguments).out;
        return std::ranges::count(csv, '\n') - 2;  // the header, and the start
    };
    CHECK(iterations({}) == 4);
    CHECK(iterations({"--without-normalisation"}) < iterations({}) + 1);
    CHECK(
        iterations({"--coordinates", "omega-local", "--without-normalisation"}) ==
        iterations({"--coordinates", "omega-local"}));
}

TEST_CASE("newton asks for a joint that is there", "[app][commands]") {
    const Ran ran = run({"newton", lesson_path("loops/four-bar.toml"), "--at", "moter"});
    CHECK(ran.status == 2);
    CHECK(
        ran.err ==
        "jointwise: error: --at 'moter': no such joint or driver; expected one of A, B, C, D, motor\n"
        "hint: did you mean 'motor'?\n");
}

}  // namespace jw::test
