#include "render/shadow_view.hpp"

#include <cmath>

#include <Eigen/Geometry>

namespace jw::render {
namespace {

constexpr double kMargin = 1.15;  // room for the soft border
constexpr double kStep = 1.25;    // widths are powers of this

/// Multiple of `step` next to `value`.
double snapped(double value, double step) { return std::round(value / step) * step; }

}  // namespace

ShadowView shadow_view(const Bounds& casters, const Eigen::Vector3d& towards_light, int texels) {
    const double diagonal = std::max(casters.diagonal(), 1e-3);
    const double width = std::pow(kStep, std::ceil(std::log(kMargin * diagonal) / std::log(kStep)));
    const double texel = width / texels;

    Eigen::Matrix3d light;
    light.row(2) = towards_light;
    light.row(0) = towards_light.unitOrthogonal();
    light.row(1) = towards_light.cross(light.row(0).transpose());
    const Eigen::Vector3d centre = light * (casters.empty() ? Eigen::Vector3d::Zero() : casters.centre());

    ShadowView view;
    view.width = width;
    view.clip_from_world.setIdentity();
    view.clip_from_world.block<3, 3>(0, 0) = light * (2.0 / width);
    view.clip_from_world.block<1, 3>(2, 0) *= -0.5;  // the ground may lie far below: twice the depth
    view.clip_from_world(0, 3) = -snapped(centre.x(), texel) * 2.0 / width;
    view.clip_from_world(1, 3) = -snapped(centre.y(), texel) * 2.0 / width;
    view.clip_from_world(2, 3) = snapped(centre.z(), texel) / width;

    Eigen::Matrix4d map_from_clip = 0.5 * Eigen::Matrix4d::Identity();
    map_from_clip.block<3, 1>(0, 3).setConstant(0.5);
    map_from_clip(3, 3) = 1.0;
    view.map_from_world = map_from_clip * view.clip_from_world;
    return view;
}

}  // namespace jw::render
