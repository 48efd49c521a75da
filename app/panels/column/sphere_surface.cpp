#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "app/panels/column/sphere_parts.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw::panels {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kRingsOfSphere = 30;  // triangles of about 4 px on a sphere of 120 px radius
constexpr int kSpokes = 96;         // as long along the rim
constexpr int kLineParts = 120;

constexpr std::array kContours{0.2, 0.4, 0.577, 0.8};

int index_of(PairInUse pair) { return static_cast<int>(pair) - 1; }  // of the dropped component

/// All directions whose component k is `value`.
std::vector<Vec3> circle(int k, double value) {
    const double radius = std::sqrt(1.0 - value * value);
    std::vector<Vec3> points;
    for (int n = 0; n <= kLineParts; ++n) {
        const double angle = 2.0 * kPi * n / kLineParts;
        Vec3 d;
        d(k) = value;
        d((k + 1) % 3) = radius * std::cos(angle);
        d((k + 2) % 3) = radius * std::sin(angle);
        points.push_back(d);
    }
    return points;
}

/// Line on which |s_a| = |s_b| is the largest component, with signs: from corner to corner of the cube (±1,
/// ±1, ±1).
std::vector<Vec3> border(int c, double sign_a, double sign_b) {
    const double end = std::atan(1.0 / std::numbers::sqrt2);
    std::vector<Vec3> points;
    for (int n = 0; n <= kLineParts / 4; ++n) {
        const double angle = end * (8.0 * n / kLineParts - 1.0);
        Vec3 d;
        d(c) = std::sin(angle);
        d((c + 1) % 3) = sign_a * std::cos(angle) / std::numbers::sqrt2;
        d((c + 2) % 3) = sign_b * std::cos(angle) / std::numbers::sqrt2;
        points.push_back(d);
    }
    return points;
}

std::vector<SphereLine> lines_of_rule() {
    std::vector<SphereLine> lines;
    for (int k = 0; k < 3; ++k) {
        for (const double sign : {-1.0, 1.0}) {
            lines.push_back({circle(k, 0.8 * sign), "0.8", SphereLine::Kind::contour});
            lines.push_back({border(k, sign, 1.0), "", SphereLine::Kind::border});
            lines.push_back({border(k, sign, -1.0), "", SphereLine::Kind::border});
        }
    }
    return lines;
}

/// Towards the viewer bright, towards the rim a little darker: it is seen to be round.
Colour shaded(Colour colour, double facing) {
    const auto light = static_cast<float>(0.80 + 0.20 * facing);
    return {light * colour.r, light * colour.g, light * colour.b, colour.a};
}

}  // namespace

double pair_quality(PairInUse pair, const Vec3& s_i) {
    return pair == PairInUse::rule ? s_i.cwiseAbs().maxCoeff() : std::abs(s_i(index_of(pair)));
}

std::vector<SphereLine> lines_of(PairInUse pair) {
    if (pair == PairInUse::rule) { return lines_of_rule(); }
    std::vector<SphereLine> lines;
    const int k = index_of(pair);
    lines.push_back({circle(k, 0.0), tr("rank lost"), SphereLine::Kind::lost});
    for (const double value : kContours) {
        for (const double sign : {1.0, -1.0}) {
            lines.push_back({circle(k, sign * value), number_text(value, 3), SphereLine::Kind::contour});
        }
    }
    return lines;
}

Colour colour_of_quality(double quality) {
    const double middle = 1.0 / std::numbers::sqrt3;
    const Colour bad = render::mix(theme::kRedundant, theme::kPaper, 0.25F);
    const Colour good = render::mix(theme::kAccent, theme::kPaper, 0.40F);
    const Colour plain = render::from_hex(0xF4F0E6);
    if (quality < middle) { return render::mix(bad, plain, static_cast<float>(quality / middle)); }
    return render::mix(plain, good, static_cast<float>((quality - middle) / (1.0 - middle)));
}

void draw_shading(const Canvas& canvas, const SphereView& view, PairInUse pair) {
    if (!canvas.draws()) { return; }
    struct Corner {
        Point at;
        Colour colour;
    };
    const auto corner = [&](int ring, int spoke) {
        const double tilt = 0.5 * kPi * ring / kRingsOfSphere;
        const double angle = 2.0 * kPi * spoke / kSpokes;
        const Vec3 d = std::sin(tilt) * (std::cos(angle) * view.right + std::sin(angle) * view.up) +
                       std::cos(tilt) * view.towards;
        return Corner{view.pixel(d), shaded(colour_of_quality(pair_quality(pair, d)), std::cos(tilt))};
    };
    const auto fill = [&](const Corner& a, const Corner& b, const Corner& c) {
        canvas.gradient_triangle({a.at, b.at, c.at}, {a.colour, b.colour, c.colour});
    };
    std::array<Corner, kSpokes + 1> inner;
    std::array<Corner, kSpokes + 1> outer;
    inner.fill(corner(0, 0));
    for (int ring = 1; ring <= kRingsOfSphere; ++ring) {
        for (int spoke = 0; spoke <= kSpokes; ++spoke) {
            outer[static_cast<std::size_t>(spoke)] = corner(ring, spoke);
        }
        for (std::size_t k = 0; k < kSpokes; ++k) {
            fill(inner[k], outer[k], outer[k + 1]);
            if (ring > 1) { fill(inner[k], outer[k + 1], inner[k + 1]); }
        }
        inner = outer;
    }
}

std::vector<std::vector<Point>> front_of(const SphereView& view, const std::vector<Vec3>& points) {
    std::vector<std::vector<Point>> runs(1);
    for (const Vec3& d : points) {
        if (view.faces(d)) {
            runs.back().push_back(view.pixel(d));
        } else if (!runs.back().empty()) {
            runs.emplace_back();
        }
    }
    if (runs.back().empty()) { runs.pop_back(); }
    return runs;
}

}  // namespace jw::panels
