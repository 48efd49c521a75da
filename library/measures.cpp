#include "jointwise/measures.hpp"

#include <algorithm>

#include "core/kinematics/joint_angles.hpp"
#include "core/motion/spring_turns.hpp"
#include "core/quantity/evaluate.hpp"
#include "core/quantity/names.hpp"
#include "library/convert.hpp"
#include "library/inside.hpp"

namespace jointwise {
inline namespace JOINTWISE_ABI {

namespace {

jw::NamedQuantity quantity_named(const std::string& name, const jw::Mechanism& mechanism) {
    const std::optional<jw::ReadName> read = jw::read_name(name, mechanism);
    if (!read) {
        throw std::invalid_argument(
            "jointwise: there is no quantity '" + name + "'; quantity_names() lists those of a mechanism");
    }
    if (read->wants_point) {
        throw std::invalid_argument(
            "jointwise: '" + name + "' leaves its point open; expected it in the body's frame, in m, like " +
            std::string(jw::owner_in(name)) + ".point[0.5 0 0].x");
    }
    return read->named;
}

std::string unit_of(const jw::NamedQuantity& named) {
    const jw::UnitRate dimension = jw::dimension_of(named.quantity);
    const std::string per(jw::per_seconds(dimension.per_s + named.derivative));
    const std::string symbol(jw::symbol_of(dimension.unit));
    return (symbol.empty() ? "1" : symbol) + per;
}

/// Masses and forces, if every moving body has a mass; otherwise nothing.
std::shared_ptr<jw::Centroidal> scene_of(const Mechanism::Inside& inside) {
    for (std::size_t b = 0; b < inside.mechanism.bodies.size(); ++b) {
        if (!inside.mechanism.bodies[b].fixed && !inside.loads.masses[b]) { return nullptr; }
    }
    return std::make_shared<jw::Centroidal>(jw::centroidal(inside.mechanism, inside.loads));
}

jw::Instant instant_of(const jw::Mechanism& mechanism, const Moment& moment) {
    jw::Instant instant;
    instant.t = moment.pose.t;
    instant.state = state_of(mechanism, moment.pose);
    instant.velocity = motion_of(mechanism, moment.velocity);
    instant.acceleration = motion_of(mechanism, moment.acceleration);
    return instant;
}

Reaction reaction_of(const jw::Mechanism& mechanism, const jw::Reaction& found) {
    Reaction reaction;
    reaction.of_driver = found.driver >= 0;
    reaction.name = reaction.of_driver ? mechanism.drivers[static_cast<std::size_t>(found.driver)].name
                                       : mechanism.joints[static_cast<std::size_t>(found.joint)].name;
    reaction.body_i = found.body_i;
    reaction.body_j = found.body_j;
    reaction.point = found.point;
    reaction.force = found.wrench.force;
    reaction.torque = found.wrench.torque;
    reaction.force_unique = found.force_unique_global;
    reaction.torque_unique = found.torque_unique_global;
    reaction.effort = found.effort;
    return reaction;
}

}  // namespace

struct Quantities::Inside {
    explicit Inside(const Mechanism& of)
        : mechanism(of), system(data(), jw::everything(data())), scene(scene_of(of.inside())) {}

    const jw::Mechanism& data() const { return mechanism.inside().mechanism; }

    /// @param values  [names]
    void evaluate(jw::Instant instant, const std::shared_ptr<const jw::Centroidal>& now, double* values) {
        system.choose_rows(instant.state);
        // the system is not used any more after this returns
        instant.system = {std::shared_ptr<const void>(), &system};
        instant.scene = now;
        for (const jw::NamedQuantity& q : list) {
            *values++ = jw::evaluate(q.quantity, instant, q.derivative)
                            .derivatives[static_cast<std::size_t>(q.derivative)];
        }
    }

    Mechanism mechanism;
    jw::System system;
    std::shared_ptr<const jw::Centroidal> scene;
    std::vector<jw::NamedQuantity> list;
    std::vector<std::string> names;
    std::vector<std::string> units;
};

std::vector<std::string> quantity_names(const Mechanism& mechanism) {
    const jw::Mechanism& inside = mechanism.inside().mechanism;
    std::vector<std::string> names;
    for (const jw::NamedQuantity& q : jw::quantities_of(inside)) {
        names.push_back(jw::name_of(q.quantity, q.derivative, inside));
    }
    return names;
}

Quantities::Quantities(const Mechanism& mechanism, const std::vector<std::string>& names)
    : inside_(std::make_unique<Inside>(mechanism)) {
    for (const std::string& name : names) {
        const jw::NamedQuantity named = quantity_named(name, inside_->data());
        inside_->list.push_back(named);
        inside_->names.push_back(jw::name_of(named.quantity, named.derivative, inside_->data()));
        inside_->units.push_back(unit_of(named));
    }
}
Quantities::~Quantities() = default;
Quantities::Quantities(Quantities&&) noexcept = default;
Quantities& Quantities::operator=(Quantities&&) noexcept = default;

const std::vector<std::string>& Quantities::names() const { return inside_->names; }
const std::vector<std::string>& Quantities::units() const { return inside_->units; }

Eigen::VectorXd Quantities::at(const Moment& moment) const {
    Eigen::VectorXd values(static_cast<Eigen::Index>(inside_->list.size()));
    inside_->evaluate(instant_of(inside_->data(), moment), inside_->scene, values.data());
    return values;
}

Table Quantities::along(const Trajectory& trajectory) const {
    Table table(trajectory.times(), static_cast<Eigen::Index>(inside_->list.size()));
    jw::FollowedAngles angles(inside_->data());
    std::optional<jw::SpringTurns> springs;
    for (int k = 0; k < trajectory.times(); ++k) {
        jw::Instant instant = instant_of(inside_->data(), trajectory.moment(k));
        const bool begins = k == 0;
        if (begins) { angles.begin(instant.t, instant.state, instant.velocity, *instant.acceleration); }
        if (!begins) { angles.reach(instant.t, instant.state, instant.velocity, *instant.acceleration); }
        instant.turns = angles.turns();
        if (begins) { springs.emplace(inside_->scene, instant.state, instant.turns); }
        const auto scene = springs->at(instant.state, instant.turns);
        inside_->evaluate(std::move(instant), scene, table.row(k).data());
    }
    return table;
}

Reactions reactions_at(const Mechanism& mechanism, const Moment& moment) {
    const auto& [inside, loads] = mechanism.inside();
    jw::Instant instant = instant_of(inside, moment);
    instant.scene = std::make_shared<const jw::Centroidal>(jw::centroidal(inside, loads));
    const jw::Reactions& found = instant.reactions();
    Reactions reactions;
    for (const jw::Reaction& reaction : found.reactions) {
        reactions.reactions.push_back(reaction_of(inside, reaction));
    }
    reactions.open = static_cast<int>(found.family.size());
    reactions.residual = found.residual;
    reactions.bound = found.bound;
    return reactions;
}

}  // namespace JOINTWISE_ABI
}  // namespace jointwise
