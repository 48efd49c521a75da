#include <cmath>
#include <cstdio>

#include "core/euler_parameters.hpp"
#include "lessons/reading.hpp"

namespace jw::reading {

namespace {

// p as typed with four digits is off unit length by 1e-4; more is a mistake
constexpr double kUnitP = 1e-3;
// axes as typed with six digits
constexpr double kOrthonormal = 1e-5;

std::string format(const char* pattern, double a, double b = 0.0, double c = 0.0, double d = 0.0) {
    char text[256];
    std::snprintf(text, sizeof text, pattern, a, b, c, d);
    return text;
}

void read_p(Fields& fields, Body& body) {
    const auto list = fields.numbers("p", 4);
    if (!list) { return; }
    const Vec4 p(list->value[0], list->value[1], list->value[2], list->value[3]);
    const double length = p.norm();
    if (std::abs(length - 1.0) <= kUnitP) {
        body.p = p;
        return;
    }
    const std::string hint = length > 0.0 ? format(
                                                "of unit length: p = [%.9g, %.9g, %.9g, %.9g]", p(0) / length,
                                                p(1) / length, p(2) / length, p(3) / length)
                                          : std::string("no rotation: p = [1, 0, 0, 0]");
    fields.problems().add(
        list->span,
        format("Euler parameters have length %.6g; expected (e0, e1, e2, e3) of length 1", length), hint);
}

void read_rotation(Fields& fields, Body& body) {
    auto rotation = fields.table("rotation");
    if (!rotation) { return; }
    const auto axis = rotation->direction("axis");
    const auto angle = rotation->angle("angle");
    if (!rotation->has("axis")) { rotation->missing("axis", "the axis of rotation, three numbers"); }
    if (!rotation->has("angle_deg") && !rotation->has("angle_rad")) {
        rotation->missing("angle_deg", "the angle of rotation");
    }
    rotation->finish();
    if (axis && angle) { body.p = euler_parameters_of(axis->value, angle->value); }
}

void read_axes(Fields& fields, Body& body) {
    auto axes = fields.table("axes");
    if (!axes) { return; }
    auto x = axes->direction("x");
    auto y = axes->direction("y");
    auto z = axes->direction("z");
    axes->finish();
    const int given = (x ? 1 : 0) + (y ? 1 : 0) + (z ? 1 : 0);
    if (given < 2) {
        fields.problems().add(
            axes->span(), "'axes' has fewer than two directions; expected two or three of x, y, z");
        return;
    }
    Mat3 A;
    A.col(0) = x ? x->value.normalized() : y->value.cross(z->value).normalized();
    A.col(1) = y ? y->value.normalized() : z->value.cross(A.col(0)).normalized();
    A.col(2) = z ? z->value.normalized() : A.col(0).cross(A.col(1)).normalized();
    const double error = (A.transpose() * A - Mat3::Identity()).cwiseAbs().maxCoeff();
    if (error > kOrthonormal || A.determinant() < 0.0) {
        fields.problems().add(
            axes->span(),
            error > kOrthonormal
                ? format("axes are not perpendicular (cosine %.3g); expected a right-handed frame", error)
                : std::string("axes are left-handed; expected x, y, z right-handed"));
        return;
    }
    body.p = euler_parameters_of(A);
}

void read_motion(Fields& fields, Body& body) {
    if (const auto v = fields.vector("velocity")) { body.r_dot = v->value; }
    if (!fields.at_most_one({"omega_local_rad_per_s", "omega_global_rad_per_s"})) { return; }
    if (const auto w = fields.vector("omega_local_rad_per_s")) { body.omega_local = w->value; }
    if (const auto w = fields.vector("omega_global_rad_per_s")) {
        body.omega_local = rotation_of(body).transpose() * w->value;
    }
}

std::optional<Shape> read_shape(Fields& fields) {
    const std::vector<std::string> kinds{"box", "cylinder", "sphere", "rod"};
    if (!fields.at_most_one(kinds)) { return std::nullopt; }
    std::optional<Shape> shape;
    if (auto box = fields.table("box")) {
        const auto size = box->vector("size");
        const auto at = box->vector("at");
        if (!box->has("size")) { box->missing("size", "three edge lengths in m"); }
        if (size && size->value.minCoeff() <= 0.0) {
            fields.problems().add(size->span, "'size' is not positive; expected three edge lengths above 0");
        } else if (size) {
            shape = Box{size->value, at ? at->value : Vec3::Zero(), Mat3::Identity()};
        }
        box->finish();
    } else if (auto sphere = fields.table("sphere")) {
        const auto radius = sphere->positive("radius");
        const auto at = sphere->vector("at");
        if (!sphere->has("radius")) { sphere->missing("radius", "a radius in m"); }
        if (radius) { shape = Sphere{at ? at->value : Vec3::Zero(), radius->value}; }
        sphere->finish();
    } else {
        const bool is_rod = fields.has("rod");
        auto bar = fields.table(is_rod ? "rod" : "cylinder");
        if (!bar) {
            fields.problems().add(
                fields.span(), "shape is empty; expected one of box, cylinder, sphere, rod");
            return std::nullopt;
        }
        const auto from = bar->vector("from");
        const auto to = bar->vector("to");
        const auto radius = bar->positive("radius");
        for (const char* key : {"from", "to"}) {
            if (!bar->has(key)) { bar->missing(key, "a point of the body, three numbers in m"); }
        }
        if (!bar->has("radius")) { bar->missing("radius", "a radius in m"); }
        bar->finish();
        if (!from || !to || !radius) { return std::nullopt; }
        if ((from->value - to->value).norm() < 1e-12) {
            fields.problems().add(to->span, "'to' equals 'from'; expected two different points");
            return std::nullopt;
        }
        if (is_rod) {
            shape = Rod{from->value, to->value, radius->value};
        } else {
            shape = Cylinder{from->value, to->value, radius->value};
        }
    }
    fields.finish();
    return shape;
}

void read_body(Fields& fields, Reading& reading) {
    Body body;
    Look look;
    const auto name = fields.text("name");
    if (!fields.has("name")) { fields.missing("name", "a name that joints refer to"); }
    if (name) { body.name = name->value; }
    if (name && name->value.empty()) {
        reading.problems->add(name->span, "the name is empty; expected a name that joints refer to");
    }
    if (const auto fixed = fields.flag("fixed")) { body.fixed = fixed->value; }
    if (const auto position = fields.vector("position")) { body.r = position->value; }
    if (fields.at_most_one({"p", "rotation", "axes"})) {
        read_p(fields, body);
        read_rotation(fields, body);
        read_axes(fields, body);
    }
    read_motion(fields, body);
    look.colour = read_colour(fields);
    for (Fields& shape_fields : fields.tables("shape")) {
        if (const auto shape = read_shape(shape_fields)) { look.shapes.push_back(*shape); }
    }
    fields.finish();

    Mechanism& mechanism = reading.lesson.mechanism;
    if (body.name == "ground") {
        body.fixed = true;
        mechanism.bodies[0] = body;
        reading.lesson.looks[0] = look;
        return;
    }
    for (const Body& other : mechanism.bodies) {
        if (name && other.name == body.name) {
            reading.problems->add(
                name->span,
                "body '" + body.name + "' is there twice; expected a name of its own for each body");
        }
    }
    mechanism.bodies.push_back(body);
    reading.lesson.looks.push_back(look);
}

}  // namespace

Mat3 rotation_of(const Body& body) { return rotation_matrix(body.p.normalized()); }

std::optional<Colour> read_colour(Fields& fields) {
    const auto text = fields.text("colour");
    if (!text) { return std::nullopt; }
    const std::vector<std::string> names{"blue",   "orange",    "green",  "sky",
                                         "yellow", "vermilion", "purple", "steel"};
    constexpr std::uint32_t values[] = {0x2F78B7, 0xE08E1A, 0x1F9A76, 0x5FB3E0,
                                        0xE3C93C, 0xCF5A1C, 0xB9709E, 0x8A94A0};
    const auto colour_of = [](std::uint32_t rgb) {
        return Colour{((rgb >> 16) & 255) / 255.0, ((rgb >> 8) & 255) / 255.0, (rgb & 255) / 255.0};
    };
    for (std::size_t k = 0; k < names.size(); ++k) {
        if (names[k] == text->value) { return colour_of(values[k]); }
    }
    const std::string& t = text->value;
    if (t.size() == 7 && t[0] == '#' &&
        t.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos) {
        return colour_of(static_cast<std::uint32_t>(std::stoul(t.substr(1), nullptr, 16)));
    }
    fields.problems().add(
        text->span, "unknown colour '" + t + "'; expected \"#rrggbb\" or one of " + comma_list(names),
        did_you_mean(t, names));
    return std::nullopt;
}

void read_bodies(Fields& root, Reading& reading) {
    Body ground;
    ground.name = "ground";
    ground.fixed = true;
    reading.lesson.mechanism.bodies.push_back(ground);
    reading.lesson.looks.emplace_back();
    for (Fields& fields : root.tables("body")) { read_body(fields, reading); }
    if (reading.lesson.mechanism.moving_bodies_count() == 0) {
        reading.problems->add(root.span(), "no body moves; expected at least one [[body]] that is not fixed");
    }
}

}  // namespace jw::reading
