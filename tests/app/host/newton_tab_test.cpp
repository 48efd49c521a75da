#include <catch2/catch.hpp>

#include <algorithm>

#include "app/session/benchmark/newton_runs.hpp"
#include "tests/app/host/person.hpp"

namespace jw::test {

TEST_CASE("The Newton tab shows iterates during the motion, of the joint that tells the most") {
    Person person("hard/anti-parallel.toml");
    person.type("4");
    const auto ghosts = [&] {
        person.settle();
        return std::ranges::count_if(person.host().picture().scene.shapes, [](const render::Shape& shape) {
            return shape.colour.a < 1.0F;
        });
    };
    const int start = start_of_telling_closing(person.session().story());
    person.go_to(start);
    const auto at_joint = ghosts();
    REQUIRE(at_joint > 0);
    person.go_to(person.session().story().last_assembled() + 1);
    CHECK(ghosts() == at_joint);
    person.go_to(0);
    CHECK(ghosts() == at_joint);
}

}  // namespace jw::test
