#include <algorithm>

#include "app/session/picture/picture_parts.hpp"

namespace jw::picture {

namespace {

constexpr render::Colour kForce = render::from_hex(0x8E4585);
constexpr std::size_t kMoments = 40;   // enough to find the typical size
constexpr double kUsual = 0.25;        // of the unit: nine tenths of the story stay below
constexpr double kLongest = 0.60;      // of the unit: longer arrows are cut to this
constexpr double kNothing = 0.015;     // of the unit: shorter arrows would be only a dot
constexpr double kSecondHead = 0.045;  // of the unit: a torque has two heads
constexpr float kOneOfMany = 0.35F;

/// The part of a wrench's vector that is the same in every solution.
Vec3 unique_part(const Vec3& vector, const Mat3& axes, const std::array<bool, 3>& unique) {
    Vec3 part = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        if (unique[at(k)]) { part += axes.col(k) * axes.col(k).dot(vector); }
    }
    return part;
}

/// The value below which nine tenths of the values lie: near singular positions, reactions grow without
/// bound.
double usual(std::vector<double> values) {
    if (values.empty()) { return 0.0; }
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(9 * (values.size() - 1) / 10);
    std::ranges::nth_element(values, place);
    return *place;
}

void add_arrow(
    const PictureStyle& style, const Vec3& foot, const Vec3& whole, bool two_heads, float alpha,
    Picture& picture) {
    if (whole.norm() < kNothing * style.unit) { return; }
    const Vec3 way = std::min(1.0, kLongest * style.unit / whole.norm()) * whole;
    const render::Colour colour = render::with_alpha(kForce, alpha);
    const double radius = 1.2 * vector_radius(style.unit);
    picture.scene.arrows.push_back({foot, foot + way, radius, colour});
    const double length = way.norm() - kSecondHead * style.unit;
    if (two_heads && length > 0.5 * kSecondHead * style.unit) {
        picture.scene.arrows.push_back({foot, foot + length * way.normalized(), radius, colour});
    }
}

/// Adds a force or torque: its unique components in full colour and, where redundant equations leave
/// components undetermined, the smallest solution in a pale colour.
void add_effect(
    const PictureStyle& style, const Reaction& reaction, const Vec3& vector,
    const std::array<bool, 3>& unique, double scale, bool two_heads, Picture& picture) {
    const Vec3 certain = unique_part(vector, reaction.axes, unique);
    if (std::ranges::find(unique, false) != unique.end()) {
        add_arrow(style, reaction.point, scale * vector, two_heads, kOneOfMany, picture);
    }
    add_arrow(style, reaction.point, scale * certain, two_heads, 1.0F, picture);
}

}  // namespace

void set_reaction_scales(const Story& story, PictureStyle& style) {
    std::vector<double> forces;
    std::vector<double> torques;
    const std::size_t stride = 1 + story.steps().size() / kMoments;
    for (std::size_t k = 0; k < story.steps().size(); k += stride) {
        const auto reactions = reactions_of(story.steps()[k]);
        if (!reactions || reactions->reactions.empty()) { continue; }
        double force = 0.0;
        double torque = 0.0;
        for (const Reaction& reaction : reactions->reactions) {
            force = std::max(force, reaction.wrench.force.norm());
            torque = std::max(torque, reaction.wrench.torque.norm());
        }
        forces.push_back(force);
        torques.push_back(torque);
    }
    const double force = usual(forces);
    style.newton = force > 0.0 ? kUsual * style.unit / force : 0.0;
    // torques that are only rounding of the moments of forces must not look large
    const double torque = std::max(usual(torques), 1e-3 * force * style.unit);
    style.newton_metre = torque > 0.0 ? kUsual * style.unit / torque : 0.0;
}

void add_reactions(const PictureStyle& style, const Reactions& reactions, Picture& picture) {
    for (const Reaction& reaction : reactions.reactions) {
        add_effect(
            style, reaction, reaction.wrench.force, reaction.force_unique, style.newton, false, picture);
        add_effect(
            style, reaction, reaction.wrench.torque, reaction.torque_unique, style.newton_metre, true,
            picture);
    }
}

}  // namespace jw::picture
