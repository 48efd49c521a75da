#pragma once

#include <memory>

#include "app/host/lesson/address.hpp"
#include "app/session/try/session.hpp"

namespace jw::host {

/// Session, step and joint that an address leads to in a lesson.
struct Destination {
    std::unique_ptr<Session> session;  ///< in which the experiments were carried out, and can be undone
    int step = 0;                      ///< of its story
    int joint = -1;                    ///< that is asked for; -1: none
};

/// Carries out all that an address asks of its lesson.
/// @throws std::runtime_error saying what of it cannot be done, and why
Destination destination_of(
    const Lesson& lesson, const Address& address, const Storyteller& tell = tell_at_once);

/// The place in a story that an address asks for, and the joint.
/// @throws std::runtime_error
int step_of(const Address& address, const Story& story);
int joint_of(const Address& address, const Lesson& lesson);

}  // namespace jw::host
