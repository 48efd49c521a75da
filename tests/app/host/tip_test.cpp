#include <catch2/catch.hpp>

#include <algorithm>

#include "lessons/formula/text_symbols.hpp"
#include "lessons/math/read_math.hpp"
#include "tests/app/host/looking.hpp"
#include "tests/support/golden.hpp"

/// Symbols of texts: their tips beside the pointer or, with the keyboard, beside the symbol.
namespace jw::test {
namespace {

/// The lesson on slide 3 where p1 stands, whose text names vectors of the joint.
constexpr const char* kLesson = "parallel/parallel-vectors.toml";

const std::vector<SymbolView>& symbols_of(const Person& person) { return person.view().symbols; }

/// s_i in the text of the step, -1 if it is not there.
int index_of_s_i(const Person& person) {
    const auto symbol = formula::text_symbol_of(math::own_math("\\mathbf{s}_i").front());
    return index_of_symbol(symbols_of(person), {}, symbol.value().source);
}

/// Goes to the first step whose text has s_i.
/// @return the step
int go_to_s_i(Person& person) {
    for (int step = 0; step < person.view().steps; ++step) {
        person.go_to(step);
        if (index_of_s_i(person) >= 0) { return step; }
    }
    FAIL("no text has it");
    return -1;
}

/// Fraction of the pixels that differ at all.
double changed(const render::Image& a, const render::Image& b) {
    int pixels = 0;
    for (std::size_t k = 0; k + 2 < a.rgb.size(); k += 3) {
        pixels += std::equal(&a.rgb[k], &a.rgb[k] + 3, &b.rgb[k]) ? 0 : 1;
    }
    return 3.0 * pixels / static_cast<double>(a.rgb.size());
}

}  // namespace

TEST_CASE("Pointing at a vector of a text outlines it in the picture and tells its numbers", "[tip]") {
    Person person(kLesson, Person::Pictures::drawn);
    go_to_s_i(person);
    const int symbol = index_of_s_i(person);
    const int joint = person.view().equations.front().joint;
    const int arrow = picture_id(Pointable::vector(joint, Pointable::kVectorI));
    person.point(2.0F, 2.0F);
    const render::Image before = person.picture();
    REQUIRE_FALSE(lit_in(person.host().picture()).contains(arrow));
    REQUIRE(look_for(person, person.host().layout().caption, 3.0F, 5.0F, [&](const Pointable& link) {
        return link == Pointable::symbol(symbol);
    }));
    CHECK(lit_in(person.host().picture()).contains(arrow));
    // a tip of three lines is more than a fiftieth of the window
    CHECK(changed(before, person.picture()) > 0.02);
    person.point(2.0F, 2.0F);
    CHECK_FALSE(lit_in(person.host().picture()).contains(arrow));
}

TEST_CASE("t and T go through the symbols of a text and back, and the next step begins anew", "[tip]") {
    Person person(kLesson);
    const int step = go_to_s_i(person);
    const auto chosen = [&] { return person.host().state().symbol; };
    const auto of_texts = static_cast<int>(std::ranges::count_if(
        symbols_of(person), [](const SymbolView& symbol) { return symbol.scope.empty(); }));
    REQUIRE(of_texts >= 2);
    CHECK(chosen() == -1);
    for (int k = 0; k < of_texts; ++k) {
        person.type("t");
        CHECK(chosen() == k);
    }
    person.type("t");
    CHECK(chosen() == -1);
    person.type("T");
    CHECK(chosen() == of_texts - 1);
    person.go_to(step + 1);
    CHECK(chosen() == -1);
}

TEST_CASE("The tip of a symbol looks as it did when it was looked at", "[tip][golden]") {
    struct Case {
        const char* file;
        float text;
        bool dark;
    };
    for (const Case& c :
         {Case{"tests/golden/tip.png", 1.0F, false}, Case{"tests/golden/tip-large-dark.png", 1.5F, true}}) {
        Person person(kLesson, Person::Pictures::drawn, 1280, 720, c.dark, c.text);
        go_to_s_i(person);
        const int symbol = index_of_s_i(person);
        while (person.host().state().symbol != symbol) { person.type("t"); }
        compare_with_golden(c.file, person.picture());
    }
}

}  // namespace jw::test
