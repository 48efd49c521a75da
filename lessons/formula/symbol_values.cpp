#include "lessons/formula/symbol_values.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <utility>

#include "core/elementary/elementary.hpp"
#include "core/quantity/names.hpp"
#include "lessons/formula/part_values.hpp"

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
    // a quantity without a value here, such as a reaction in a pose that is not part of a motion, fails all
    // claims
    Value number_value = number(value);
    number_value.order = 0;
    return number_value;
}

/// Normally distributed numbers by Marsaglia's polar method. std::normal_distribution differs between
/// standard libraries; this class computes as GCC's does.
class NormalNumbers {
public:
    explicit NormalNumbers(unsigned seed) : random_(seed) {}

    double number() {
        if (const auto second = std::exchange(second_, std::nullopt)) { return *second; }
        double x = 0.0;
        double y = 0.0;
        double square = 0.0;
        do {
            x = within_one();
            y = within_one();
            square = x * x + y * y;
        } while (square > 1.0 || square == 0.0);
        const double factor = std::sqrt(-2.0 * elementary::log(square) / square);
        second_ = x * factor;
        return y * factor;
    }
    /// A vector of such numbers; its last component is drawn first.
    template <int Dim>
    Eigen::Matrix<double, Dim, 1> vector() {
        Eigen::Matrix<double, Dim, 1> v;
        for (int k = Dim; k-- > 0;) { v(k) = number(); }
        return v;
    }

private:
    /// Uniform number of 64 bits, from -1 to 1.
    double within_one() {
        const auto low = static_cast<double>(random_());
        const double unit = (low + static_cast<double>(random_()) * 0x1p32) * 0x1p-64;
        return 2.0 * std::min(unit, 1.0 - 0x1p-53) - 1.0;
    }

    std::mt19937 random_;
    std::optional<double> second_;
};

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
    NormalNumbers any(seed);
    const auto vector = [&] { return any.vector<3>(); };
    Instant instant;
    instant.state = start_state(system->mechanism());
    instant.velocity = zero_motion(system->mechanism());
    instant.acceleration = instant.velocity;
    for (std::size_t b = 0; b < instant.state.r.size(); ++b) {
        instant.state.r[b] = vector();
        instant.state.p[b] = any.vector<4>().normalized();
        instant.velocity.r_dot[b] = vector();
        instant.velocity.omega_local[b] = vector();
        instant.acceleration->r_dot[b] = vector();
        instant.acceleration->omega_local[b] = vector();
    }
    for (std::size_t k = 0; k < instant.state.theta.size(); ++k) {
        instant.state.theta[k] = any.number();
        instant.velocity.theta_dot[k] = any.number();
        instant.acceleration->theta_dot[k] = any.number();
    }
    instant.system = std::move(system);
    return instant;
}

}  // namespace jw::formula
