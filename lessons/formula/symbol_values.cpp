#include "lessons/formula/symbol_values.hpp"

#include <random>

#include "core/quantity/names.hpp"
#include "lessons/formula/body_values.hpp"
#include "lessons/formula/joint_values.hpp"
#include "lessons/formula/system_values.hpp"

namespace jw::formula {

namespace {

std::optional<Value> value_of(const Subject& subject, const Instant& instant, const Symbol& symbol) {
    if (subject.joint >= 0) { return value_of_joint_symbol(instant, subject.joint, subject.role, symbol); }
    if (subject.body < 0) { return value_of_system_symbol(instant, subject.coordinates, symbol); }
    if (auto value = value_of_body_symbol(values_of_body(instant, subject.body), symbol)) { return value; }
    return value_of_mass_symbol(instant, subject.body, symbol);
}

std::optional<Value> value_of_quantity(const Instant& instant, const std::string& name) {
    const std::optional<ReadName> read = read_name(name, instant.system->mechanism());
    if (!read || read->wants_point) { return std::nullopt; }
    const QuantityValue v = evaluate(read->named.quantity, instant, read->named.derivative);
    const double value = v.derivatives[jw::at(read->named.derivative)];
    // a quantity without a value here, such as a reaction of a pose that is no motion, makes every claim fail
    Value number_value = number(value);
    number_value.order = 0;
    return number_value;
}

}  // namespace

Meanings meanings_of(const Subject& subject, const Instant& instant) {
    return {
        [subject, &instant](const Symbol& symbol) { return value_of(subject, instant, symbol); },
        [&instant](const std::string& name) { return value_of_quantity(instant, name); }};
}

Outcome evaluate_at(const Formula& formula, const Instant& instant) {
    std::vector<math::Row> where;
    for (const std::string& definition : formula.where) { where.push_back(math::read_math(definition).row); }
    return evaluate_equation(
        math::read_math(formula.source).row, where, meanings_of(formula.subject, instant));
}

Instant arbitrary_instant(std::shared_ptr<const System> system, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> any;
    const auto vector = [&] { return Vec3(any(random), any(random), any(random)); };
    Instant instant;
    instant.state = start_state(system->mechanism());
    instant.velocity = zero_motion(system->mechanism());
    instant.acceleration = instant.velocity;
    for (std::size_t b = 0; b < instant.state.r.size(); ++b) {
        instant.state.r[b] = vector();
        instant.state.p[b] = Vec4(any(random), any(random), any(random), any(random)).normalized();
        instant.velocity.r_dot[b] = vector();
        instant.velocity.omega_local[b] = vector();
        instant.acceleration->r_dot[b] = vector();
        instant.acceleration->omega_local[b] = vector();
    }
    for (std::size_t k = 0; k < instant.state.theta.size(); ++k) {
        instant.state.theta[k] = any(random);
        instant.velocity.theta_dot[k] = any(random);
        instant.acceleration->theta_dot[k] = any(random);
    }
    instant.system = std::move(system);
    return instant;
}

}  // namespace jw::formula
