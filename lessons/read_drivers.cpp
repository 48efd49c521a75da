#include <numbers>

#include "lessons/reading.hpp"

namespace jw::reading {

namespace {

/// Numbers under a key with its unit: plain metres, or degrees or radians where the driver turns something.
struct Units {
    bool angle = false;

    std::optional<Located<double>> number(Fields& fields, const std::string& key) const {
        return angle ? fields.angle(key) : fields.number(key);
    }
    std::optional<Located<std::vector<double>>> numbers(Fields& fields, const std::string& key) const {
        if (!angle) { return fields.numbers(key); }
        if (!fields.at_most_one({key + "_deg", key + "_rad"})) { return std::nullopt; }
        auto list = fields.numbers(key + "_deg");
        if (!list) { return fields.numbers(key + "_rad"); }
        for (double& value : list->value) { value *= std::numbers::pi / 180.0; }
        return list;
    }
};

void read_harmonic(Fields& fields, const Units& units, TimeFunction& function) {
    TimeFunction::Harmonic harmonic;
    const auto amplitude = units.number(fields, "amplitude");
    const auto frequency = fields.number("frequency_hz");
    const auto omega = fields.number("omega_rad_per_s");
    if (!fields.at_most_one({"frequency_hz", "omega_rad_per_s"})) { return; }
    if (!frequency && !omega) { fields.missing("frequency_hz", "how often a second"); }
    if (!amplitude) { fields.missing(units.angle ? "amplitude_deg" : "amplitude", "the size of the swing"); }
    if (const auto phase = fields.angle("phase")) { harmonic.phase = phase->value; }
    fields.finish();
    if (amplitude) { harmonic.amplitude = amplitude->value; }
    if (frequency) { harmonic.omega = 2.0 * std::numbers::pi * frequency->value; }
    if (omega) { harmonic.omega = omega->value; }
    function.harmonics.push_back(harmonic);
}

void read_step(Fields& fields, const Units& units, TimeFunction& function) {
    TimeFunction::SmoothStep step;
    const auto from = units.number(fields, "from");
    const auto to = units.number(fields, "to");
    const auto start = fields.number("start_s");
    const auto end = fields.number("end_s");
    if (!to) { fields.missing(units.angle ? "to_deg" : "to", "the value that it ends at"); }
    if (!end) { fields.missing("end_s", "the time at which it ends"); }
    fields.finish();
    if (from) { step.from = from->value; }
    if (to) { step.to = to->value; }
    if (start) { step.start = start->value; }
    if (end) { step.end = end->value; }
    if (end && step.end - step.start < 1e-9) {
        fields.problems().add(end->span, "the step ends before it starts; expected 'end_s' above 'start_s'");
        return;
    }
    function.steps.push_back(step);
}

TimeFunction read_function(Fields& fields, const Units& units) {
    TimeFunction function;
    if (const auto polynomial = units.numbers(fields, "polynomial")) {
        function.polynomial = polynomial->value;
    }
    for (Fields& harmonic : fields.tables("harmonics")) { read_harmonic(harmonic, units, function); }
    for (Fields& step : fields.tables("step")) { read_step(step, units, function); }
    const std::string polynomial = units.angle ? "polynomial_deg" : "polynomial";
    const bool any = fields.has(polynomial) || fields.has("polynomial_rad") || fields.has("harmonics") ||
                     fields.has("step");
    if (!any) { fields.missing(polynomial, "a function of time: " + polynomial + ", harmonics or step"); }
    return function;
}

enum class What { angle, displacement, distance, coordinate };

/// A driver along a joint: only where the joint leaves that freedom.
bool place_on_joint(Fields& fields, const Reading& reading, What what, Driver& driver) {
    const auto name = fields.text("joint");
    if (!name) {
        if (!fields.has("joint")) { fields.missing("joint", "the joint whose freedom is driven"); }
        return false;
    }
    const auto index = reading.joint(*name);
    if (!index) { return false; }
    const Joint& joint = reading.lesson.mechanism.joints[static_cast<std::size_t>(*index)];
    const std::string type(joint.type->name);
    const bool turns = type == "revolute" || type == "cylindrical" || type == "screw";
    const bool slides = type == "prismatic" || type == "cylindrical" || type == "screw";
    if (what == What::angle ? !turns : !slides) {
        fields.problems().add(
            name->span,
            "joint '" + name->value + "' is " + type + " and leaves no such freedom; expected one of " +
                (what == What::angle ? "revolute, cylindrical, screw" : "prismatic, cylindrical, screw"));
        return false;
    }
    driver.joint = *index;
    driver.body_i = joint.body_i;
    driver.body_j = joint.body_j;
    if (what == What::displacement) {
        driver.measure = displacement_of(joint);
    } else if (type == "screw") {
        driver.measure = ThetaMeasure{};
    } else {
        driver.measure = angle_of(joint);
    }
    return true;
}

bool place_between_points(Fields& fields, const Reading& reading, Driver& driver) {
    const auto names = fields.texts("bodies");
    const auto point_i = fields.vector("point_i");
    const auto point_j = fields.vector("point_j");
    if (!names || names->value.size() != 2) {
        fields.problems().add(
            fields.span(), "a distance driver needs 'bodies'; expected two names of bodies");
        return false;
    }
    const auto i = reading.body(names->value[0]);
    const auto j = reading.body(names->value[1]);
    if (!i || !j) { return false; }
    if (*i == *j) {
        fields.problems().add(
            names->value[1].span, "both bodies are the same; expected two different bodies");
        return false;
    }
    driver.body_i = *i;
    driver.body_j = *j;
    driver.measure = SquaredDistanceMeasure{
        point_i ? point_i->value : Vec3::Zero(), point_j ? point_j->value : Vec3::Zero()};
    return true;
}

bool place_on_body(Fields& fields, const Reading& reading, Driver& driver) {
    const auto name = fields.text("body");
    if (!fields.has("body")) { fields.missing("body", "the body whose coordinate is driven"); }
    const auto coordinate = fields.word("coordinate", {"x", "y", "z", "e0", "e1", "e2", "e3"});
    if (!fields.has("coordinate")) { fields.missing("coordinate", "one of x, y, z, e0, e1, e2, e3"); }
    if (!name || !coordinate) { return false; }
    const auto body = reading.body(*name);
    if (!body) { return false; }
    if (reading.lesson.mechanism.bodies[static_cast<std::size_t>(*body)].fixed) {
        fields.problems().add(name->span, "body '" + name->value + "' is fixed; expected one that moves");
        return false;
    }
    driver.body_i = 0;
    driver.body_j = *body;
    driver.measure = CoordinateMeasure{static_cast<int>(*coordinate)};
    return true;
}

void read_driver(Fields& fields, Reading& reading) {
    Driver driver;
    const auto name = fields.text("name");
    if (!fields.has("name")) { fields.missing("name", "a name for the driver"); }
    if (name) { driver.name = name->value; }
    const auto taken = [&](const std::string& other) { return name && other == name->value; };
    bool twice = false;
    for (const Driver& other : reading.lesson.mechanism.drivers) { twice = twice || taken(other.name); }
    for (const Joint& other : reading.lesson.mechanism.joints) { twice = twice || taken(other.name); }
    if (twice) {
        reading.problems->add(
            name->span,
            "'" + driver.name + "' is there twice; expected a name of its own for each joint and driver");
    }
    std::string words;
    if (const auto text = fields.text("text")) { words = text->value; }
    const auto kind = fields.word("quantity", {"angle", "displacement", "distance", "coordinate"});
    if (!fields.has("quantity")) {
        fields.missing("quantity", "one of angle, displacement, distance, coordinate");
    }
    if (!kind) { return; }
    const What what = static_cast<What>(*kind);
    bool placed = false;
    switch (what) {
        case What::angle:
        case What::displacement: placed = place_on_joint(fields, reading, what, driver); break;
        case What::distance: placed = place_between_points(fields, reading, driver); break;
        case What::coordinate: placed = place_on_body(fields, reading, driver); break;
    }
    driver.function = read_function(fields, Units{what == What::angle});
    if (placed) { fields.finish(); }
    if (!placed) { return; }
    reading.lesson.order.push_back(
        {Addition::Kind::driver, static_cast<int>(reading.lesson.mechanism.drivers.size())});
    reading.lesson.mechanism.drivers.push_back(driver);
    reading.lesson.step_texts.drivers.push_back(words);
}

}  // namespace

void read_drivers(Fields& root, Reading& reading) {
    for (Fields& fields : root.tables("driver")) { read_driver(fields, reading); }
}

}  // namespace jw::reading
