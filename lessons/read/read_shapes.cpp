#include <algorithm>
#include <array>
#include <cmath>

#include "lessons/fields/member_keys.hpp"
#include "lessons/format/scene_keys.hpp"
#include "lessons/read/reading.hpp"

namespace jw::reading {

namespace {

constexpr std::size_t kMostShapes = 100;
// shorter rods and thinner boxes cannot be seen and have no direction
constexpr double kSmallestSize = 1e-9;
// largest cosine between perpendicular axes that are typed with three digits
constexpr double kOrthonormal = 1e-3;

const std::vector<std::string> kShapeKinds{"box", "cylinder", "sphere", "rod"};

std::optional<Shape> read_box(Fields& fields) {
    Box box;
    read_members(fields, format::kSizeOfBox, box);
    if (const auto axes = read_frame(fields)) { box.axes = *axes; }
    fields.finish();
    if (box.size.minCoeff() < kSmallestSize) {
        fields.report(
            Code::out_of_range, fields.span("size"),
            "'size' has an edge of " + short_number(box.size.minCoeff()) +
                "; expected three lengths above 0");
    }
    return box;
}

std::optional<Shape> read_sphere(Fields& fields) {
    Sphere sphere;
    read_members(fields, format::kSphere, sphere);
    fields.finish();
    return sphere;
}

template <class Bar>
std::optional<Shape> read_bar(Fields& fields) {
    Bar bar;
    const bool is_sound = read_members(fields, format::kBar<Bar>, bar);
    fields.finish();
    if (is_sound && (bar.from - bar.to).norm() < kSmallestSize) {
        fields.report(
            Code::points_coincide, fields.span("to"), "'to' equals 'from'; expected two different points");
    }
    return bar;
}

std::optional<Shape> read_shape(Fields& fields) {
    if (!fields.at_most_one(kShapeKinds)) { return std::nullopt; }
    std::optional<Shape> shape;
    if (auto box = fields.table("box")) { shape = read_box(*box); }
    if (auto sphere = fields.table("sphere")) { shape = read_sphere(*sphere); }
    if (auto cylinder = fields.table("cylinder")) { shape = read_bar<Cylinder>(*cylinder); }
    if (auto rod = fields.table("rod")) { shape = read_bar<Rod>(*rod); }
    const int errors = fields.problems().errors_count();
    fields.finish();
    const auto is_there = [&](const std::string& kind) { return fields.has(kind); };
    // an unknown key has been reported: it is probably the kind of shape, misspelt
    if (std::ranges::none_of(kShapeKinds, is_there) && fields.problems().errors_count() == errors) {
        fields.report(
            Code::missing_key, fields.span(),
            "the shape names no form; expected one of " + comma_list(kShapeKinds));
    }
    return shape;
}

/// Exactly orthonormal axes: x is kept, y is turned in their plane, z is perpendicular to both. Axes that are
/// already orthonormal stay unchanged.
Mat3 made_exact(const Mat3& axes) {
    if (is_frame(axes)) { return axes; }
    Mat3 A;
    A.col(0) = axes.col(0).normalized();
    A.col(2) = A.col(0).cross(axes.col(1)).normalized();
    A.col(1) = A.col(2).cross(A.col(0));
    return A;
}

}  // namespace

std::vector<Shape> read_shapes(Fields& fields) {
    std::vector<Shape> shapes;
    for (Fields& shape_fields : fields.tables("shape", kMostShapes)) {
        if (const auto shape = read_shape(shape_fields)) { shapes.push_back(*shape); }
    }
    return shapes;
}

std::optional<Mat3> read_frame(Fields& fields) {
    auto axes = fields.table("axes");
    if (!axes) { return std::nullopt; }
    const int errors = fields.problems().errors_count();
    std::array<IfGiven<Vec3>, 3> given{axes->direction("x"), axes->direction("y"), axes->direction("z")};
    axes->finish();
    if (fields.problems().errors_count() > errors) { return std::nullopt; }

    Mat3 A;
    for (std::size_t k = 0; k < 3; ++k) {
        if (given[k]) { A.col(static_cast<int>(k)) = unit_of(given[k]->value); }
    }
    const auto count = std::ranges::count_if(given, [](const auto& axis) { return axis.has_value(); });
    if (count < 2) {
        fields.report(
            Code::missing_key, axes->span(),
            "'axes' has fewer than two axes; expected two or three of x, y, z");
        return std::nullopt;
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const int next = (static_cast<int>(k) + 1) % 3;
        const int last = (static_cast<int>(k) + 2) % 3;
        if (!given[k]) { A.col(static_cast<int>(k)) = A.col(next).cross(A.col(last)); }
    }
    // an omitted axis has the length of the cross product; the cosines below check the other two
    const double xy = A.col(0).dot(A.col(1));
    const double yz = A.col(1).dot(A.col(2));
    const double zx = A.col(2).dot(A.col(0));
    if (std::max({std::abs(xy), std::abs(yz), std::abs(zx)}) > kOrthonormal) {
        fields.report(
            Code::not_perpendicular, axes->span(),
            "the axes are not perpendicular: x·y = " + short_number(xy, 4) +
                ", y·z = " + short_number(yz, 4) + ", z·x = " + short_number(zx, 4) +
                " for unit axes; expected at most 0.001");
        return std::nullopt;
    }
    if (A.determinant() < 0.0) {
        fields.report(Code::left_handed, axes->span(), "the axes are left-handed; expected x × y = z");
        return std::nullopt;
    }
    return made_exact(A);
}

std::optional<Colour> read_colour(Fields& fields) {
    const auto text = fields.text("colour");
    if (!text) { return std::nullopt; }
    const auto colour_of = [](unsigned rgb) {
        return Colour{((rgb >> 16U) & 255U) / 255.0, ((rgb >> 8U) & 255U) / 255.0, (rgb & 255U) / 255.0};
    };
    const auto found = std::ranges::find(kNamedColours, text->value, &NamedColour::name);
    if (found != kNamedColours.end()) { return colour_of(found->rgb); }
    const std::string& t = text->value;
    if (t.size() == 7 && t[0] == '#' &&
        t.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos) {
        return colour_of(static_cast<unsigned>(std::stoul(t.substr(1), nullptr, 16)));
    }
    const std::vector<std::string> names = words_in<kNamedColours>();
    fields.report(
        Code::unknown_word, text->span,
        "unknown colour " + in_quotes(t) + "; expected \"#rrggbb\" or one of " + comma_list(names),
        did_you_mean(t, names));
    return std::nullopt;
}

}  // namespace jw::reading
