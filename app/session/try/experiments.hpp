#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/numerics/variants.hpp"
#include "lessons/lesson/lesson.hpp"

/// Experiments: what a person can do with an open lesson, such as going to another step or trying another
/// variant than the author's. Plain values: the window makes them from clicks and keys, the command line from
/// text.
namespace jw {

/// Another step of the story; a number beyond its ends means the first or the last step.
struct GoTo {
    int step = 0;
};

/// Which of the three equations of p1 and p2 a joint keeps.
struct SetParallelForm {
    int joint = 0;
    ParallelForm form = ParallelForm::rule;
};

/// Which equation ties θ of a screw to the angle.
struct SetScrewAngleForm {
    int joint = 0;
    ScrewAngleForm form = ScrewAngleForm::rotation;
};

struct SetCoordinates {
    CoordinateChoice choice = CoordinateChoice::modified_euler_parameters;
};

/// A joint or a driver is taken out, or put back where the author has it.
struct SetPresent {
    Addition what;
    bool present = false;
};

/// One single equation of a joint is taken out or put back.
struct SetEquationPresent {
    int joint = 0;
    EquationOut equation;
    bool present = false;
};

/// Points and vectors of a joint; directions of any length except zero.
struct SetGeometry {
    int joint = 0;
    JointGeometry geometry;
};

struct SetDriver {
    int driver = 0;
    TimeFunction function;
};

/// Start estimate of a body, for example where a hand has led it.
struct SetPose {
    int body = 0;
    Vec3 r = Vec3::Zero();   ///< [m]
    Vec4 p = Vec4::Unit(0);  ///< of length 1, up to the typed digits
};

/// A point of a body is pulled towards a place; the equations assembled so far hold.
struct Drag {
    int body = 0;
    Vec3 point_local = Vec3::Zero();  ///< [m]
    Vec3 target = Vec3::Zero();       ///< global [m]
};

/// The hand lets go: the pose becomes the start estimate.
struct Release {};

/// A free motion is followed: its number in the rank report, and how far from the pose where it starts, as a
/// fraction from -1 to 1 of the followed motion.
struct ShowFreedom {
    int motion = 0;
    double part = 0.0;
};

/// Back to the step of the story, without the pose that a hand or a free motion led to.
struct LetGo {};

struct Undo {};
struct Redo {};
/// Back to the lesson as it was written.
struct StartOver {};

using Experiment = std::variant<
    GoTo, SetParallelForm, SetScrewAngleForm, SetCoordinates, SetPresent, SetEquationPresent, SetGeometry,
    SetDriver, SetPose, Drag, Release, ShowFreedom, LetGo, Undo, Redo, StartOver>;

/// Experiments that change the lesson itself; the others look at it, move it or go through its history.
using LessonEdit = std::variant<
    SetParallelForm, SetScrewAngleForm, SetCoordinates, SetPresent, SetEquationPresent, SetGeometry,
    SetDriver, SetPose>;

template <class E>
concept EditsLesson = kIsAlternative<E, LessonEdit>;

/// `geometry` with another axis in body i (or j): the vectors perpendicular to it turn with it.
/// @param s_local  any length except zero
JointGeometry with_axis(const JointGeometry& geometry, bool in_body_j, const Vec3& s_local);

/// The changed lesson and what was changed in words, or why that is not possible.
struct Edit {
    std::optional<Lesson> lesson;
    std::string what;  ///< "A keeps all three", or the reason
};

/// Applies an experiment to a copy of a lesson.
/// @param written  the lesson as its author wrote it: it tells where parts are put back
Edit edited(const Lesson& lesson, const Lesson& written, const Experiment& experiment);
/// Applies several experiments one after the other, all or none.
Edit edited(const Lesson& lesson, const Lesson& written, std::span<const Experiment> experiments);
/// The same without checking whether a lesson file can express the result.
Edit edit_of(Lesson lesson, const Lesson& written, const Experiment& experiment);

/// Edits that make the pose of `state`, including θ, the start estimate of a lesson.
std::vector<Experiment> moves_to(const State& state, const Lesson& lesson);

/// A lesson before and after edits.
struct LessonChange {
    const Lesson& written;  ///< where all edits begin
    const Lesson& before;
    const Lesson& now;
};

/// `edits` followed by `more`. An edit about the same thing as a later one is left out if the sentences of
/// the others lead to the same lesson with every number. Edits that change nothing are left out, too. If the
/// lesson is as it was written, the result is empty.
/// @param edits  lead from change.written to change.before
/// @param more   lead from there to change.now
std::vector<Experiment> tried_with(
    std::vector<Experiment> edits, std::span<const Experiment> more, const LessonChange& change);

/// Each of the edits as a sentence (experiment_text.hpp) about the lesson that the edits before it have made.
std::vector<std::string> sentences_of(std::span<const Experiment> edits, const Lesson& written);

}  // namespace jw
