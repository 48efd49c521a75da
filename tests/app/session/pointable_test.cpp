#include "app/session/picture/pointable.hpp"

#include <catch2/catch.hpp>

#include "tests/app/session/catalogue_lessons.hpp"

namespace jw::test {
namespace {

constexpr int kParts[] = {Pointable::kVectorI, Pointable::kVectorJ, Pointable::kVectorD};

struct Linked {
    const System& system;
    int angular;

    bool both_ways(const Pointable& a, const Pointable& b) const {
        return Emphasis(system, angular, a).contains(b) && Emphasis(system, angular, b).contains(a);
    }
};

}  // namespace

TEST_CASE("a row lights up its vectors and a vector its rows, in every lesson", "[app][session]") {
    for (const auto& file : all_lesson_files()) {
        const Lesson lesson = without_motion(shipped(file));
        const Story story(lesson);
        const System& system = *story.steps().back().system;
        const Linked linked{system, 3};
        for (int row = 0; row < system.rows(); ++row) {
            const RowOrigin origin = system.origin(row);
            if (origin.kind != RowOrigin::Kind::constraint) { continue; }
            const int joint = system.constraints()[static_cast<std::size_t>(origin.index)].joint;
            INFO(file << " row " << row);
            CHECK(linked.both_ways(Pointable::row(row), Pointable::joint(joint)));
            int vectors = 0;
            for (int j = 0; j < static_cast<int>(lesson.mechanism.joints.size()); ++j) {
                for (const int part : kParts) {
                    const Pointable vector = Pointable::vector(j, part);
                    if (!Emphasis(system, 3, Pointable::row(row)).contains(vector)) { continue; }
                    ++vectors;
                    CHECK(j == joint);
                    CHECK(linked.both_ways(Pointable::row(row), vector));
                }
            }
            CHECK(vectors >= 1);
            // an angle is measured about an axis from one vector to another
            const bool is_angle =
                has_theta(system.constraints()[static_cast<std::size_t>(origin.index)].role);
            CHECK(vectors <= (is_angle ? 3 : 2));
        }
    }
}

TEST_CASE("a vector that no equation has lights up itself alone", "[app][session]") {
    const Lesson lesson = without_motion(lesson_named("loops/four-bar"));
    const Story story(lesson);
    const System& system = *story.steps().back().system;
    const Pointable d = Pointable::vector(0, Pointable::kVectorD);  // a revolute has no d
    const Emphasis emphasis(system, 3, d);
    CHECK(emphasis.contains(d));
    for (int row = 0; row < system.rows(); ++row) { CHECK_FALSE(emphasis.contains(Pointable::row(row))); }
    CHECK(Emphasis(system, 3, Pointable{}).empty());
}

TEST_CASE("a body lights up its columns and a column its body, in all coordinates", "[app][session]") {
    for (const auto& file : all_lesson_files()) {
        const Lesson lesson = without_motion(shipped(file));
        const Story story(lesson);
        const System& system = *story.steps().back().system;
        for (const int angular : {3, 4}) {
            const Linked linked{system, angular};
            std::vector<int> owners(static_cast<std::size_t>(system.columns(angular)), 0);
            for (const int body : system.moving_bodies()) {
                const int first = system.body_column(body, angular);
                for (int k = first; k < first + 3 + angular; ++k) {
                    ++owners[static_cast<std::size_t>(k)];
                    INFO(file << " column " << k);
                    CHECK(linked.both_ways(Pointable::body(body), Pointable::column(k)));
                }
            }
            for (const int theta : system.active_thetas()) {
                CHECK(owners[static_cast<std::size_t>(system.theta_column(theta, angular))] == 0);
            }
        }
    }
}

TEST_CASE("what is drawn in 3D is known by its number, and nothing else has that number", "[app][session]") {
    std::vector<Pointable> all;
    for (int k = 0; k < 40; ++k) {
        all.push_back(Pointable::body(k));
        all.push_back(Pointable::joint(k));
        for (const int part : kParts) { all.push_back(Pointable::vector(k, part)); }
    }
    std::vector<int> ids;
    for (const Pointable& link : all) {
        CHECK(pointable_of(picture_id(link)) == link);
        ids.push_back(picture_id(link));
    }
    std::ranges::sort(ids);
    CHECK(std::ranges::adjacent_find(ids) == ids.end());
    CHECK(ids.front() > 0);
    for (const int nothing : {0, -1, -9, 7, 6}) { CHECK_FALSE(static_cast<bool>(pointable_of(nothing))); }
}

}  // namespace jw::test
