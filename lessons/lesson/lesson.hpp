#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/integrate/simulation_settings.hpp"
#include "core/model/mechanism.hpp"
#include "core/motion/loads.hpp"
#include "core/numerics/variants.hpp"
#include "lessons/lesson/claims.hpp"
#include "lessons/lesson/questions.hpp"

/// A lesson as data, as the rest of the program uses it. docs/writing-a-lesson.md describes the file.
///
/// Everything in it is resolved: names are indices into `mechanism`, angles are radians, directions are
/// local, and all numbers are finite.
namespace jw {

/// sRGB, 0..1.
struct Colour {
    double red = 0.0;
    double green = 0.0;
    double blue = 0.0;
};

/// Shapes to draw; points and axes in the body frame [m].
struct Box {
    Vec3 size = Vec3::Ones();  ///< edge lengths along the columns of `axes`
    Vec3 centre = Vec3::Zero();
    Mat3 axes = Mat3::Identity();  ///< right-handed, orthonormal
};
struct Cylinder {
    Vec3 from = Vec3::Zero();
    Vec3 to = Vec3::UnitZ();
    double radius = 0.1;
};
struct Sphere {
    Vec3 centre = Vec3::Zero();
    double radius = 0.1;
};
/// A slender cylinder with round ends.
struct Rod {
    Vec3 from = Vec3::Zero();
    Vec3 to = Vec3::UnitZ();
    double radius = 0.02;
};
using Shape = std::variant<Box, Cylinder, Sphere, Rod>;

/// Appearance of a body. Without a shape, the renderer chooses what to draw between the joints.
struct Look {
    std::vector<Shape> shapes;
    std::optional<Colour> colour;  ///< absent: the next colour of the palette
};

/// Camera as the author specified it; absent values are chosen automatically.
struct CameraWish {
    std::optional<Vec3> from;        ///< unit direction from the target to the camera, global
    std::optional<Vec3> target;      ///< [m]
    std::optional<double> distance;  ///< camera to target [m], > 0
    std::optional<Vec3> up;          ///< unit, global
    bool orthographic = false;
};

/// The motion that is shown after the mechanism has been assembled.
struct MotionPlan {
    double from = 0.0;      ///< [s]
    double to = 1.0;        ///< [s], > from
    double duration = 1.0;  ///< time that it takes on the screen [s], for any frame rate
    int steps = 100;        ///< equal intervals of time that are solved
};

/// A point of a body, in the body frame [m].
struct BodyPoint {
    int body = 0;
    Vec3 point_local = Vec3::Zero();
};

/// Dynamics of a lesson: masses, loads, and the default settings of integration.
struct DynamicsPlan {
    Loads loads;
    double duration = 1.0;  ///< [s], > 0, from t = 0
    SimulationSettings settings;
    bool method_given = false;       ///< the author's choice, not the default
    std::optional<BodyPoint> point;  ///< whose path is compared and plotted
    /// Position of the point at the end by a trusted computation [m], with its trusted digits only.
    std::optional<Vec3> point_at_end;
    SourceSpan point_at_end_span;  ///< in the lesson file, for messages
};

/// The joint or driver that a claim is about, index -1 for none.
inline Addition subject_of(const Fact& fact) {
    const Addition none{Addition::Kind::joint, -1};
    return std::visit(
        Overloaded{
            [&](const CountClaim&) { return none; },
            [&](const BoundClaim&) { return none; },
            [&](const VerdictClaim&) { return none; },
            [](const DroppedClaim& c) {
                return Addition{Addition::Kind::joint, c.joint};
            },
            [&](const FormulaClaim& c) {
                return c.formula.subject.joint < 0 ? none
                                                   : Addition{Addition::Kind::joint, c.formula.subject.joint};
            },
            [](const QuantityClaim& c) {
                const int joint = joint_of(c.quantity);
                return joint >= 0 ? Addition{Addition::Kind::joint, joint}
                                  : Addition{Addition::Kind::driver, driver_of(c.quantity)};
            },
        },
        fact);
}

/// Texts of the author, empty where there are none.
struct StepTexts {
    struct AtTime {
        double from = 0.0;  ///< shown from this time of the motion on [s]
        Text text;
    };
    Text bodies;                ///< first step: the free bodies
    std::vector<Text> joints;   ///< one per joint of the mechanism
    std::vector<Text> drivers;  ///< one per driver
    Text motion;                ///< while it moves
    std::vector<AtTime> times;  ///< sorted by time
};

/// Accuracy of the numbers of joints.
struct Precision {
    bool exact = false;  ///< all are exact as they are typed
    int digits = 5;      ///< numbers with this many significant digits are known to half a unit of the last

    bool operator==(const Precision&) const = default;
};

struct Lesson {
    std::string file_name;  ///< as it was given to the reader
    Text title;
    std::string chapter;
    std::string source;  ///< slides or book pages
    Text text;
    Text summary;  ///< what to remember, in two lines; shown at the end

    Mechanism mechanism;  ///< bodies[0] is the ground
    Precision precision;
    std::vector<Look> looks;      ///< one per body of the mechanism
    std::vector<Addition> order;  ///< every joint and driver once, in the order in which they are added
    CoordinateChoice coordinates = CoordinateChoice::modified_euler_parameters;
    std::optional<MotionPlan> motion;
    std::optional<DynamicsPlan> dynamics;
    CameraWish camera;
    StepTexts step_texts;
    std::vector<Claim> claims;
    std::vector<Question> questions;
    std::vector<Trial> trials;  ///< what the author proposes to try
};

}  // namespace jw
