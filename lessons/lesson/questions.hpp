#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lessons/lesson/claims.hpp"
#include "lessons/lesson/things.hpp"

/// Questions that a lesson asks before it shows a step, and experiments that it proposes.
namespace jw {

/// A joint or a driver that is added in one step.
struct Addition {
    enum class Kind { joint, driver };
    Kind kind = Kind::joint;
    int index = 0;  ///< into mechanism.joints or mechanism.drivers

    bool operator==(const Addition&) const = default;
};

/// A number after the step: the rank, the freedoms, ...
struct CountAnswer {
    Count count = Count::dof;
};
/// Which of x, y, z is left out of a joint's p1 or p2.
struct DroppedAnswer {
    int joint = 0;
    Role role = Role::axes_parallel;
};
/// A quantity at a time of the motion.
struct QuantityAnswer {
    Quantity quantity;
    std::string text;    ///< as the author wrote it, "hinge.angle"
    int derivative = 0;  ///< order of the derivative in the name
    AtTime when;
    bool in_degrees = false;  ///< answers are typed in degrees
    double tolerance = 0.0;   ///< SI, radians; > 0
};
/// One of several sentences.
struct ChoiceAnswer {
    std::vector<Text> choices;
    int right = 0;  ///< index of the right one
};
/// Rows that are found in the scene after the step.
enum class RowsFound {
    dropped,    ///< left out of their p1 or p2
    redundant,  ///< redundant, or imply one that is redundant
};
/// A thing that is clicked or named; any of the right ones is accepted.
struct PointedAnswer {
    Thing::Kind kind = Thing::Kind::row;
    std::vector<Thing> right;        ///< from the lesson file; empty where `found` gives them
    std::optional<RowsFound> found;  ///< rows only
};
/// The pose to which the student drags a body.
struct PoseAnswer {
    int body = 0;
    std::optional<AtTime> when;  ///< nothing: after the step
    double tolerance_m = 0.0;    ///< for its point r; > 0
    double tolerance_rad = 0.0;  ///< for the angle between its orientation and the right one; > 0
};
/// The file contains the answer only for choices and listed things; all other answers are computed.
using Answer =
    std::variant<CountAnswer, DroppedAnswer, QuantityAnswer, ChoiceAnswer, PointedAnswer, PoseAnswer>;

/// A question that is asked before a step is shown.
struct Question {
    enum class Place { bodies, addition, motion };
    Place place = Place::addition;
    Addition addition{};  ///< what is added after the question, for Place::addition
    Text ask;
    Answer answer;
    Text why;         ///< shown with the answer
    SourceSpan span;  ///< of its table in the lesson file
};

struct Lesson;
/// False for a joint or driver that was taken out of the lesson, and for a driver whose joint was taken out.
bool is_added(const Addition& addition, const Lesson& lesson);
/// False if the question's joint, driver or motion does not exist (any more).
bool applies(const Question& question, const Lesson& lesson);

/// A proposal to try something.
struct Trial {
    Text text;
    std::vector<std::string> actions;  ///< experiments as `jointwise try --try` takes them
    bool breaks = false;               ///< the scene fails after it, on purpose
    SourceSpan span;
};

}  // namespace jw
