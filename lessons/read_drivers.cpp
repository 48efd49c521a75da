#include <algorithm>

#include "lessons/reading.hpp"

namespace jw::reading {

namespace {

enum class What { angle, displacement, distance, coordinate };

/// A driver along a joint: only where the joint leaves that freedom.
/// @return the value in the start pose, nothing if it is not known
std::optional<double> place_on_joint(Fields& fields, const Reading& reading, What what, Driver& driver) {
    const auto name = fields.text("joint");
    fields.require("joint", "the joint whose freedom is driven");
    const Named* named = name ? reading.joint(*name) : nullptr;
    if (named == nullptr || !named->sound) { return std::nullopt; }
    const Joint& joint = reading.lesson.mechanism.joints[static_cast<std::size_t>(named->index)];
    const auto has = what == What::angle ? &JointType::has_angle : &JointType::has_displacement;
    if (!(joint.type->*has)()) {
        fields.problems().add(
            name->span, "joint " + in_quotes(name->value) + " of type " + std::string(joint.type->name) +
                            " has no " + (what == What::angle ? "angle" : "displacement") +
                            "; expected a joint of type " + types_with(has));
        return std::nullopt;
    }
    driver.joint = named->index;
    driver.body_i = joint.body_i;
    driver.body_j = joint.body_j;
    const BodyPair pair = pair_of(reading, {joint.body_i, joint.body_j, true});
    if (what == What::displacement) {
        driver.measure = displacement_of(joint);
        return start_displacement(pair, joint.geometry);
    }
    driver.measure = joint.type->artificial > 0 ? Measure(ThetaMeasure{}) : Measure(angle_of(joint));
    return start_angle(pair, joint.geometry);
}

std::optional<double> place_between_points(Fields& fields, const Reading& reading, Driver& driver) {
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
    if (!indices.sound) { return std::nullopt; }
    return pair.d(measure.P_i_local, measure.P_j_local).norm();
}

std::optional<double> place_on_body(Fields& fields, const Reading& reading, Driver& driver) {
    const auto name = fields.text("body");
    fields.require("body", "the body whose coordinate is driven");
    const auto coordinate = fields.word("coordinate", strings(kCoordinates));
    fields.require("coordinate", "one of x, y, z, e0, e1, e2, e3");
    const Named* named = name ? reading.body(*name) : nullptr;
    if (named == nullptr || !coordinate) { return std::nullopt; }
    const Body& body = reading.lesson.mechanism.bodies[static_cast<std::size_t>(named->index)];
    if (body.fixed) {
        fields.problems().add(
            name->span, "body " + in_quotes(name->value) + " is fixed; expected one that moves");
    }
    driver.body_i = 0;
    driver.body_j = named->index;
    driver.measure = CoordinateMeasure{static_cast<int>(*coordinate)};
    const auto k = static_cast<Eigen::Index>(*coordinate);
    return k < 3 ? body.r(k) : body.p(k - 3);
}

std::optional<double> place(Fields& fields, const Reading& reading, What what, Driver& driver) {
    switch (what) {
        case What::angle:
        case What::displacement: return place_on_joint(fields, reading, what, driver);
        case What::distance: return place_between_points(fields, reading, driver);
        case What::coordinate: return place_on_body(fields, reading, driver);
    }
    return std::nullopt;
}

/// Over the motion and over the time that is integrated; without either everything happens at t = 0.
void check_over_all_times(Fields& fields, const Lesson& lesson, const Driver& driver) {
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
    const auto words = fields.text("text");
    const auto from_start = fields.flag("from_start");
    const auto what = fields.word("quantity", {"angle", "displacement", "distance", "coordinate"});
    fields.require("quantity", "one of angle, displacement, distance, coordinate");
    if (what) {
        const auto start = place(fields, reading, static_cast<What>(*what), driver);
        driver.function = read_time_function(fields, static_cast<What>(*what) == What::angle);
        if (from_start && from_start->value && start) {
            driver.function.polynomial.resize(std::max<std::size_t>(1, driver.function.polynomial.size()));
            driver.function.polynomial[0] += *start;
        }
        fields.finish();
        if (start && reading.problems->errors_count() == errors) {
            check_over_all_times(fields, reading.lesson, driver);
        }
    }
    if (reading.problems->errors_count() > errors) { reading.distrust(driver.name); }
    reading.lesson.order.push_back({Addition::Kind::driver, index});
    reading.lesson.step_texts.drivers.push_back(words ? words->value : "");
    drivers.push_back(std::move(driver));
}

}  // namespace

void read_drivers(Fields& root, Reading& reading) {
    for (Fields& fields : root.tables("driver", kMostDrivers)) { read_driver(fields, reading); }
}

}  // namespace jw::reading
