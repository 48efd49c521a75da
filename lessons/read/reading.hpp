#pragma once

#include <map>

#include "core/model/placement.hpp"
#include "core/quantity/names.hpp"
#include "lessons/fields/fields.hpp"
#include "lessons/lesson/lesson.hpp"
#include "lessons/typed/typed.hpp"

/// Parts of the reader: each turns one kind of table into its part of a Lesson.
namespace jw::reading {

// more than any lecture shows; a small machine can still hold matrices of this size
inline constexpr std::size_t kMostBodies = 500;
inline constexpr std::size_t kMostJoints = 1000;
inline constexpr std::size_t kMostDrivers = 500;

/// Thing that a name of the lesson stands for.
struct Named {
    enum class Kind { body, joint, driver };
    Kind kind = Kind::body;
    int index = 0;
    SourceSpan span;    ///< of its name
    bool sound = true;  ///< false: its own table is wrong, so no conclusions are drawn from it

    Addition addition() const {
        return {kind == Kind::joint ? Addition::Kind::joint : Addition::Kind::driver, index};
    }
};

/// Mass of a body, as far as it was given.
struct ReadMass {
    std::optional<MassProperties> properties;
    SourceSpan span;     ///< of the first of its keys
    bool given = false;  ///< also if it is wrong
};

/// Start value of a joint's angle or displacement.
struct StartValue {
    int joint = 0;
    bool is_angle = false;
    double value = 0.0;  ///< [rad] or [m]
    SourceSpan span;
};

/// A driver whose function includes the value of its quantity in the pose of the file.
struct FromStart {
    int driver = 0;
    double value = 0.0;  ///< [rad] or [m]
};

struct Reading {
    Lesson lesson;
    std::vector<ReadMass> masses;    ///< one per body
    std::vector<int> omegas_global;  ///< bodies whose angular velocity is given in the global frame
    std::vector<StartValue> start_values;
    std::vector<FromStart> from_start;
    Problems* problems = nullptr;
    std::map<std::string, Named, std::less<>> names;

    const Body& body_at(int index) const { return lesson.mechanism.bodies[at(index)]; }
    const Joint& joint_at(int index) const { return lesson.mechanism.joints[at(index)]; }

    /// Reports a mistake.
    void report(Code code, const SourceSpan& span, std::string message, std::string hint = {}) const {
        problems->add(code, span, std::move(message), std::move(hint));
    }
    /// Reports a body that is fixed where one that moves is expected. @return false if it is fixed
    bool moves(int body, const SourceSpan& span) const;

    /// Reads the key `name` and gives it to the entry `index` of its kind. Empty if there is none.
    std::string declare(Fields& fields, Named::Kind kind, int index);
    /// Marks the thing of that name as not to be trusted.
    void distrust(const std::string& name);

    /// Thing that a name refers to; reports a name that is unknown or of another kind.
    const Named* body(const Located<std::string>& name) const;
    const Named* joint(const Located<std::string>& name) const;
    /// A joint or a driver.
    const Named* addition(const Located<std::string>& name) const;
    /// Place of an addition in the order, 0 for the first.
    int place_of(const Named& addition) const;

private:
    using Kinds = std::vector<Named::Kind>;
    const Named* find(const Located<std::string>& name, const Kinds& kinds) const;
};

/// "body", "joint", "driver".
const char* word_for(Named::Kind kind);

void read_head(Fields& root, Lesson& lesson);
void read_motion(Fields& root, Lesson& lesson);
void read_camera(Fields& root, Lesson& lesson);
void read_bodies(Fields& root, Reading& reading);
/// [dynamics], and a check that the bodies have masses; after the bodies.
void read_dynamics(Fields& root, Reading& reading);
/// [precision]; before the joints.
void read_precision(Fields& root, Lesson& lesson);
void read_joints(Fields& root, Reading& reading);
void read_drivers(Fields& root, Reading& reading);
/// Forces, torques, springs, bushings; after joints and drivers.
void read_loads(Fields& root, Reading& reading);
/// Order of additions and texts of steps; after joints and drivers.
void read_order(Fields& root, Reading& reading);
void read_steps(Fields& root, Reading& reading);
void read_questions(Fields& root, Reading& reading);
/// Claims; after the order.
void read_claims(Fields& root, Reading& reading);

/// Key `shape`, one or several.
std::vector<Shape> read_shapes(Fields& fields);
/// Colour by palette name or "#rrggbb".
std::optional<Colour> read_colour(Fields& fields);
/// Key `axes`: columns are the axes of a frame, orthonormal and right-handed.
std::optional<Mat3> read_frame(Fields& fields);
/// The function of time of a driver; an angle has its unit in the keys.
TimeFunction read_time_function(Fields& fields, bool angle);
/// True if one of the keys of such a function is present.
bool has_time_function(Fields& fields, bool angle);
/// Reports impossible values between two times: overflow, or negative ones if `never_negative`; and a table
/// that does not cover them.
void check_values(Fields& fields, const TimeFunction& function, double from, double to, bool never_negative);

/// A point of a moving body: the keys `body` and `at` (global, at the start pose) or `point` (local).
struct ReadPoint {
    int body = 0;
    std::optional<Vec3> point_local;  ///< absent if neither key is there
};
std::optional<ReadPoint> read_point_of_body(Fields& fields, const Reading& reading);

/// Rate of an angle [rad/s], in the unit of its key. @param read  reads a number: any, or a positive one
std::optional<double> read_angular_rate(
    Fields& fields, const std::string& key, IfGiven<double> (Fields::*read)(std::string_view));

/// Endings of keys such as "value" for a quantity, one for each way to write its unit: "_deg_per_s" and
/// "_rad_per_s", or nothing.
std::vector<std::string> unit_endings(const Quantity& quantity, int derivative);

/// The point of "crank.point.x" and "crank.point.speed"; nullptr for other quantities.
Vec3* point_of(Quantity& quantity);
/// The quantity that `text` names; reads also the key `point` where the name does not give the point.
std::optional<NamedQuantity> read_quantity(
    Fields& fields, const Located<std::string>& text, const Reading& reading);

/// Names of the joint types for which `has` holds.
std::string types_with(bool (JointType::*has)() const);

/// Key `bodies`: two different bodies, not both fixed.
struct PairIndices {
    int i = 0;
    int j = 0;
    bool sound = false;
};
PairIndices read_pair(Fields& fields, const Reading& reading);
BodyPair pair_of(const Reading& reading, const PairIndices& indices);

/// Start values of the freedoms that a joint has, the entry `index` of the joints.
void read_start_values(Fields& fields, const Joint& joint, int index, Reading& reading);
/// Moves the bodies to the poses in which the joints have their start values; last, since all points and
/// vectors of a file refer to the poses that it gives. Costs nothing without start values.
void take_start_values(Reading& reading);
/// Value, in the start pose, of the measure that a driver prescribes [m or rad].
double start_value(const Reading& reading, const Driver& driver);

/// Vectors of a joint whose type and bodies are known.
void read_geometry(Fields& fields, const BodyPair& pair, Joint& joint);
/// A point, an axis and sides, as of a revolute joint; without any of the axes' keys, the global z and x
/// axes.
void read_axes_and_point(Fields& fields, const BodyPair& pair, JointGeometry& g);
/// Gives the joints the geometry that was meant, where they are redundant only to the digits typed.
void take_as_meant(std::vector<Fields>& bodies, const std::vector<Fields>& joints, Reading& reading);

}  // namespace jw::reading
