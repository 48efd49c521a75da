#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "tests/reference/real.hpp"

/// A mechanism for the general reference solver: bodies, scalar equations between any two of them, loads. A
/// joint is the list of its equations; nothing here knows joint types.
namespace jw::reference::general {

/// A body; its frame is the one that the author gave.
struct Body {
    bool fixed = false;
    Real mass = 1.0L;            ///< [kg]
    Vec3 centre = Vec3::Zero();  ///< of mass, body frame [m]
    Mat3 J = Mat3::Identity();   ///< about the centre of mass, axes of the body frame [kg m²]
    Vec3 r = Vec3::Zero();       ///< origin [m]
    Vec4 p = Vec4::Unit(0);      ///< unit
    Vec3 v = Vec3::Zero();       ///< of the origin [m/s]
    Vec3 omega = Vec3::Zero();   ///< global [rad/s]
};

/// A direction or a point fixed in a body, in the frame of the body.
struct Fixed {
    int body = 0;
    Vec3 local = Vec3::Zero();
};

struct Harmonic {
    Real amplitude = 0.0L;
    Real omega = 0.0L;  ///< [rad/s]
    Real phase = 0.0L;
};
/// `from` before `start`, `to` after `end`, 10u³ - 15u⁴ + 6u⁵ of the way between them.
struct Ramp {
    Real from = 0.0L;
    Real to = 0.0L;
    Real start = 0.0L;
    Real end = 1.0L;
};
/// The natural cubic spline through values at times.
struct Table {
    std::vector<double> times;
    std::vector<double> values;
};
/// A number, "variable", or an operation with its operands: "+", "sin", "power", ...
struct FormulaTree {
    std::string operation;
    Real number = 0.0L;  ///< also the index of a variable, and the exponent of a power
    std::vector<FormulaTree> of;
};
struct TimeFunction {
    std::vector<Real> polynomial;  ///< c0 + c1 t + ...
    std::vector<Harmonic> harmonics;
    std::vector<Ramp> ramps;
    std::vector<Table> tables;
    std::vector<FormulaTree> formulas;
};

// measures; an equation sets a measure equal to a number or a function of time

/// a · b of two directions.
struct Product {
    Fixed a;
    Fixed b;
};
/// Component `axis` of a × b, global.
struct CrossProduct {
    Fixed a;
    Fixed b;
    int axis = 0;
};
/// a · (to - from).
struct Along {
    Fixed a;
    Fixed from;
    Fixed to;
};
/// Component `axis` of a × (to - from), global.
struct CrossDistance {
    Fixed a;
    Fixed from;
    Fixed to;
    int axis = 0;
};
/// Component `axis` of to - from, global.
struct Gap {
    Fixed from;
    Fixed to;
    int axis = 0;
};
/// |to - from|².
struct SquaredDistance {
    Fixed from;
    Fixed to;
};
/// Right-handed angle from u_i to u_j about the unit vector s.
struct Angle {
    Fixed s;
    Fixed u_i;
    Fixed u_j;
};
/// A component of an origin (0, 1, 2) or one of the Euler parameters (3 ... 6).
struct Coordinate {
    int body = 0;
    int number = 0;
};
/// The angle of a nut; its displacement along the thread gives the number of whole turns.
struct ThreadAngle {
    Angle angle;
    Along along;          ///< its direction is unit
    Real alpha = 1.0L;    ///< [m/rad]
    Real d_0 = 0.0L;      ///< [m]
    Real theta_0 = 0.0L;  ///< [rad]
};
/// a · (to - from) - d_0 - alpha (ThreadAngle - theta_0).
struct Thread {
    ThreadAngle angle;
};

/// Angle of a wheel about its unit axis s, from a line to u: the line from centre to centre, the common
/// normal of two axes, or the direction of a rack.
struct WheelAngle {
    enum class Line { centres, normal, rack };
    Line line = Line::centres;
    Fixed s;
    Fixed u;
    Fixed from;  ///< centres
    Fixed to;
    Fixed a;  ///< axes of both wheels, or a is the direction of the rack
    Fixed b;
};
/// The angle of the second wheel less `ratio` times that of the first, with the turns of the first that fit
/// best.
struct Mesh {
    WheelAngle first;
    WheelAngle second;
    Real ratio = 1.0L;
};
/// along - d_0 - alpha (angle - theta_0), with the turns of the angle that fit best.
struct Rolling {
    WheelAngle angle;
    Along along;          ///< its direction is unit
    Real alpha = 1.0L;    ///< [m/rad]
    Real d_0 = 0.0L;      ///< [m]
    Real theta_0 = 0.0L;  ///< [rad]
};

/// A component of to - from, in the axes of the body of `from`, less that of its nearest point on a curve of
/// the body: the first or the second direction across the curve.
struct OffCurve {
    struct Wave {
        Vec3 cos;
        Vec3 sin;
    };
    Fixed from;
    Fixed to;
    Vec3 constant = Vec3::Zero();
    Vec3 linear = Vec3::Zero();
    std::vector<Wave> waves;  ///< of u, 2 u, ...
    bool second = false;
};

/// A formula of the components of vectors: variable 3 k + c is component c of vector k, global.
struct OfVectors {
    struct Vector {
        enum class Kind { direction, point, way };
        Kind kind = Kind::direction;
        Fixed to;         ///< the direction, the point, or the end of the way ...
        Fixed from = {};  ///< ... that begins at this point
    };
    FormulaTree formula;
    std::vector<Vector> vectors;
};

using Measure = std::variant<
    Product, CrossProduct, Along, CrossDistance, Gap, SquaredDistance, Angle, Coordinate, ThreadAngle, Thread,
    WheelAngle, Mesh, Rolling, OffCurve, OfVectors>;

/// measure = constant + f(t), or (f(t))² for a squared distance that is driven.
struct Equation {
    Measure measure;
    Real constant = 0.0L;
    TimeFunction target;
    bool squared = false;  ///< the target is the square of the function
    bool turns = false;    ///< compared up to whole turns
    int of = 0;            ///< joint or driver that it belongs to, for look-ups
};

struct Force {
    Fixed point;
    Vec3 direction = Vec3::Zero();
    bool local = false;  ///< it turns with the body
    TimeFunction magnitude;
};
struct Torque {
    int body = 0;
    Vec3 direction = Vec3::Zero();
    bool local = false;
    TimeFunction magnitude;
    int against = -1;  ///< body that the opposite torque acts on
};
/// size v / √(v² + speed²) against a rate v.
struct Friction {
    Real size = 0.0L;
    Real speed = 1.0L;
};
struct Spring {
    Fixed i;
    Fixed j;
    Real stiffness = 0.0L;
    Real free_length = 0.0L;
    Real damping = 0.0L;
    std::optional<Fixed> axis = {};  ///< of body i: it acts on the displacement along it
    Friction friction = {};
    std::optional<FormulaTree> law = {};  ///< of length or angle, and its rate
};
/// Torque -k (θ - θ0) - c θ̇ - friction on body j about s of body i; turns are counted on from the start.
struct TurningSpring {
    Angle angle;
    Real stiffness = 0.0L;
    Real free_angle = 0.0L;
    Real damping = 0.0L;
    Friction friction = {};
    std::optional<FormulaTree> law = {};  ///< of length or angle, and its rate
};

struct Model {
    std::vector<Body> bodies;
    std::vector<Equation> equations;
    Vec3 gravity = Vec3::Zero();
    std::vector<Force> forces;
    std::vector<Torque> torques;
    std::vector<Spring> springs;
    std::vector<TurningSpring> turning_springs;
};

}  // namespace jw::reference::general
