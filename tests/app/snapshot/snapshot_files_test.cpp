#include <catch2/catch.hpp>

#include <random>

#include "app/snapshot/facts/facts_file.hpp"
#include "tests/app/program.hpp"

namespace jw::snapshot {
namespace {

Record sample() {
    Record record;
    record.name = "A-equations";
    record.title = "Joint \"A\" · revolute\n";
    record.drawn_with = {{"renderer", "llvmpipe"}};
    record.blessed = {"first", "second: \\ and ü"};
    record.things = {{"#3fa2c4", "crank"}};
    record.facts = {
        {Weight::rank, "rank", {}, 5.0, {}, 0.0},
        {Weight::pose, "crank · r · x", {}, -0.25, "m", 1e-6},
        {Weight::text, "title", "a\tb", std::nullopt, {}, 0.0}};
    return record;
}

}  // namespace

TEST_CASE("a record is read as it was written", "[snapshot]") {
    const Record written = sample();
    const Record read = record_of(text_of(written), "a.json");
    CHECK(read.name == written.name);
    CHECK(read.title == written.title);
    CHECK(read.drawn_with == written.drawn_with);
    CHECK(read.blessed == written.blessed);
    CHECK(read.things == written.things);
    CHECK(read.facts == written.facts);
    CHECK(text_of(read) == text_of(written));
}

TEST_CASE("a record that is cut off or changed anywhere is read or refused, never more", "[snapshot]") {
    const std::string whole = text_of(sample());
    for (std::size_t length = 0; length < whole.size() - 2; ++length) {
        CHECK_THROWS_AS(record_of(whole.substr(0, length), "a.json"), std::runtime_error);
    }
    constexpr unsigned seed = 7;
    std::mt19937 random(seed);
    int refused = 0;
    for (int k = 0; k < 3000; ++k) {
        std::string text = whole;
        text[random() % text.size()] = static_cast<char>(random() % 256);
        try {
            static_cast<void>(record_of(text, "a.json"));
        } catch (const std::runtime_error&) { ++refused; }
    }
    INFO("seed " << seed);
    CHECK(refused > 300);
}

TEST_CASE("a record with a fact twice, or a count that is none, is refused", "[snapshot]") {
    const std::string whole = text_of(sample());
    const std::string rank = R"(["rank","rank",5])";
    const auto with = [&](const std::string& facts) {
        std::string text = whole;
        return text.replace(text.find(rank), rank.size(), facts);
    };
    CHECK(record_of(with(R"(["rank","rank",4])"), "a.json").facts[0].value == 4.0);
    for (const char* const facts :
         {R"(["rank","rank",5],["rank","rank",4])", R"(["rank","rank",0.4])", R"(["rank","rank",1e308])",
          R"(["rank","rank",18446744073709551615])"}) {
        INFO(facts);
        CHECK_THROWS_AS(record_of(with(facts), "a.json"), std::runtime_error);
    }
}

}  // namespace jw::snapshot
