#include <stdexcept>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "app/session/background/background.hpp"

// Tests with worker_waiting.cpp, which replaces threads in a page.

namespace jw {
namespace {

/// Work of so many pieces, which adds a line to `done` at each.
Background<int>::Piece counting(int pieces, const std::string& name, std::vector<std::string>& done) {
    return [pieces, name, &done,
            count = std::make_shared<int>(0)](const std::stop_token&) -> std::optional<int> {
        done.push_back(name + std::to_string(++*count));
        if (*count < pieces) { return {}; }
        return *count;
    };
}

TEST_CASE("Without threads nothing is done until the page has time, then piece by piece") {
    std::vector<std::string> done;
    Background<int> work(counting(3, "a", done));
    CHECK(done.empty());
    for (const char* const next : {"a1", "a2", "a3"}) {
        CHECK_FALSE(work.is_done());
        // without any time one piece is done
        CHECK(run_waiting_work(0.0));
        CHECK(done.back() == next);
    }
    CHECK(work.is_done());
    CHECK_FALSE(run_waiting_work(0.0));
    CHECK(done.size() == 3);
    CHECK(work.take() == 3);
}

TEST_CASE("Without threads there is as much done as there is time for, the oldest work first") {
    std::vector<std::string> done;
    Background<int> first(counting(2, "a", done));
    Background<int> second(counting(2, "b", done));
    CHECK(run_waiting_work(60.0));
    CHECK(done == std::vector<std::string>{"a1", "a2", "b1", "b2"});
    CHECK(first.is_done());
    CHECK(second.is_done());
}

TEST_CASE("Without threads work that is waited for is done at once, and others wait on") {
    std::vector<std::string> done;
    Background<int> first(counting(2, "a", done));
    Background<int> second(counting(2, "b", done));
    CHECK(second.take() == 2);
    CHECK(done == std::vector<std::string>{"b1", "b2"});
    CHECK_FALSE(first.is_done());
    CHECK(first.take() == 2);
    CHECK_FALSE(run_waiting_work(60.0));
}

TEST_CASE("Without threads work that is told to stop is over without another piece") {
    std::vector<std::string> done;
    Background<int> work(counting(3, "a", done));
    run_waiting_work(0.0);
    work.stop();
    CHECK(run_waiting_work(60.0));
    CHECK(work.is_done());
    CHECK(done.size() == 1);
    CHECK_THROWS_AS(work.take(), std::bad_optional_access);
}

TEST_CASE("Without threads a failure is told to the one who takes the result") {
    Background<int> work(
        [](const std::stop_token&) -> std::optional<int> { throw std::runtime_error("no"); });
    CHECK(run_waiting_work(60.0));
    CHECK_THROWS_WITH(work.take(), "no");
}

TEST_CASE("Without threads work that nobody wants any more is never begun") {
    std::vector<std::string> done;
    { Background<int> work(counting(3, "a", done)); }
    CHECK_FALSE(run_waiting_work(60.0));
    CHECK(done.empty());
}

}  // namespace
}  // namespace jw
