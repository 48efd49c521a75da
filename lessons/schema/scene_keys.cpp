#include "lessons/enum_words.hpp"
#include "lessons/schema/keys.hpp"
#include "lessons/typed.hpp"

/// Keys of the lesson, of bodies, shapes, joints and the camera.
namespace jw {

namespace {

KeyTable lesson_keys() {
    return {
        "lesson",
        {required(counted_key("format", KeyKind::whole_number, "version of the format; the first key", 1, 1)),
         required({"title", KeyKind::plain_words, "title of the lesson"}),
         {"chapter", KeyKind::text, "chapter that it belongs to: a folder's name"},
         {"source", KeyKind::text, "slides or pages of the book"},
         {"text", KeyKind::words, "introduction, shown at the start"},
         {"summary", KeyKind::words, "what to remember, shown at the end"},
         word_key("coordinates", "choice of coordinates that the pictures show", words_of(kChoices)),
         {"order", KeyKind::texts, "joints and drivers in the order in which they are added"},
         required(table_key("body", KeyKind::tables, "bodies: where their frames are at the start", "body")),
         table_key("precision", KeyKind::table, "what the digits of joints are worth", "precision"),
         table_key("joint", KeyKind::tables, "joints, in the order in which they are added", "joint"),
         table_key(
             "driver", KeyKind::tables, "quantities that are prescribed as functions of time", "driver"),
         table_key("motion", KeyKind::table, "the motion that the drivers prescribe", "motion"),
         table_key("dynamics", KeyKind::table, "the motion under masses and forces", "dynamics"),
         table_key("force", KeyKind::tables, "forces at points of bodies", "force"),
         table_key("torque", KeyKind::tables, "torques on bodies", "torque"),
         table_key("spring", KeyKind::tables, "springs and dampers between points", "spring"),
         table_key(
             "rotational_spring", KeyKind::tables, "springs and dampers about the axis of a joint",
             "rotational_spring"),
         table_key("camera", KeyKind::table, "where the scene is seen from", "camera"),
         table_key("step", KeyKind::tables, "texts of steps", "step"),
         table_key("question", KeyKind::tables, "questions before something is shown", "question"),
         table_key("try", KeyKind::tables, "experiments to try", "trial"),
         table_key("expect", KeyKind::tables, "claims, proved by 'jointwise check'", "claim"),
         {"exercise", KeyKind::any, "exercises, with answers that are judged"}}};
}

KeyTable body_keys() {
    Key colour{"colour", KeyKind::text, "a name or \"#rrggbb\""};
    for (const NamedColour& named : kNamedColours) { colour.words.emplace_back(named.name); }
    colour.pattern = "^#[0-9a-fA-F]{6}$";
    KeyTable body{
        "body",
        {required(
             {"name", KeyKind::text, "name by which the lesson refers to it; 'ground' is the global frame"}),
         {"fixed", KeyKind::flag, "it does not move and has no unknowns"},
         {"position", KeyKind::vector, "r, the origin of its frame, global [m]"},
         counted_key("p", KeyKind::numbers, "orientation as Euler parameters (e0, e1, e2, e3)", 4, 4),
         table_key("rotation", KeyKind::table, "instead of p: a rotation about an axis", "rotation"),
         table_key("axes", KeyKind::table, "instead of p: axes of its frame, two or three", "axes"),
         {"velocity", KeyKind::vector, "velocity of the origin, global [m/s]"},
         colour,
         table_key("shape", KeyKind::tables, "what it looks like, in its frame", "shape"),
         {"mass", KeyKind::positive, "mass [kg]"},
         {"inertia", KeyKind::tensor, "J' about the centre of mass [kg m^2]: [Jxx, Jyy, Jzz, Jxy, Jxz, Jyz]"},
         {"centre", KeyKind::vector, "centre of mass, in its frame [m]"}}};
    add_angle(body.keys, "omega_local", KeyKind::vector, "angular velocity, local", "_per_s");
    add_angle(body.keys, "omega_global", KeyKind::vector, "angular velocity, global", "_per_s");
    return body;
}

KeyTable rotation_keys() {
    KeyTable rotation{"rotation", {required({"axis", KeyKind::direction, "axis of the rotation"})}};
    add_angle(rotation.keys, "angle", KeyKind::number, "angle of the rotation");
    return rotation;
}

void add_shape_tables(std::vector<KeyTable>& tables_of_lesson) {
    const Key radius = required({"radius", KeyKind::positive, "radius [m]"});
    const std::vector<Key> bar{
        required({"from", KeyKind::vector, "one end [m]"}),
        required({"to", KeyKind::vector, "the other end [m]"}), radius};
    tables_of_lesson.push_back(
        {"axes",
         {{"x", KeyKind::direction, "x axis, any length"},
          {"y", KeyKind::direction, "y axis, any length"},
          {"z", KeyKind::direction, "z axis, any length"}}});
    tables_of_lesson.push_back(
        {"shape",
         {table_key("box", KeyKind::table, "a box", "box"),
          table_key("sphere", KeyKind::table, "a ball", "sphere"),
          table_key("cylinder", KeyKind::table, "a cylinder", "cylinder"),
          table_key("rod", KeyKind::table, "a cylinder with round ends", "rod")},
         true});
    tables_of_lesson.push_back(
        {"box",
         {required({"size", KeyKind::vector, "lengths of its edges [m]"}),
          {"at", KeyKind::vector, "its centre [m]"},
          table_key("axes", KeyKind::table, "directions of its edges", "axes")}});
    tables_of_lesson.push_back({"sphere", {radius, {"at", KeyKind::vector, "its centre [m]"}}});
    tables_of_lesson.push_back({"cylinder", bar});
    tables_of_lesson.push_back({"rod", bar});
}

std::vector<std::string> names_of_types() {
    std::vector<std::string> names;
    for (const JointType& type : kJointTypes) { names.emplace_back(type.name); }
    return names;
}

KeyTable joint_keys() {
    KeyTable joint{
        "joint",
        {required({"name", KeyKind::text, "name by which the lesson refers to it"}),
         required(word_key("type", "type of the joint", names_of_types())),
         required(counted_key(
             "bodies", KeyKind::texts, "names of two bodies, the first is i, the second j", 2, 2)),
         {"text", KeyKind::words, "the author's words in its step"},
         {"at", KeyKind::vector, "point, global at the start pose [m]"},
         {"to", KeyKind::vector, "point of the second body beside 'at', global [m]"},
         {"point_i", KeyKind::vector, "point in the frame of the first body [m]"},
         {"point_j", KeyKind::vector, "point in the frame of the second body [m]"},
         {"axis", KeyKind::direction, "axis, global at the start pose"},
         {"axis2", KeyKind::direction, "arm of the second body, global, perpendicular to 'axis'"},
         {"axis_i", KeyKind::direction, "axis in the frame of the first body"},
         {"axis_j", KeyKind::direction, "axis in the frame of the second body"},
         {"side", KeyKind::direction, "zero direction of the angle, global, perpendicular to the axis"},
         {"side_i", KeyKind::direction, "side vector in the frame of the first body"},
         {"side_j", KeyKind::direction, "side vector in the frame of the second body"},
         {"length", KeyKind::positive, "distance of the two points [m]"},
         {"pitch", KeyKind::number, "advance in one turn of a screw [m]"},
         {"advance_per_rad", KeyKind::number, "instead of pitch: advance for a radian [m/rad]"},
         {"d_0", KeyKind::number, "displacement of a screw at theta_0 [m]"},
         word_key("angle_row", "equation of a screw's angle", words_of(kAngleRows)),
         word_key("parallel", "which equations of p1 or p2 are kept", words_of(kParallelForms)),
         {"without", KeyKind::texts, "equations that are taken out, as \"p1 x\""}}};
    add_angle(joint.keys, "theta_0", KeyKind::number, "angle of a screw at d_0");
    add_angle(joint.keys, "theta", KeyKind::number, "start value of a screw's coordinate");
    add_angle(joint.keys, "theta_dot", KeyKind::number, "its rate at the start", "_per_s");
    return joint;
}

KeyTable precision_keys() {
    return {
        "precision",
        {{"exact", KeyKind::flag, "all numbers of joints are exact as they are typed"},
         counted_key(
             "digits", KeyKind::whole_number,
             "numbers with so many significant digits are known to half a unit of the last one; default 5", 2,
             17)}};
}

KeyTable camera_keys() {
    return {
        "camera",
        {{"from", KeyKind::direction, "direction from the target to the camera"},
         {"target", KeyKind::vector, "point that it looks at [m]"},
         {"distance", KeyKind::positive, "distance from the target [m]"},
         {"up", KeyKind::direction, "upwards in the picture; default z"},
         {"orthographic", KeyKind::flag, "without perspective"}}};
}

}  // namespace

void add_scene_tables(std::vector<KeyTable>& tables_of_lesson) {
    tables_of_lesson.push_back(lesson_keys());
    tables_of_lesson.push_back(body_keys());
    tables_of_lesson.push_back(rotation_keys());
    add_shape_tables(tables_of_lesson);
    tables_of_lesson.push_back(joint_keys());
    tables_of_lesson.push_back(precision_keys());
    tables_of_lesson.push_back(camera_keys());
}

}  // namespace jw
