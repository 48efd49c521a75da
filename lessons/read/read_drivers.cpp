#include <algorithm>

#include "lessons/read/reading.hpp"

namespace jw::reading {

namespace {

enum class What { angle, displacement, distance, coordinate };

/// Finds the measure of a driver along a joint, which must leave that freedom.
/// @return false if the value in the start pose cannot be computed
bool place_on_joint(Fields& fields, const Reading& reading, What what, Driver& driver) {
    const auto name = fields.text("joint");
    fields.require("joint", "the joint whose freedom is driven");
    const Named* named = name ? reading.joint(*name) : nullptr;
    if (named == nullptr || !named->sound) { return false; }
    const Joint& joint = reading.joint_at(named->index);
    const auto has = what == What::angle ? &JointType::has_angle : &JointType::has_displacement;
    if (!(joint.type->*has)()) {
        fields.report(
            Code::no_such_freedom, name->span,
            "joint " + in_quotes(name->value) + " of type " + std::string(joint.type->name) + " has no " +
                (what == What::angle ? "angle" : "displacement") + "; expected a joint of type " +
                types_with(has));
        return false;
    }
    driver.joint = named->index;
    driver.body_i = joint.body_i;
    driver.body_j = joint.body_j;
    if (what == What::displacement) {
        driver.measure = displacement_of(joint);
    } else {
        driver.measure = joint.type->artificial > 0 ? Measure(ThetaMeasure{}) : Measure(angle_of(joint));
    }
    return true;
}

bool place_between_points(Fields& fields, const Reading& reading, Driver& driver) {
    const PairIndices indices = read_pair(fields, reading);
    const BodyPair pair = pair_of(reading, indices);
    const auto at = fields.vector("at");
    const auto to = fields.vector("to");
    const auto point_i = fields.vector("point_i");
    const auto point_j = fields.vector("point_j");
    fields.at_most_one({"at", "point_i"});
    fields.at_most_one({"to", "point_j"});
    SquaredDistanceMeasure measure{
        point_i ? point_i->value : Vec3::Zero(), point_j ? point_j->value : Vec3::Zero()};
    if (at) { measure.P_i_local = pair.point_i(at->value); }
    if (to) { measure.P_j_local = pair.point_j(to->value); }
    driver.body_i = indices.i;
    driver.body_j = indices.j;
    driver.measure = measure;
    return indices.sound;
}

bool place_on_body(Fields& fields, const Reading& reading, Driver& driver) {
    const auto name = fields.text("body");
    fields.require("body", "the body whose coordinate is driven");
    const auto coordinate = fields.word("coordinate");
    fields.require("coordinate", "one of x, y, z, e0, e1, e2, e3");
    const Named* named = name ? reading.body(*name) : nullptr;
    if (named == nullptr || !coordinate) { return false; }
    reading.moves(named->index, name->span);
    driver.body_i = 0;
    driver.body_j = named->index;
    driver.measure = CoordinateMeasure{static_cast<int>(*coordinate)};
    return true;
}

bool place(Fields& fields, const Reading& reading, What what, Driver& driver) {
    switch (what) {
        case What::angle:
        case What::displacement: return place_on_joint(fields, reading, what, driver);
        case What::distance: return place_between_points(fields, reading, driver);
        case What::coordinate: return place_on_body(fields, reading, driver);
    }
    return false;
}

/// Finds the measure that the name of a quantity stands for: "hinge.angle", "crank.x".
/// @return false if there is none that a driver can prescribe
bool place_by_name(Fields& fields, const Reading& reading, const Located<std::string>& name, Driver& driver) {
    const int errors = fields.problems().errors_count();
    const std::optional<NamedQuantity> named = read_quantity(fields, name, reading);
    if (!named || fields.problems().errors_count() > errors) { return false; }
    const auto* quantity = std::get_if<MeasureQuantity>(&named->quantity);
    const bool is_distance =
        quantity != nullptr && std::holds_alternative<SquaredDistanceMeasure>(quantity->measure);
    const bool is_held = is_distance && (quantity->joint >= 0 || quantity->driver >= 0);
    if (quantity == nullptr || named->derivative != 0 || is_held) {
        fields.report(
            Code::cannot_be_driven, name.span,
            "no driver can prescribe " + in_quotes(name.value) +
                "; expected the angle or displacement of a joint, a coordinate of a body or the "
                "distance of two points",
            "for example hinge.angle, slider.x or crank.distance[0 0 0].rod[1 0 0]");
        return false;
    }
    if (is_distance && quantity->body_i == quantity->body_j) {
        fields.report(
            Code::same_body, name.span,
            "both points of " + in_quotes(name.value) + " belong to one body; expected two bodies");
        return false;
    }
    if (quantity->joint < 0) {
        const bool from_fixed = !is_distance || reading.body_at(quantity->body_i).fixed;
        if (from_fixed) { reading.moves(quantity->body_j, name.span); }
    }
    driver.joint = quantity->joint;
    driver.body_i = quantity->body_i;
    driver.body_j = quantity->body_j;
    driver.measure = quantity->measure;
    return true;
}

/// Checks the values over the motion and over the time of integration; without either, those at t = 0.
void check_over_all_times(Fields& fields, const Lesson& lesson, const Driver& driver) {
    if (lesson.dynamics && driver.function.acceleration_jumps()) {
        fields.report(
            Code::cannot_be_driven, fields.span("table"),
            fields.what() +
                " follows a monotone table, whose acceleration jumps at its times; expected "
                "interpolation = \"smooth\" in a lesson with [dynamics]",
            "methods of integration need a continuous acceleration");
    }
    const bool distance = std::holds_alternative<SquaredDistanceMeasure>(driver.measure);
    const int errors = fields.problems().errors_count();
    const double duration = lesson.dynamics ? lesson.dynamics->duration : 0.0;
    if (lesson.motion) {
        check_values(fields, driver.function, lesson.motion->from, lesson.motion->to, distance);
    }
    if ((lesson.dynamics || !lesson.motion) && fields.problems().errors_count() == errors) {
        check_values(fields, driver.function, 0.0, duration, distance);
    }
}

void read_driver(Fields& fields, Reading& reading) {
    const int errors = reading.problems->errors_count();
    std::vector<Driver>& drivers = reading.lesson.mechanism.drivers;
    const int index = static_cast<int>(drivers.size());
    Driver driver;
    driver.measure = ThetaMeasure{};
    driver.name = reading.declare(fields, Named::Kind::driver, index);
    const auto words = fields.words("text");
    const auto from_start = fields.flag("from_start");
    const auto quantity = fields.text("quantity");
    fields.require(
        "quantity", "one of angle, displacement, distance, coordinate, or a name such as hinge.angle");
    const bool is_name = quantity && quantity->value.find('.') != std::string::npos;
    const auto what = quantity && !is_name ? fields.word("quantity") : std::nullopt;
    if (is_name || what) {
        const bool placed = is_name ? place_by_name(fields, reading, *quantity, driver)
                                    : place(fields, reading, static_cast<What>(*what), driver);
        // where the target is wrong, the keys of the function are read as they were probably meant
        const bool angle_named =
            is_name ? quantity->value.ends_with(".angle") : what == static_cast<std::size_t>(What::angle);
        const bool angle = placed ? unit_of(driver.measure) == Unit::radian : angle_named;
        driver.function = read_time_function(fields, angle);
        if (from_start && from_start->value && placed) {
            driver.function.polynomial.resize(std::max<std::size_t>(1, driver.function.polynomial.size()));
            const double value = start_value(reading, driver);
            driver.function.polynomial[0] += value;
            reading.from_start.push_back({index, value});
        }
        fields.finish();
        if (placed && reading.problems->errors_count() == errors) {
            check_over_all_times(fields, reading.lesson, driver);
        }
    }
    if (reading.problems->errors_count() > errors) { reading.distrust(driver.name); }
    reading.lesson.order.push_back({Addition::Kind::driver, index});
    reading.lesson.step_texts.drivers.push_back(words ? words->value : Text());
    drivers.push_back(std::move(driver));
}

}  // namespace

double start_value(const Reading& reading, const Driver& driver) {
    const BodyPair pair = pair_of(reading, {driver.body_i, driver.body_j, true});
    const auto geometry = [&]() -> const JointGeometry& { return reading.joint_at(driver.joint).geometry; };
    return std::visit(
        Overloaded{
            [&](const DisplacementMeasure&) { return start_displacement(pair, geometry()); },
            [&](const SquaredDistanceMeasure& m) { return pair.d(m.P_i_local, m.P_j_local).norm(); },
            [&](const CoordinateMeasure& m) {
                const Body& body = reading.body_at(driver.body_j);
                return m.coordinate < 3 ? body.r(m.coordinate) : body.p(m.coordinate - 3);
            },
            [&](const auto& /*angle*/) { return start_angle(pair, geometry()); },
        },
        driver.measure);
}

void read_drivers(Fields& root, Reading& reading) {
    for (Fields& fields : root.tables("driver", kMostDrivers)) { read_driver(fields, reading); }
}

}  // namespace jw::reading
