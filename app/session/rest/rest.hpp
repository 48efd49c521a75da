#pragma once

#include <complex>
#include <memory>
#include <string>
#include <vector>

#include "core/quantity/evaluate.hpp"
#include "core/quantity/names.hpp"
#include "core/statics/equilibrium.hpp"
#include "lessons/lesson/lesson.hpp"

/// A lesson of dynamics at rest: the equilibrium to which its forces lead, the reactions there, and the small
/// motions about it.
namespace jw {

class StoryTelling;

struct RestRequest {
    Seek seek = Seek::where_it_rests;
    std::vector<std::string> held;  ///< joints whose angle or displacement stays what it is at the start
};

/// Movement of an angle or a displacement of a joint in a small motion, or the rotation of a body on a ball.
struct ModeOfJoint {
    NamedQuantity quantity;          ///< as a rate
    std::complex<double> amplitude;  ///< where that of the first joint is 1 [rad, m]
};

struct RestView {
    std::shared_ptr<const Mechanism> mechanism;  ///< with a driver for each joint that is held
    Seek seek = Seek::where_it_rests;
    RestOutcome outcome;
    Instant instant;                        ///< the pose that was reached, at rest, in the frames as given
    std::vector<NamedQuantity> quantities;  ///< of joints, drivers and energy
    std::vector<std::vector<ModeOfJoint>> modes;  ///< one per mode of the outcome
    bool without_friction = false;                ///< dry friction of the lesson is left out
    std::string failure;                          ///< why no equilibrium was found; empty if one was
};

/// Assembles the lesson and finds its equilibrium. Drivers and loads are those of t = 0.
/// @throws std::invalid_argument if the lesson has no [dynamics], or if a joint that is held does not exist,
///         is driven, has no coordinate, or has several and none of them is named
/// @throws PoseNotReached if the lesson cannot be assembled
RestView find_rest(const Lesson& lesson, const RestRequest& request);

/// find_rest in pieces, for callers that do other work in between.
class RestSearch {
public:
    /// @param lesson  with [dynamics]; must outlive the search
    RestSearch(const Lesson& lesson, RestRequest request);
    ~RestSearch();

    /// Does the next piece: assembles a joint, or takes a step of the search. @throws as find_rest
    /// @return false if the search has ended
    bool go_on();
    /// Result of a search that has ended; call it once.
    RestView view();

private:
    void begin_search();

    const Lesson* lesson_;
    RestRequest request_;
    std::unique_ptr<StoryTelling> telling_;  ///< of the assembly
    RestView view_;
    std::shared_ptr<const Centroidal> scene_;
    std::unique_ptr<EquilibriumSearch> search_;  ///< once the mechanism is assembled
};

/// Stable, unstable or not known, in one sentence.
std::string stability_text(const RestOutcome& outcome);

}  // namespace jw
