#include "core/kinematics/paths/free_proof.hpp"

#include <algorithm>
#include <vector>

#include "core/kinematics/proof/parts.hpp"

namespace jw {

namespace {

constexpr int kColumnsOfBody = 7;  // r and p
// limit of columns cubed: a few hundredths of a second
constexpr double kMostWork = 1e8;
// enough for a whole pull if proofs are easy; a fold with a margin of 1e-9 takes a few movements
constexpr double kFewestSteps = 5.0;
constexpr double kMostSteps = 60.0;

/// Index of a body in a list whose first entry stands for all fixed bodies.
std::size_t index_of(const Mechanism& mechanism, int body) {
    return mechanism.bodies[at(body)].fixed ? 0 : at(body) + 1;
}

/// Number of joints and drivers of each body, by index_of.
std::vector<int> count_of_links(const Mechanism& mechanism, const Selection& selection) {
    std::vector<int> links(mechanism.bodies.size() + 1, 0);
    const auto count = [&](int body) { ++links[index_of(mechanism, body)]; };
    for (const int k : selection.joints) {
        count(mechanism.joints[at(k)].body_i);
        count(mechanism.joints[at(k)].body_j);
    }
    for (const int k : selection.drivers) {
        count(mechanism.drivers[at(k)].body_i);
        count(mechanism.drivers[at(k)].body_j);
    }
    return links;
}

/// Joints and drivers in and between the loops of a selection: those that remain when each link that is the
/// only one of a body is removed, repeatedly.
Selection in_loops(const Mechanism& mechanism, Selection selection) {
    for (std::size_t taken = 1; taken > 0;) {
        const std::vector<int> links = count_of_links(mechanism, selection);
        const auto hangs = [&](int body) { return links[index_of(mechanism, body)] == 1; };
        const auto is_alone = [&](const auto& link) { return hangs(link.body_i) || hangs(link.body_j); };
        taken = std::erase_if(selection.joints, [&](int k) { return is_alone(mechanism.joints[at(k)]); }) +
                std::erase_if(selection.drivers, [&](int k) { return is_alone(mechanism.drivers[at(k)]); });
    }
    return selection;
}

System with_rows_of(const System& other, System system) {
    system.inherit_rows(other);
    return system;
}

}  // namespace

Mechanism at_rest(Mechanism mechanism, double t) {
    for (Driver& driver : mechanism.drivers) {
        driver.function = TimeFunction{.polynomial = {driver.function.at(t).f}};
    }
    return mechanism;
}

std::unique_ptr<FreeProof> FreeProof::of(const System& system, double t) {
    Mechanism still = at_rest(system.mechanism(), t);
    const Selection loops = in_loops(still, system.selection());
    if (loops.joints.empty() && loops.drivers.empty()) { return nullptr; }
    // the equations do not contain bodies outside of loops
    const std::vector<int> links = count_of_links(still, loops);
    int columns = 0;
    for (std::size_t b = 0; b < still.bodies.size(); ++b) {
        still.bodies[b].fixed = links[b + 1] == 0;
        columns += still.bodies[b].fixed ? 0 : kColumnsOfBody;
    }
    if (columns > kMostProvedColumns) { return nullptr; }
    return std::make_unique<FreeProof>(std::move(still), loops, system);
}

FreeProof::FreeProof(Mechanism still, const Selection& loops, const System& rows)
    : still_(std::move(still)),
      system_(with_rows_of(rows, System(still_, loops))),
      proof_(system_, StepProof::LeftFree::kept) {}

bool FreeProof::holds(
    const State& from, const Motion& velocity, const State& to, const Motion& velocity_there, double length) {
    if (!proof_.holds({length_, &from, &velocity}, {length_ + length, &to, &velocity_there})) {
        return false;
    }
    length_ += length;
    return true;
}

int FreeProof::most_steps() const {
    const double columns = kColumnsOfBody * static_cast<double>(system_.moving_bodies().size());
    return static_cast<int>(std::clamp(kMostWork / (columns * columns * columns), kFewestSteps, kMostSteps));
}

bool FreeProof::decides_at(const State& state, const Motion& velocity) {
    return proof_.decides_at({0.0, &state, &velocity});
}

}  // namespace jw
