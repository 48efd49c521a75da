#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "app/panels/column/direction_sphere.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/wording/labels.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw::panels {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kRingsOfSphere = 30;  // triangles of about 4 px on a sphere of 120 px radius
constexpr int kSpokes = 96;         // sides of the same length along the rim
constexpr int kLineParts = 120;

constexpr std::array kContours{0.2, 0.4, 0.577, 0.8};

int index_of(PairInUse pair) { return static_cast<int>(pair) - 1; }  // of the dropped component

/// Cosines and sines of a whole turn, first and last the same; kept because every frame needs them.
const std::vector<std::array<double, 2>>& turn() {
    static const std::vector<std::array<double, 2>> parts = [] {
        std::vector<std::array<double, 2>> all;
        for (int n = 0; n <= kLineParts; ++n) {
            const double angle = 2.0 * kPi * n / kLineParts;
            all.push_back({std::cos(angle), std::sin(angle)});
        }
        return all;
    }();
    return parts;
}

/// All directions whose component k is `value`.
std::vector<Vec3> circle(int k, double value) {
    const double radius = std::sqrt(1.0 - value * value);
    std::vector<Vec3> points;
    for (const auto& [cosine, sine] : turn()) {
        Vec3 d;
        d(k) = value;
        d((k + 1) % 3) = radius * cosine;
        d((k + 2) % 3) = radius * sine;
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

/// Makes a colour a little darker towards the rim, so that the sphere looks round.
Colour shaded(Colour colour, double facing) {
    const auto light = static_cast<float>(0.80 + 0.20 * facing);
    return {light * colour.r, light * colour.g, light * colour.b, colour.a};
}

/// The visible side of the sphere: x to the right, y up, z to the eye.
struct HalfSphere {
    std::vector<Vec3> directions;
    std::vector<unsigned short> triangles;  ///< three directions each
};

HalfSphere half_sphere() {
    HalfSphere half;
    half.directions.push_back(Vec3::UnitZ());
    for (int ring = 1; ring <= kRingsOfSphere; ++ring) {
        const double tilt = 0.5 * kPi * ring / kRingsOfSphere;
        for (int spoke = 0; spoke < kSpokes; ++spoke) {
            const double angle = 2.0 * kPi * spoke / kSpokes;
            half.directions.emplace_back(
                std::sin(tilt) * std::cos(angle), std::sin(tilt) * std::sin(angle), std::cos(tilt));
        }
    }
    const auto corner = [](int ring, int spoke) {
        return static_cast<unsigned short>(ring == 0 ? 0 : 1 + (ring - 1) * kSpokes + spoke % kSpokes);
    };
    for (int ring = 1; ring <= kRingsOfSphere; ++ring) {
        for (int spoke = 0; spoke < kSpokes; ++spoke) {
            const auto inner = corner(ring - 1, spoke);
            const auto outer = corner(ring, spoke);
            const auto next = corner(ring, spoke + 1);
            half.triangles.insert(half.triangles.end(), {inner, outer, next});
            if (ring == 1) { continue; }
            half.triangles.insert(half.triangles.end(), {inner, next, corner(ring - 1, spoke + 1)});
        }
    }
    return half;
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
    static const Colour bad = render::mix(theme::kRedundant, theme::kPaper, 0.25F);
    static const Colour good = render::mix(theme::kAccent, theme::kPaper, 0.40F);
    static const Colour plain = render::from_hex(0xF4F0E6);
    if (quality < middle) { return render::mix(bad, plain, static_cast<float>(quality / middle)); }
    return render::mix(plain, good, static_cast<float>((quality - middle) / (1.0 - middle)));
}

void draw_shading(const Canvas& canvas, const SphereView& view, PairInUse pair) {
    if (!canvas.draws()) { return; }
    static const HalfSphere half = half_sphere();
    std::vector<Point> corners;
    std::vector<Colour> colours;
    corners.reserve(half.directions.size());
    colours.reserve(half.directions.size());
    for (const Vec3& seen : half.directions) {
        const Vec3 d = seen.x() * view.right + seen.y() * view.up + seen.z() * view.towards;
        corners.push_back(view.pixel(d));
        colours.push_back(shaded(colour_of_quality(pair_quality(pair, d)), seen.z()));
    }
    canvas.gradient_mesh(corners, colours, half.triangles);
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
