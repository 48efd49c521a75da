#include <catch2/catch.hpp>

#include <algorithm>
#include <numeric>
#include <set>

#include "core/poses/typed/closed_parts.hpp"
#include "tests/support/random_mechanisms.hpp"

/// Parts of a mechanism that are connected to each other by single bodies only.
using namespace jw;

namespace {

/// Any joints between any bodies, of which the first two are fixed.
Mechanism random_graph(test::Random& random, int bodies, int joints) {
    Mechanism mechanism;
    for (int b = 0; b < bodies; ++b) { mechanism.bodies.emplace_back().fixed = b < 2; }
    const auto any = [&] { return std::min(static_cast<int>(random.number(0.0, bodies)), bodies - 1); };
    while (static_cast<int>(mechanism.joints.size()) < joints) {
        Joint joint;
        joint.body_i = any();
        joint.body_j = any();
        if (std::max(joint.body_i, joint.body_j) < 2 || joint.body_i == joint.body_j) { continue; }
        mechanism.joints.push_back(joint);
    }
    return mechanism;
}

std::vector<int> all_of(const Mechanism& mechanism) {
    std::vector<int> joints(mechanism.joints.size());
    std::iota(joints.begin(), joints.end(), 0);
    return joints;
}

/// Number of bodies that joints connect (all fixed ones count as one), and of connected pieces.
struct Pieces {
    int bodies = 0;
    int pieces = 0;
};
/// @param without a body that is taken out
Pieces pieces_of(const Mechanism& mechanism, const std::vector<int>& joints, int without = -1) {
    const auto node = [&](int body) { return mechanism.bodies[at(body)].fixed ? 0 : body; };
    std::vector<int> piece(mechanism.bodies.size());
    std::iota(piece.begin(), piece.end(), 0);
    std::set<int> bodies;
    for (const int j : joints) {
        const int i = node(mechanism.joints[at(j)].body_i);
        const int k = node(mechanism.joints[at(j)].body_j);
        for (const int body : {i, k}) {
            if (body != without) { bodies.insert(body); }
        }
        if (i == without || k == without) { continue; }
        const int old = piece[at(i)];
        std::ranges::replace(piece, old, piece[at(k)]);
    }
    std::set<int> names;
    for (const int body : bodies) { names.insert(piece[at(body)]); }
    return {static_cast<int>(bodies.size()), static_cast<int>(names.size())};
}

}  // namespace

TEST_CASE("A closed part stays in one piece without any of its bodies", "[core][closed_parts]") {
    for (unsigned seed = 0; seed < 200; ++seed) {
        CAPTURE(seed);
        test::Random random(seed);
        const Mechanism mechanism = random_graph(random, 9, 6 + static_cast<int>(seed % 8));
        std::set<int> in_parts;
        int links = 0;
        for (const ClosedPart& part : closed_parts(mechanism, all_of(mechanism))) {
            REQUIRE(part.joints.size() >= 2);
            CHECK(std::ranges::is_sorted(part.joints));
            for (const int j : part.joints) { CHECK(in_parts.insert(j).second); }
            for (int body = 0; body < 9; ++body) {
                CHECK(pieces_of(mechanism, part.joints, body).pieces <= 1);
            }
            links += pieces_of(mechanism, part.joints).bodies - 1;
            // the base is a body of the part, and nothing else of the mechanism moves
            const Mechanism lone = alone(mechanism, part);
            CHECK(lone.moving_bodies_count() == pieces_of(mechanism, part.joints).bodies - 1);
        }
        // a tree of parts and single joints: no loop goes through several of them
        const Pieces whole = pieces_of(mechanism, all_of(mechanism));
        const int single = static_cast<int>(mechanism.joints.size() - in_parts.size());
        CHECK(links + single == whole.bodies - whole.pieces);
    }
}
