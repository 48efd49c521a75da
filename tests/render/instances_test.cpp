#include <catch2/catch.hpp>

#include "render/passes/instances.hpp"

namespace jw::render::test {
namespace {

constexpr double kDash = 0.1;

std::size_t count(const InstanceLists& lists) {
    std::size_t sum = 0;
    for (const auto& list : lists) { sum += list.size(); }
    return sum;
}

const std::vector<Instance>& of(const InstanceLists& lists, MeshKind kind) {
    return lists[mesh_number(kind, Detail::high)];
}

}  // namespace

TEST_CASE("shapes without length draw nothing instead of something infinite", "[render][instances]") {
    Scene scene;
    const Vector3d here(1.0, 2.0, 3.0);
    scene.arrows.push_back({here, here});
    scene.shapes.push_back({Cylinder{here, here, 0.1}});
    scene.shapes.push_back({Tube{here, here, 0.2, 0.1}});
    scene.shapes.push_back({Nut{here, here, Vector3d::UnitX(), 0.2, 0.1}});
    scene.shapes.push_back({Screw{here, here, Vector3d::UnitX(), 0.1, 0.02}});
    scene.polylines.push_back({{here, here}, 2.0, palette::kInk, true});
    scene.polylines.push_back({});
    const DrawLists lists = draw_lists_of(scene, kDash);
    CHECK(
        count(lists.bodies) + count(lists.annotations) + count(lists.see_through) + count(lists.ghosts) == 0);
    CHECK(lists.see_through_lines.empty());
}

TEST_CASE("transparency, see-through and the rest go to lists of their own", "[render][instances]") {
    Scene scene;
    scene.shapes.push_back({Sphere{}, palette::kBlue});
    scene.shapes.push_back({Sphere{}, with_alpha(palette::kBlue, 0.3F)});
    scene.shapes.push_back({Sphere{}, palette::kPoint, false, true});
    scene.arrows.push_back({Vector3d::Zero(), Vector3d::UnitX(), 0.01, palette::kVectorI, false, false});
    const DrawLists lists = draw_lists_of(scene, kDash);
    CHECK(count(lists.bodies) == 1);
    CHECK(count(lists.ghosts) == 1);
    CHECK(count(lists.see_through) == 1);
    CHECK(count(lists.annotations) == 2);  // shaft and head
}

TEST_CASE("an arrow ends at its tip", "[render][instances]") {
    Scene scene;
    const Vector3d tip = GENERATE(Vector3d(0.3, -0.4, 1.2), Vector3d(0.001, 0.0, 0.0));
    scene.arrows.push_back({Vector3d::Zero(), tip, 0.01});
    const DrawLists lists = draw_lists_of(scene, kDash);
    const auto& heads = of(lists.see_through, MeshKind::cone);
    REQUIRE(heads.size() == 1);
    // the cone's core, scaled, and its rounding reach exactly to the tip
    const double reach = static_cast<double>(kConeLength * heads[0].size.z() + heads[0].rounding);
    const Eigen::Vector3d base = heads[0].pose.col(3).cast<double>();
    const Eigen::Vector3d axis = heads[0].pose.col(2).cast<double>();
    // a rounded tip falls short of the sharp one by a few hundredths of the head
    CHECK((base + reach * axis - tip).norm() < 0.06 * reach);
}

TEST_CASE("dashes cover the share of a path that they should, ends included", "[render][instances]") {
    Scene scene;
    Polyline line;
    for (int n = 0; n <= 300; ++n) { line.points.emplace_back(0.01 * n, 0.0, 0.0); }
    line.dashed = true;
    scene.polylines.push_back(line);
    const auto pieces = draw_lists_of(scene, kDash).see_through_lines;
    double drawn = 0.0;
    for (const LineSegment& piece : pieces) { drawn += static_cast<double>((piece.to - piece.from).norm()); }
    CHECK(drawn == Approx(3.0 / 1.7).epsilon(1e-4));  // single precision of 300 pieces
    CHECK(pieces.front().from.x() == Approx(0.0F).margin(1e-6));
    CHECK(pieces.back().to.x() == Approx(3.0F).margin(1e-6));
}

TEST_CASE("a thread has as many turns as fit, whichever way it winds", "[render][instances]") {
    Scene scene;
    const double pitch = GENERATE(0.05, -0.05);
    scene.shapes.push_back(
        {Screw{Vector3d::Zero(), Vector3d(0.0, 0.0, 0.52), Vector3d::UnitX(), 0.1, pitch}});
    const DrawLists lists = draw_lists_of(scene, kDash);
    CHECK(of(lists.bodies, pitch > 0.0 ? MeshKind::right_thread : MeshKind::left_thread).size() == 9);
    CHECK(of(lists.bodies, MeshKind::round_bar).size() == 1);
}

TEST_CASE("a thread finer than anything visible stays bounded", "[render][instances]") {
    Scene scene;
    scene.shapes.push_back({Screw{Vector3d::Zero(), Vector3d::UnitZ(), Vector3d::UnitX(), 0.1, 1e-9}});
    scene.shapes.push_back({Screw{Vector3d::Zero(), Vector3d::UnitZ(), Vector3d::UnitX(), 0.1, 0.0}});
    CHECK(count(draw_lists_of(scene, kDash).bodies) < 1000);
}

}  // namespace jw::render::test
