#pragma once

#include <memory>

#include "app/host/lesson/address.hpp"
#include "app/session/try/session.hpp"

namespace jw::host {

/// Session, step and joint that an address leads to in a lesson.
struct Destination {
    std::unique_ptr<Session> session;  ///< with the experiments carried out; they can be undone
    int step = 0;                      ///< of its story
    int joint = -1;                    ///< that the address names; -1: none
};

/// Carries out everything that an address asks of its lesson.
/// @throws std::runtime_error that says what cannot be done, and why
Destination destination_of(
    const Lesson& lesson, const Address& address, const Storyteller& tell = tell_at_once);

/// The step of a story, and the joint, that an address names.
/// @throws std::runtime_error
int step_of(const Address& address, const Story& story);
int joint_of(const Address& address, const Lesson& lesson);

}  // namespace jw::host
