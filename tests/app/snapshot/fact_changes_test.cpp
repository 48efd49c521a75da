#include <catch2/catch.hpp>

#include "app/snapshot/facts/fact_changes.hpp"
#include "app/snapshot/facts/fact_list.hpp"

namespace jw::snapshot {
namespace {

Fact number(const std::string& name, double value, double tolerance, const std::string& unit = "m") {
    return {Weight::pose, name, {}, value, unit, tolerance};
}

}  // namespace

TEST_CASE("texts say the same if their numbers differ by rounding alone", "[snapshot]") {
    CHECK(say_the_same("rank 5", "rank 5"));
    CHECK(say_the_same("largest 0.0696 m", "largest 0.0697 m"));
    CHECK(say_the_same("2.2e-16 left", "1.3e-17 left"));
    CHECK(say_the_same("−2.2e-16 left", "1.3e-17 left"));
    CHECK(say_the_same("1.2e+03", "1.3e+03"));

    CHECK_FALSE(say_the_same("rank 5", "rank 4"));
    CHECK_FALSE(say_the_same("largest 0.0696 m", "largest 0.0698 m"));
    CHECK_FALSE(say_the_same("largest 0.0696 m", "largest 0.0696 rad"));
    CHECK_FALSE(say_the_same("x −1.5", "x 1.5"));
    CHECK_FALSE(say_the_same("5 equations", "5 equations and more"));
    CHECK_FALSE(say_the_same("2.2e-16 left", "2.2e-06 left"));
}

TEST_CASE("a number may be off by its tolerance and no more", "[snapshot]") {
    const std::vector<Fact> before{number("crank · r · x", 0.25, 1e-6)};
    CHECK(changes_of(before, {number("crank · r · x", 0.25 + 0.9e-6, 1e-6)}).empty());
    const auto changes = changes_of(before, {number("crank · r · x", 0.25 + 1.1e-6, 1e-6)});
    REQUIRE(changes.size() == 1);
    CHECK(changes[0] == FactChange{Weight::pose, "crank · r · x", "0.25 m", "0.2500011 m"});
    // the tolerance is that of the golden snapshot: a looser one in the new facts allows nothing
    CHECK(changes_of(before, {number("crank · r · x", 0.26, 1.0)}).size() == 1);
    CHECK(changes_of(before, {number("crank · r · x", 0.25, 1e-6, "mm")}).size() == 1);
}

TEST_CASE(
    "numbers in words of the author are exact, those in sentences of the program are rounded", "[snapshot]") {
    const auto change = [](const std::string& name) {
        const auto text = [&](const char* words) {
            return Fact{Weight::text, name, words, std::nullopt, {}, 0.0};
        };
        return changes_of({text("less than 1.2 m")}, {text("less than 1.3 m")}).size();
    };
    for (const char* const name : {"text of the author", "question", "choice (2)", "reason of the answer"}) {
        CHECK(change(name) == 1);
    }
    CHECK(change("sentence") == 0);
}

TEST_CASE("facts that come and go are changes, but for numbers that are nothing", "[snapshot]") {
    const std::vector<Fact> none;
    const std::vector<Fact> some{number("a", 1.0, 1e-6), number("b", 5e-7, 1e-6)};
    REQUIRE(changes_of(none, some).size() == 1);
    CHECK(changes_of(none, some)[0] == FactChange{Weight::pose, "a", "", "1 m"});
    REQUIRE(changes_of(some, none).size() == 1);
    CHECK(changes_of(some, none)[0] == FactChange{Weight::pose, "a", "1 m", ""});
    // a count has no tolerance, and a count of zero is a fact
    CHECK(changes_of(none, {{Weight::rank, "rank", {}, 0.0, {}, 0.0}}).size() == 1);
}

TEST_CASE("a tolerance is believed up to a hundred times that of the program", "[snapshot]") {
    const std::vector<Fact> now{number("a", 0.25, 1e-6), number("b", 1.0, 1e-6)};
    CHECK(loose_tolerances({number("a", 0.25, 1e-4)}, now).empty());
    CHECK(
        loose_tolerances({number("a", 0.25, 1.1e-4)}, now) ==
        std::vector<std::string>{"a: 0.00011 m may differ, of 1e-06 m"});
    // a count that a tolerance would let pass
    CHECK(loose_tolerances({number("n", 7.0, 1e9)}, {number("n", 5.0, 0.0)}).size() == 1);
    // a fact that is reported as a change needs no second message
    CHECK(loose_tolerances({number("a", 2.0, 1.0)}, now).empty());
    // a number that is missing is not taken for zero
    REQUIRE(changes_of({number("c", 5.0, 1e9)}, now).size() == 3);
}

TEST_CASE("what matters most comes first", "[snapshot]") {
    FactList before;
    before.number(Weight::detail, "σ1", 1.0, "of σ");
    before.count(Weight::rank, "rank", 5);
    before.text(Weight::text, "title", "Joint A");
    FactList after;
    after.number(Weight::detail, "σ1", 2.0, "of σ");
    after.count(Weight::rank, "rank", 4);
    after.text(Weight::text, "title", "Joint B");
    std::vector<Fact> a = before.take();
    std::vector<Fact> b = after.take();
    set_tolerances({&a}, {});
    set_tolerances({&b}, {});
    const auto changes = changes_of(a, b);
    REQUIRE(changes.size() == 3);
    CHECK(changes[0].name == "rank");
    CHECK(changes[1].name == "title");
    CHECK(changes[2].name == "σ1");
}

TEST_CASE("the scale of a quantity is the largest of its unit in the lesson", "[snapshot]") {
    FactList here;
    here.number(Weight::pose, "x", 1e-3, "m");
    here.number(Weight::quantity, "f", 1e-3, "N");
    FactList there;
    there.number(Weight::pose, "y", 250.0, "m");
    std::vector<Fact> a = here.take();
    std::vector<Fact> b = there.take();
    set_tolerances({&a, &b}, {0.5, 1.0});
    CHECK(a[0].tolerance == Approx(1e-4));
    CHECK(a[1].tolerance == Approx(1e-9));
    // far below a thousandth of the mechanism's size: the scale is that thousandth
    FactList small;
    small.number(Weight::detail, "Φ", 1e-15, "m");
    std::vector<Fact> c = small.take();
    set_tolerances({&c}, {1.0, 1.0});
    CHECK(c[0].tolerance == Approx(1e-9));
    CHECK(*c[0].value == 0.0);
}

TEST_CASE("facts of one name are numbered, and what is not finite is a word", "[snapshot]") {
    FactList facts;
    facts.text(Weight::text, "choice", "a");
    facts.text(Weight::text, "choice", "b");
    facts.number(Weight::quantity, "condition", std::numeric_limits<double>::infinity(), "");
    facts.number(Weight::quantity, "rate", std::nan(""), "");
    const std::vector<Fact> list = facts.take();
    CHECK(list[1].name == "choice (2)");
    CHECK(list[2].text == "infinite");
    CHECK(list[3].text == "not a number");
}

}  // namespace jw::snapshot
