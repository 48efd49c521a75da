#include "app/host/lesson/destination.hpp"

#include <algorithm>
#include <stdexcept>

#include "app/session/story/timeline.hpp"
#include "app/session/try/carry_out.hpp"
#include "app/session/try/experiment_text.hpp"
#include "lessons/diagnostics/diagnostics.hpp"

namespace jw::host {

int step_of(const Address& address, const Story& story) {
    if (address.at.empty()) { return 0; }
    if (const std::optional<int> step = step_at(story, address.at)) { return *step; }
    throw std::runtime_error(
        "no place " + in_quotes(address.at) + " in the lesson; expected a step from 1 to " +
        std::to_string(last_step(story) + 1) + ", a joint or driver of it, or t=SECONDS");
}

int joint_of(const Address& address, const Lesson& lesson) {
    if (address.joint.empty()) { return -1; }
    const std::vector<std::string> names = experiment_text::names_of_joints(lesson);
    const auto found = std::ranges::find(names, address.joint);
    if (found != names.end()) { return static_cast<int>(found - names.begin()); }
    throw std::runtime_error(
        "no joint " + in_quotes(address.joint) + "; expected one of " + comma_list(names));
}

Destination destination_of(const Lesson& lesson, const Address& address, const Storyteller& tell) {
    Destination destination;
    destination.session = session_after(lesson, address.experiments, tell);
    // the step to which the experiments have led, unless the address names a place
    destination.step =
        address.at.empty() ? destination.session->index() : step_of(address, destination.session->story());
    destination.joint = joint_of(address, lesson);
    return destination;
}

}  // namespace jw::host
