#pragma once

#include "core/model/joint_types.hpp"
#include "lessons/format/key.hpp"
#include "lessons/lesson/enum_words.hpp"
#include "lessons/lesson/lesson.hpp"
#include "lessons/typed/typed.hpp"

/// Keys of the lesson, of bodies, shapes, joints and the camera.
namespace jw::format {

inline constexpr std::array kLesson{
    required(counted("format", KeyKind::whole_number, "version of the format; the first key", 1, 1)),
    required({"title", KeyKind::plain_words, "title of the lesson"}),
    Key{"chapter", KeyKind::text, "chapter that it belongs to: a folder's name"},
    Key{"source", KeyKind::text, "slides or pages of the book"},
    Key{"text", KeyKind::words, "introduction, shown at the start"},
    Key{"summary", KeyKind::words, "what to remember, shown at the end"},
    one_of("coordinates", "choice of coordinates that the pictures show", words_in<kChoices>),
    Key{"order", KeyKind::texts, "joints and drivers in the order in which they are added"},
    required(in_table("body", KeyKind::tables, "bodies: where their frames are at the start", "body")),
    in_table("precision", KeyKind::table, "which numbers count as rounded", "precision"),
    in_table("joint", KeyKind::tables, "joints, in the order in which they are added", "joint"),
    in_table("driver", KeyKind::tables, "quantities that are prescribed as functions of time", "driver"),
    in_table("motion", KeyKind::table, "the motion that the drivers prescribe", "motion"),
    in_table("dynamics", KeyKind::table, "the motion under masses and forces", "dynamics"),
    in_table("force", KeyKind::tables, "forces at points of bodies", "force"),
    in_table("torque", KeyKind::tables, "torques on bodies", "torque"),
    in_table("spring", KeyKind::tables, "springs and dampers between points", "spring"),
    in_table(
        "rotational_spring", KeyKind::tables, "springs and dampers about the axis of a joint",
        "rotational_spring"),
    in_table("bushing", KeyKind::tables, "rubber blocks, which yield along and about three axes", "bushing"),
    in_table("camera", KeyKind::table, "where the scene is seen from", "camera"),
    in_table("step", KeyKind::tables, "texts of steps", "step"),
    in_table("question", KeyKind::tables, "questions before something is shown", "question"),
    in_table("try", KeyKind::tables, "experiments to try", "trial"),
    in_table("expect", KeyKind::tables, "claims, proved by 'jointwise check'", "claim"),
    in_table("exercise", KeyKind::tables, "exercises, with answers that are judged", "exercise")};

inline constexpr std::array kBody{
    required({"name", KeyKind::text, "name by which the lesson refers to it; 'ground' is the global frame"}),
    Key{"fixed", KeyKind::flag, "it does not move and has no unknowns"},
    Key{"position", KeyKind::vector, "r, the origin of its frame, global", "m"},
    counted("p", KeyKind::numbers, "orientation as Euler parameters (e0, e1, e2, e3)", 4, 4),
    in_table("rotation", KeyKind::table, "instead of p: a rotation about an axis", "rotation"),
    in_table("axes", KeyKind::table, "instead of p: axes of its frame, two or three", "axes"),
    Key{"velocity", KeyKind::vector, "velocity of the origin, global", "m/s"},
    Key{.name = "colour",
        .kind = KeyKind::text,
        .about = "a name or \"#rrggbb\"",
        .words = words_in<kNamedColours>,
        .pattern = "^#[0-9a-fA-F]{6}$"},
    in_table("shape", KeyKind::tables, "what it looks like, in its frame", "shape"),
    Key{"mass", KeyKind::positive, "mass", "kg"},
    Key{"inertia", KeyKind::tensor, "J' about the centre of mass: [Jxx, Jyy, Jzz, Jxy, Jxz, Jyz]", "kg m²"},
    Key{"centre", KeyKind::vector, "centre of mass, in its frame", "m"},
    spelled({"omega_local", KeyKind::vector, "angular velocity, local"}, Spelling::angular_velocity),
    spelled({"omega_global", KeyKind::vector, "angular velocity, global"}, Spelling::angular_velocity)};

inline constexpr std::array kRotation{
    required({"axis", KeyKind::direction, "axis of the rotation"}),
    spelled({"angle", KeyKind::number, "angle of the rotation"}, Spelling::angle)};

inline constexpr std::array kAxes{
    Key{"x", KeyKind::direction, "x axis, any length"}, Key{"y", KeyKind::direction, "y axis, any length"},
    Key{"z", KeyKind::direction, "z axis, any length"}};

inline constexpr std::array kShape{
    in_table("box", KeyKind::table, "a box", "box"), in_table("sphere", KeyKind::table, "a ball", "sphere"),
    in_table("cylinder", KeyKind::table, "a cylinder", "cylinder"),
    in_table("rod", KeyKind::table, "a cylinder with round ends", "rod")};

inline constexpr std::array kSizeOfBox{
    MemberKey<Box>{
        required({"size", KeyKind::vector, "lengths of its edges", "m"}, "three edge lengths in m"),
        &Box::size},
    MemberKey<Box>{{"at", KeyKind::vector, "its centre", "m"}, &Box::centre}};
inline constexpr std::array kBox = joined(
    keys_in(kSizeOfBox), std::array{in_table("axes", KeyKind::table, "directions of its edges", "axes")});

inline constexpr Key kRadius = required({"radius", KeyKind::positive, "radius", "m"}, "a radius in m");
inline constexpr std::array kSphere{
    MemberKey<Sphere>{{"at", KeyKind::vector, "its centre", "m"}, &Sphere::centre},
    MemberKey<Sphere>{kRadius, &Sphere::radius}};
/// Keys of a cylinder, or of a rod.
template <class Bar>
inline constexpr std::array kBar{
    MemberKey<Bar>{
        required({"from", KeyKind::vector, "one end", "m"}, "a point of the body, three numbers in m"),
        &Bar::from},
    MemberKey<Bar>{
        required({"to", KeyKind::vector, "the other end", "m"}, "a point of the body, three numbers in m"),
        &Bar::to},
    MemberKey<Bar>{kRadius, &Bar::radius}};

inline constexpr std::array kJoint{
    required({"name", KeyKind::text, "name by which the lesson refers to it"}),
    required(one_of("type", "type of the joint", words_in<kJointTypes>)),
    required(counted("bodies", KeyKind::texts, "names of two bodies, the first is i, the second j", 2, 2)),
    Key{"text", KeyKind::words, "the author's words in its step"},
    Key{"at", KeyKind::vector, "point, global at the start pose", "m"},
    Key{"to", KeyKind::vector, "point of the second body beside 'at', global", "m"},
    Key{"point_i", KeyKind::vector, "point in the frame of the first body", "m"},
    Key{"point_j", KeyKind::vector, "point in the frame of the second body", "m"},
    Key{"axis", KeyKind::direction, "axis, global at the start pose"},
    Key{"axis2", KeyKind::direction, "axis of the second body, global, where it has another"},
    Key{"axis_i", KeyKind::direction, "axis in the frame of the first body"},
    Key{"axis_j", KeyKind::direction, "axis in the frame of the second body"},
    Key{"side", KeyKind::direction, "zero direction of the angle, global, perpendicular to the axis"},
    Key{"side_i", KeyKind::direction, "side vector in the frame of the first body"},
    Key{"side_j", KeyKind::direction, "side vector in the frame of the second body"},
    Key{"length", KeyKind::positive, "distance of the two points", "m"},
    Key{"pitch", KeyKind::number, "advance in one turn of a screw", "m"},
    Key{"advance_per_rad", KeyKind::number, "instead of pitch: advance for a radian", "m/rad"},
    Key{"radius", KeyKind::number, "radius of the wheel on a rack, negative: turns left-handed", "m"},
    Key{"ratio", KeyKind::number, "turns of the second wheel in one turn of the first"},
    Key{"radii", KeyKind::numbers, "instead of ratio: radii of both wheels, of a ring negative", "m"},
    Key{"d_0", KeyKind::number, "displacement of a screw or a rack at theta_0", "m"},
    Key{"formula", KeyKind::formula, "equation of a formula joint, of s_i, s_j, u_i, u_j, d, r_i, r_j, ..."},
    in_table("curve", KeyKind::table, "curve in the frame of the first body, from point_i on", "curve"),
    one_of("angle_row", "equation of a screw's angle", words_in<kAngleRows>),
    one_of("parallel", "which equations of p1 or p2 are kept", words_in<kParallelForms>),
    Key{"without", KeyKind::texts, "equations that are taken out, such as \"p1 x\""},
    spelled({"theta_0", KeyKind::number, "angle of a screw or a rack at d_0"}, Spelling::angle),
    spelled(
        {"theta", KeyKind::number, "start value of the coordinate of a screw or a wheel"}, Spelling::angle),
    spelled({"theta_dot", KeyKind::number, "its rate at the start"}, Spelling::angular_velocity),
    spelled({"angle", KeyKind::number, "angle of the joint at the start"}, Spelling::angle),
    Key{"displacement", KeyKind::number, "its displacement at the start", "m"},
    spelled(
        {"angle_dot", KeyKind::number, "rate of the joint's angle at the start of dynamics"},
        Spelling::angular_velocity),
    Key{"displacement_dot", KeyKind::number, "rate of its displacement at the start of dynamics", "m/s"}};

/// Limits for the points of a closed curve, and for the harmonics of any curve.
inline constexpr int kFewestPoints = 3;
inline constexpr int kMostPoints = 200;
inline constexpr int kMostHarmonics = 100;

inline constexpr std::array kCurve{
    counted(
        "points", KeyKind::vectors, "closed curve through these points, evenly spread over theta",
        kFewestPoints, kMostPoints),
    Key{"constant", KeyKind::vector, "instead of points: middle of the curve", "m"},
    Key{"linear", KeyKind::vector, "advance for a radian of theta", "m/rad"},
    counted("cos", KeyKind::vectors, "factors of cos theta, cos 2 theta, ...", 1, kMostHarmonics),
    counted("sin", KeyKind::vectors, "factors of sin theta, sin 2 theta, ...", 1, kMostHarmonics)};

inline constexpr std::array kPrecision{
    MemberKey<Precision>{
        {"exact", KeyKind::flag, "all numbers of joints are exact as they are typed"}, &Precision::exact},
    MemberKey<Precision>{
        counted(
            "digits", KeyKind::whole_number,
            "numbers with so many significant digits are known to half a unit of the last one; default 5", 2,
            17),
        &Precision::digits}};

inline constexpr std::array kCamera{
    MemberKey<CameraWish>{
        {"from", KeyKind::direction, "direction from the target to the camera"}, &CameraWish::from},
    MemberKey<CameraWish>{{"target", KeyKind::vector, "point that it looks at", "m"}, &CameraWish::target},
    MemberKey<CameraWish>{
        {"distance", KeyKind::positive, "distance from the target", "m"}, &CameraWish::distance},
    MemberKey<CameraWish>{{"up", KeyKind::direction, "upwards in the picture; default z"}, &CameraWish::up},
    MemberKey<CameraWish>{{"orthographic", KeyKind::flag, "without perspective"}, &CameraWish::orthographic}};

// keys of tables whose keys are all bound to members
inline constexpr std::array kSphereKeys = keys_in(kSphere);
inline constexpr std::array kCylinderKeys = keys_in(kBar<Cylinder>);
inline constexpr std::array kRodKeys = keys_in(kBar<Rod>);
inline constexpr std::array kPrecisionKeys = keys_in(kPrecision);
inline constexpr std::array kCameraKeys = keys_in(kCamera);

inline constexpr std::array kSceneTables{
    KeyTable{"lesson", kLesson},     KeyTable{"body", kBody},
    KeyTable{"rotation", kRotation}, KeyTable{"axes", kAxes},
    KeyTable{"shape", kShape, true}, KeyTable{"box", kBox},
    KeyTable{"sphere", kSphereKeys}, KeyTable{"cylinder", kCylinderKeys},
    KeyTable{"rod", kRodKeys},       KeyTable{"joint", kJoint},
    KeyTable{"curve", kCurve},       KeyTable{"precision", kPrecisionKeys},
    KeyTable{"camera", kCameraKeys}};

}  // namespace jw::format
