#pragma once

#include <rapidcheck.h>

#include "tests/support/generators/recipe.hpp"

/// Generator of recipes for rapidcheck, and their shrinking: lists lose parts, numbers go to 0, seeds stay.
namespace rc {

namespace soak {

// rapidcheck's ranges grow with the size; these are complete from the first mechanism on
constexpr int kWhole = 100;
inline Gen<int> range(int from, int below) { return gen::resize(kWhole, gen::inRange(from, below)); }
inline Gen<int> number(int count) { return range(0, count); }
inline Gen<int> seed() { return gen::noShrink(range(0, 1 << 28)); }
/// 0 in four of five, else from -most to most.
inline Gen<int> decade(int most) {
    return gen::weightedOneOf<int>({{4, gen::just(0)}, {1, range(-most, most + 1)}});
}
inline Gen<bool> one_in(int count) {
    return gen::map(number(count), [count](int k) { return k == count - 1; });
}

}  // namespace soak

template <>
struct Arbitrary<jw::test::BodyRecipe> {
    static Gen<jw::test::BodyRecipe> arbitrary() {
        using T = jw::test::BodyRecipe;
        // the last two of the 17 numbers mean a free body
        const auto joint = gen::map(soak::number(17), [](int k) { return k < 15 ? k : jw::test::kFreeBody; });
        return gen::build<T>(
            gen::set(&T::parent, soak::number(12)), gen::set(&T::joint, joint),
            gen::set(&T::form, soak::number(6)), gen::set(&T::mass_decade, soak::decade(3)),
            gen::set(&T::offset, soak::one_in(2)), gen::set(&T::seed, soak::seed()));
    }
};

template <>
struct Arbitrary<jw::test::JointRecipe> {
    static Gen<jw::test::JointRecipe> arbitrary() {
        using T = jw::test::JointRecipe;
        const auto without = gen::map(soak::number(20), [](int k) { return k < 14 ? 0 : k - 13; });
        return gen::build<T>(
            gen::set(&T::type, soak::number(15)), gen::set(&T::i, soak::number(12)),
            gen::set(&T::j, soak::number(12)), gen::set(&T::form, soak::number(6)),
            gen::set(&T::repeats, soak::one_in(4)), gen::set(&T::without, without),
            gen::set(&T::seed, soak::seed()));
    }
};

template <>
struct Arbitrary<jw::test::DriverRecipe> {
    static Gen<jw::test::DriverRecipe> arbitrary() {
        using T = jw::test::DriverRecipe;
        return gen::build<T>(
            gen::set(&T::quantity, soak::number(4)), gen::set(&T::joint, soak::number(12)),
            gen::set(&T::i, soak::number(12)), gen::set(&T::j, soak::number(12)),
            gen::set(&T::function, soak::number(8)), gen::set(&T::seed, soak::seed()));
    }
};

template <>
struct Arbitrary<jw::test::LoadRecipe> {
    static Gen<jw::test::LoadRecipe> arbitrary() {
        using T = jw::test::LoadRecipe;
        return gen::build<T>(
            gen::set(&T::kind, soak::number(8)), gen::set(&T::i, soak::number(12)),
            gen::set(&T::j, soak::number(12)), gen::set(&T::damped, soak::one_in(2)),
            gen::set(&T::seed, soak::seed()));
    }
};

template <>
struct Arbitrary<jw::test::Recipe> {
    static Gen<jw::test::Recipe> arbitrary() {
        using T = jw::test::Recipe;
        const auto family = gen::map(soak::number(5), [](int k) {
            return k < 3    ? jw::test::Family::general
                   : k == 3 ? jw::test::Family::planar
                            : jw::test::Family::concurrent;
        });
        const auto near = gen::map(soak::number(15), [](int k) { return k < 11 ? 0 : k - 10; });
        // up to so many at size 100, rapidcheck's largest; half of that from the first mechanism on
        const auto list = [](double most, auto what) {
            return gen::withSize([=](int size) {
                const double share = std::min(1.0, 0.005 * (100.0 + size));
                return gen::resize(
                    static_cast<int>(most * share),
                    gen::container<std::vector<decltype(what)>>(gen::arbitrary<decltype(what)>()));
            });
        };
        return gen::build<T>(
            gen::set(&T::family, family), gen::set(&T::near, near),
            gen::set(&T::length_decade, soak::decade(3)), gen::set(&T::gravity, soak::one_in(2)),
            gen::set(&T::at_rest, soak::one_in(6)), gen::set(&T::drive_all, soak::one_in(8)),
            gen::set(&T::seed, soak::seed()), gen::set(&T::bodies, list(9.0, jw::test::BodyRecipe{})),
            gen::set(&T::joints, list(4.0, jw::test::JointRecipe{})),
            gen::set(&T::drivers, list(3.0, jw::test::DriverRecipe{})),
            gen::set(&T::loads, list(4.0, jw::test::LoadRecipe{})));
    }
};

}  // namespace rc
