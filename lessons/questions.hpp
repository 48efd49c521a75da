#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lessons/addition.hpp"
#include "lessons/claims.hpp"
#include "lessons/things.hpp"

/// What a lesson asks before it shows, and what it proposes to try.
namespace jw {

/// How many there are once the step is done: the rank, the freedoms, ...
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
    int derivative = 0;  ///< as the name says
    AtTime when;
    bool in_degrees = false;  ///< answers are typed in degrees
    double tolerance = 0.0;   ///< SI, radians; > 0
};
/// One of several sentences.
struct ChoiceAnswer {
    std::vector<Text> choices;
    int right = 0;  ///< index of the right one
};
/// Rows that are found in the scene once the step is done.
enum class RowsFound {
    dropped,    ///< left out of their p1 or p2
    redundant,  ///< repeat others, or are repeated by them
};
/// A thing that is clicked, or named; any of the right ones will do.
struct PointedAnswer {
    Thing::Kind kind = Thing::Kind::row;
    std::vector<Thing> right;        ///< as the author wrote them; empty where `found` says it
    std::optional<RowsFound> found;  ///< rows only
};
/// The pose of a body, led there by hand.
struct PoseAnswer {
    int body = 0;
    std::optional<AtTime> when;  ///< nothing: once the step is done
    double tolerance_m = 0.0;    ///< of its point r; > 0
    double tolerance_rad = 0.0;  ///< of its turn from the right orientation; > 0
};
/// Only choices and things that the author lists have their answer in the file: all others are computed.
using Answer =
    std::variant<CountAnswer, DroppedAnswer, QuantityAnswer, ChoiceAnswer, PointedAnswer, PoseAnswer>;

/// Asked before a step is shown.
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
/// False for what was taken out of the lesson, also for a driver whose joint was.
bool is_added(const Addition& addition, const Lesson& lesson);
/// False where what it is about is not there (any more): its joint or driver, or the motion.
bool applies(const Question& question, const Lesson& lesson);

/// A proposal to try something.
struct Trial {
    Text text;
    std::vector<std::string> actions;  ///< experiments as `jointwise try --try` takes them
    bool breaks = false;               ///< the scene does not survive it, on purpose
    SourceSpan span;
};

}  // namespace jw
