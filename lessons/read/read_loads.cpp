#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

#include "lessons/fields/member_keys.hpp"
#include "lessons/format/motion_keys.hpp"
#include "lessons/read/reading.hpp"
#include "lessons/read/scalar_formula.hpp"

namespace jw::reading {

namespace {

constexpr std::size_t kMostLoads = 1000;
// two points closer than this give a spring no direction [m]
constexpr double kShortestSpring = 1e-9;

/// Direction times magnitude of a force or torque: either the key `what`, a vector that is constant or
/// multiplied by a function of time and a law; or the key `direction`, which is normalised, and one of these.
struct Vector {
    Vec3 direction = Vec3::UnitX();
    Frame frame = Frame::global;
    TimeFunction magnitude{.polynomial = {1.0}};
    std::optional<LoadLaw> law;
};
Vector read_vector(Fields& fields, const Reading& reading, const char* what, const char* unit) {
    Vector out;
    out.frame = fields.word("frame", kFrames).value_or(out.frame);
    const auto whole = fields.vector(what);
    const auto direction = fields.direction("direction");
    fields.at_most_one({what, "direction"});
    if (!fields.has("direction")) {
        fields.require(
            what, std::string("three numbers in ") + unit + ", or 'direction' and a function of time");
    }
    if (whole) { out.direction = whole->value; }
    if (direction) { out.direction = unit_of(direction->value); }
    if (fields.has("law")) {
        out.law = read_load_law(fields, reading);
        out.magnitude = {};
    }
    const bool is_constant = fields.has(what) || fields.has("law") || !fields.has("direction");
    if (!is_constant || has_time_function(fields, false)) {
        const int errors = fields.problems().errors_count();
        out.magnitude = read_time_function(fields, false);
        if (fields.problems().errors_count() == errors) {
            check_values(fields, out.magnitude, 0.0, reading.lesson.dynamics->duration, false);
        }
    }
    return out;
}

void read_force(Fields& fields, Reading& reading) {
    DynamicsPlan& plan = *reading.lesson.dynamics;
    const auto place = read_point_of_body(fields, reading);
    const Vector vector = read_vector(fields, reading, "force", "N");
    fields.finish();
    if (!place) { return; }
    const auto& mass = plan.loads.masses[static_cast<std::size_t>(place->body)];
    const Vec3 centre = mass ? mass->centre_local : Vec3::Zero();
    plan.loads.forces.push_back(
        {place->body, place->point_local.value_or(centre), vector.direction, vector.frame, vector.magnitude,
         vector.law});
}

void read_torque(Fields& fields, Reading& reading) {
    DynamicsPlan& plan = *reading.lesson.dynamics;
    const auto name = fields.text("body");
    fields.require("body", "the name of a body that moves");
    const Named* named = name ? reading.body(*name) : nullptr;
    const Vector vector = read_vector(fields, reading, "torque", "N m");
    const auto other = fields.text("against");
    const Named* against = other ? reading.body(*other) : nullptr;
    fields.finish();
    if (named == nullptr || (other && against == nullptr)) { return; }
    if (against != nullptr && against->index == named->index) {
        fields.problems().add(
            Code::same_body, other->span,
            "the torque on body " + in_quotes(name->value) +
                " acts against the same body; expected another one");
    }
    if (reading.lesson.mechanism.bodies[static_cast<std::size_t>(named->index)].fixed) {
        fields.problems().add(
            Code::fixed_body, name->span,
            "body " + in_quotes(name->value) + " is fixed; expected one that moves");
    }
    plan.loads.torques.push_back(
        {named->index, vector.direction, vector.frame, vector.magnitude,
         against != nullptr ? against->index : -1, vector.law});
}

/// Key `friction_speed`, the rate up to which friction grows; for an angle, the key ends with its unit.
std::optional<double> read_friction_speed(Fields& fields, bool angle) {
    if (angle) { return read_angular_rate(fields, "friction_speed", &Fields::positive); }
    const auto speed = fields.positive("friction_speed");
    return speed ? std::optional(speed->value) : std::nullopt;
}

/// Key `law`. @param letter  of the length, displacement or angle
std::optional<ScalarFormula> read_law(Fields& fields, const char* letter) {
    const formula::Symbol symbol{letter, 0, {}, {}};
    const std::array variables{formula::Variable{symbol, 0, 1}, formula::Variable{{"t", 0, {}, {}}, 2}};
    const bool angle = symbol.letter != "d";
    return read_scalar_formula(
        fields, "law", variables,
        angle ? "numbers, \\theta in rad, \\dot{\\theta} and t, such as 2 \\theta^3 + 0.1 \\dot{\\theta}"
              : "numbers, d in m, \\dot{d} and t, such as 50 d + 200 d^3");
}

/// Keys `stiffness`, `damping`, `friction` and `law`, at least one of them.
/// @param spring  if it is about an axis, its rate is that of an angle
template <class S>
void read_constants(Fields& fields, S& spring) {
    constexpr bool kAngle = std::is_same_v<S, RotationalSpring>;
    if (const auto k = fields.not_negative("stiffness")) { spring.stiffness = k->value; }
    if (const auto c = fields.not_negative("damping")) { spring.damping = c->value; }
    const auto friction = fields.not_negative("friction");
    const std::string speed_key = kAngle ? "friction_speed_deg_per_s" : "friction_speed";
    const int errors = fields.problems().errors_count();
    const std::optional<double> speed = read_friction_speed(fields, kAngle);
    if (friction && speed) { spring.friction = {friction->value, *speed}; }
    const bool speed_is_told = fields.problems().errors_count() > errors;
    if (fields.has("friction") && !speed && !speed_is_told) {
        fields.missing(speed_key, "the rate up to which the friction grows; slower motions creep");
    }
    if (!fields.has("friction") && speed) {
        fields.missing(
            "friction", kAngle ? "the size of the friction in N m" : "the size of the friction in N");
    }
    spring.law = read_law(fields, kAngle ? "θ" : "d");
    if (!fields.has("damping") && !fields.has("friction") && !fields.has("law")) {
        fields.require("stiffness", "a number in N/m or N m/rad, or 'damping', 'friction' or 'law'");
    }
}

/// Reports a law without a value at the start. @param value  length, displacement or angle there
void check_law(Fields& fields, const std::optional<ScalarFormula>& law, double value) {
    // the rate at the start may differ from 0
    if (!law || law->uses(1) || std::isfinite(law->at(std::array{value, 0.0, 0.0}))) { return; }
    fields.problems().add(
        Code::formula_without_value, fields.span("law"),
        "the law has no value at the start, where its variable is " + short_number(value) +
            "; expected one that has a value wherever the mechanism moves");
}

/// Both ends of a spring. @return whether they are known
bool read_ends(Fields& fields, const BodyPair& pair, Spring& spring) {
    const int errors = fields.problems().errors_count();
    const auto end = [&](const char* global, const char* local, const char* which, auto to_local, Vec3& P) {
        const auto at = fields.vector(global);
        const auto point = fields.vector(local);
        fields.at_most_one({global, local});
        if (!fields.has(local)) {
            fields.require(
                global, std::string("a point of the ") + which + " body, global at the start pose, or " +
                            in_quotes(local) + " in its frame, in m");
        }
        if (at) { P = to_local(at->value); }
        if (point) { P = point->value; }
    };
    end(
        "at", "point_i", "first", [&](const Vec3& at) { return pair.point_i(at); }, spring.P_i_local);
    end(
        "to", "point_j", "second", [&](const Vec3& to) { return pair.point_j(to); }, spring.P_j_local);
    return fields.problems().errors_count() == errors;
}

/// Hint on how to give the spring a direction: along the axis of a slide, it acts on the displacement.
std::string way_out(const PairIndices& bodies, const Reading& reading) {
    for (const Joint& joint : reading.lesson.mechanism.joints) {
        const bool is_between = (joint.body_i == bodies.i && joint.body_j == bodies.j) ||
                                (joint.body_i == bodies.j && joint.body_j == bodies.i);
        if (!is_between || !joint.type->has_displacement()) { continue; }
        return "for a spring on the displacement of joint " + in_quotes(joint.name) +
               ", give joint = " + in_quotes(joint.name) + " instead of bodies and points";
    }
    return "let its points be apart, with 'free_length' as the length at which it does not pull";
}

/// The joint under `joint`, which must leave that freedom.
const Joint* read_joint_with(
    Fields& fields, const Reading& reading, const char* freedom, bool (JointType::*has)() const) {
    const auto name = fields.text("joint");
    const Named* named = name ? reading.joint(*name) : nullptr;
    if (named == nullptr || !named->sound) { return nullptr; }
    const Joint& joint = reading.lesson.mechanism.joints[static_cast<std::size_t>(named->index)];
    if ((joint.type->*has)()) { return &joint; }
    fields.problems().add(
        Code::no_such_freedom, name->span,
        "joint " + in_quotes(name->value) + " of type " + std::string(joint.type->name) + " has no " +
            freedom + "; expected a joint of type " + types_with(has));
    return nullptr;
}

/// A spring along the axis of a joint.
void read_spring_of_joint(Fields& fields, Reading& reading) {
    for (const char* key : {"bodies", "at", "to", "point_i", "point_j", "free_length"}) {
        fields.at_most_one({"joint", key});
    }
    Spring spring;
    const Joint* joint = read_joint_with(fields, reading, "displacement", &JointType::has_displacement);
    read_constants(fields, spring);
    const auto free = fields.number("free_displacement");
    fields.finish();
    if (joint == nullptr) { return; }
    const DisplacementMeasure displacement = displacement_of(*joint);
    spring.body_i = joint->body_i;
    spring.body_j = joint->body_j;
    spring.P_i_local = displacement.B_i_local;
    spring.P_j_local = displacement.B_j_local;
    spring.s_i_local = displacement.s_i_local;
    const BodyPair pair = pair_of(reading, {joint->body_i, joint->body_j, true});
    spring.free_length = free ? free->value : start_displacement(pair, joint->geometry);
    check_law(fields, spring.law, start_displacement(pair, joint->geometry));
    reading.lesson.dynamics->loads.springs.push_back(spring);
}

void read_spring(Fields& fields, Reading& reading) {
    if (fields.has("joint")) {
        read_spring_of_joint(fields, reading);
        return;
    }
    if (fields.has("free_displacement")) {
        fields.problems().add(
            Code::lonely_key, fields.span("free_displacement"),
            "'free_displacement' needs 'joint' beside it; expected 'free_length' between points");
        fields.number("free_displacement");
    }
    const PairIndices bodies = read_pair(fields, reading);
    const BodyPair pair = pair_of(reading, bodies);
    Spring spring;
    spring.body_i = bodies.i;
    spring.body_j = bodies.j;
    const bool ends_known = read_ends(fields, pair, spring);
    read_constants(fields, spring);
    const auto free_length = fields.not_negative("free_length");
    fields.finish();
    if (bodies.i == bodies.j) { return; }
    const double length = pair.d(spring.P_i_local, spring.P_j_local).norm();
    if (ends_known && bodies.sound && length < kShortestSpring) {
        fields.problems().add(
            Code::points_coincide, fields.span(),
            "the two points of the spring coincide at the start pose; expected a distance above 0",
            "a force along the line between them has no direction there; " + way_out(bodies, reading));
    }
    spring.free_length = free_length ? free_length->value : length;
    check_law(fields, spring.law, length);
    reading.lesson.dynamics->loads.springs.push_back(spring);
}

void read_rotational_spring(Fields& fields, Reading& reading) {
    fields.call("rotational spring");
    fields.require("joint", "the joint about whose axis it acts");
    RotationalSpring spring;
    const Joint* joint = read_joint_with(fields, reading, "angle", &JointType::has_angle);
    read_constants(fields, spring);
    const auto free_angle = fields.angle("free_angle");
    fields.finish();
    if (joint == nullptr) { return; }
    const BodyPair pair = pair_of(reading, {joint->body_i, joint->body_j, true});
    spring.body_i = joint->body_i;
    spring.body_j = joint->body_j;
    spring.angle = angle_of(*joint);
    spring.free_angle = free_angle ? free_angle->value : start_angle(pair, joint->geometry);
    check_law(fields, spring.law, start_angle(pair, joint->geometry));
    reading.lesson.dynamics->loads.rotational_springs.push_back(spring);
}

/// x, y and z of a bushing in a body, as columns.
Mat3 axes_of(const Vec3& axis, const Vec3& side) {
    const Vec3 z = unit_of(axis);
    const Vec3 across = side - z.dot(side) * z;
    // unchanged if they are perpendicular up to rounding: a written bushing reads back the same
    const Vec3 x = std::abs(z.dot(side)) < kUnitUpToRounding ? unit_of(side) : across.normalized();
    Mat3 axes;
    axes << x, z.cross(x), z;
    return axes;
}

/// Reports constants that have no meaning, and sides that are missing.
void check_constants(Fields& fields, Bushing bushing) {
    const bool has_axis = fields.has("axis") || fields.has("axis_i");
    const bool has_side = !has_axis || fields.has("side") || fields.has("side_i");
    bool is_any = false;
    for (const auto& bound : format::kConstantsOfBushing) {
        const std::string key(bound.key.name);
        const Vec3& value = *std::get<Vec3*>(bound.of(bushing));
        is_any = is_any || fields.has(key);
        if (value.minCoeff() < 0.0) {
            fields.problems().add(
                Code::out_of_range, fields.span(key),
                in_quotes(key) + " has a negative number; expected three numbers of at least 0");
        }
        if (value.x() != value.y() && !has_side) {
            fields.missing(
                "side", "the x axis, global, perpendicular to 'axis', since the numbers of x and y differ");
            return;
        }
    }
    if (!is_any) {
        fields.missing(
            "stiffness",
            "three numbers in N/m, or 'damping', 'rotational_stiffness' or 'rotational_damping'");
    }
}

void read_bushing(Fields& fields, Reading& reading) {
    const PairIndices bodies = read_pair(fields, reading);
    JointGeometry g;
    read_axes_and_point(fields, pair_of(reading, bodies), g);
    Bushing bushing;
    read_members(fields, format::kConstantsOfBushing, bushing);
    check_constants(fields, bushing);
    fields.finish();
    if (bodies.i == bodies.j) { return; }
    bushing.body_i = bodies.i;
    bushing.body_j = bodies.j;
    bushing.P_i_local = g.P_i_local;
    bushing.P_j_local = g.P_j_local;
    bushing.axes_i_local = axes_of(g.s_i_local, g.u_i_local);
    bushing.axes_j_local = axes_of(g.s_j_local, g.u_j_local);
    reading.lesson.dynamics->loads.bushings.push_back(bushing);
}

struct Kind {
    const char* key;
    void (*read)(Fields&, Reading&);
};
constexpr std::array kKinds{
    Kind{"force", read_force}, Kind{"torque", read_torque}, Kind{"spring", read_spring},
    Kind{"rotational_spring", read_rotational_spring}, Kind{"bushing", read_bushing}};

/// Reports drivers of an origin that is not the centre of mass: the equations of motion do not contain it.
void check_coordinate_drivers(const Reading& reading) {
    for (const Driver& driver : reading.lesson.mechanism.drivers) {
        const auto* m = std::get_if<CoordinateMeasure>(&driver.measure);
        const auto& mass = reading.lesson.dynamics->loads.masses[static_cast<std::size_t>(driver.body_j)];
        const auto named = reading.names.find(driver.name);
        if (m == nullptr || m->coordinate >= 3 || !mass || mass->centre_local.isZero(0.0)) { continue; }
        if (named == reading.names.end()) { continue; }
        reading.problems->add(
            Code::driven_origin, named->second.span,
            "driver " + in_quotes(driver.name) +
                " moves the origin of a body whose centre of mass is elsewhere; expected 'centre' at the "
                "origin in a lesson of dynamics",
            "a displacement or a distance can be driven at any point");
    }
}

/// Reports start rates of joints in a lesson without dynamics: no motion would begin with them.
void check_start_rates(const Reading& reading) {
    for (const Joint& joint : reading.lesson.mechanism.joints) {
        const JointGeometry& g = joint.geometry;
        const auto named = reading.names.find(joint.name);
        if (named == reading.names.end() || (!g.angle_dot_start && !g.displacement_dot_start)) { continue; }
        reading.problems->add(
            Code::needs_dynamics, named->second.span,
            "joint " + in_quotes(joint.name) + " has a start rate in a lesson without [dynamics]; expected " +
                "a table [dynamics] with the 'duration' in s");
    }
}

}  // namespace

void read_loads(Fields& root, Reading& reading) {
    const bool dynamics_wrong = root.has("dynamics") && !reading.lesson.dynamics;
    for (const Kind& kind : kKinds) {
        if (!root.has(kind.key) || dynamics_wrong) { continue; }
        if (!reading.lesson.dynamics) {
            reading.problems->add(
                Code::needs_dynamics, root.span(kind.key),
                in_quotes(kind.key) + " in a lesson without [dynamics]; expected a table " +
                    "[dynamics] with the 'duration' in s");
            continue;
        }
        for (Fields& fields : root.tables(kind.key, kMostLoads)) { kind.read(fields, reading); }
    }
    if (reading.lesson.dynamics) {
        check_coordinate_drivers(reading);
    } else if (!dynamics_wrong) {
        check_start_rates(reading);
    }
}

}  // namespace jw::reading
