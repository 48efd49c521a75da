#include <algorithm>
#include <cmath>

#include "core/jets/euler_parameters.hpp"
#include "core/motion/forces.hpp"
#include "core/quantity/names.hpp"
#include "lessons/read/reading.hpp"
#include "lessons/read/scalar_formula.hpp"

namespace jw::reading {

namespace {

using Measuring = std::optional<std::variant<RotationalSpring, Spring>>;

/// Global coordinate of a point: its displacement against a fixed body, if there is one.
Measuring coordinate_of_point(int body, const Vec3& s_local, int component, const Mechanism& mechanism) {
    const auto fixed = std::ranges::find_if(mechanism.bodies, &Body::fixed);
    if (fixed == mechanism.bodies.end()) { return std::nullopt; }
    const Mat3 to_local = homogeneous_rotation_matrix(fixed->p).transpose();
    Spring spring;
    spring.body_i = static_cast<int>(fixed - mechanism.bodies.begin());
    spring.body_j = body;
    spring.P_i_local = -(to_local * fixed->r);
    spring.P_j_local = s_local;
    spring.s_i_local = to_local.col(component);
    return spring;
}

/// Spring without constants that measures a quantity; nothing for quantities that poses do not determine.
Measuring measuring(const Quantity& quantity, const Mechanism& mechanism) {
    if (const auto* point = std::get_if<PointQuantity>(&quantity)) {
        return coordinate_of_point(point->body, point->s_local, point->component, mechanism);
    }
    const auto* q = std::get_if<MeasureQuantity>(&quantity);
    if (q == nullptr) { return std::nullopt; }
    Spring spring;
    spring.body_i = q->body_i;
    spring.body_j = q->body_j;
    return std::visit(
        Overloaded{
            [&](const AngleMeasure& angle) -> Measuring {
                return RotationalSpring{q->body_i, q->body_j, angle};
            },
            [&](const ThetaMeasure&) -> Measuring {
                const Joint& joint = mechanism.joints[jw::at(q->joint)];
                if (!joint.type->has_angle()) { return std::nullopt; }
                return RotationalSpring{q->body_i, q->body_j, angle_of(joint)};
            },
            [&](const DisplacementMeasure& d) -> Measuring {
                spring.P_i_local = d.B_i_local;
                spring.P_j_local = d.B_j_local;
                spring.s_i_local = d.s_i_local;
                return spring;
            },
            [&](const SquaredDistanceMeasure& d) -> Measuring {
                spring.P_i_local = d.P_i_local;
                spring.P_j_local = d.P_j_local;
                return spring;
            },
            [&](const CoordinateMeasure& c) -> Measuring {
                if (c.coordinate >= 3) { return std::nullopt; }
                return coordinate_of_point(q->body_j, Vec3::Zero(), c.coordinate, mechanism);
            },
        },
        q->measure);
}

/// Reads the quantities of a law and gives them indices.
class QuantitiesOfLaw {
public:
    explicit QuantitiesOfLaw(const Reading& reading) : reading_(&reading) {}

    /// Index of the variable with that name; nothing if it is not a quantity.
    std::optional<int> index_of(const std::string& name) {
        const auto named = reading_->names.find(owner_in(name));
        if (named != reading_->names.end() && !named->second.sound) {
            is_sound_ = false;
            return LoadLaw::index_of_time;
        }
        const Mechanism& mechanism = reading_->lesson.mechanism;
        const std::optional<ReadName> read = read_name(name, mechanism);
        if (!read || read->wants_point) { return std::nullopt; }
        const auto& [quantity, derivative] = read->named;
        const Measuring measured = measuring(quantity, mechanism);
        if (!measured || derivative > 1) {
            throw formula::Mismatch(
                "a load cannot depend on '" + name +
                "'; expected an angle, a displacement, a distance, a coordinate, or the rate of one");
        }
        const std::string own = name_of(quantity, 0, mechanism);
        const auto found = std::ranges::find(all_, own, &LoadLaw::Quantity::name);
        const auto k = static_cast<std::size_t>(found - all_.begin());
        if (k == LoadLaw::kMostQuantities) {
            throw formula::Mismatch(
                "the law contains more than " + std::to_string(LoadLaw::kMostQuantities) + " quantities");
        }
        if (k == all_.size()) { all_.push_back({own, *measured}); }
        return LoadLaw::index_of(k, derivative);
    }

    bool is_sound() const { return is_sound_; }
    const std::vector<LoadLaw::Quantity>& all() const { return all_; }

private:
    const Reading* reading_;
    std::vector<LoadLaw::Quantity> all_;
    bool is_sound_ = true;  ///< false after a joint that has been reported
};

/// Reports a law without a value at the start. Rates may differ from 0 there, and so may the pose if drivers
/// or start values place joints.
void check_start(Fields& fields, const Reading& reading, const LoadLaw& law) {
    if (reading.problems->errors_count() > 0) { return; }
    if (!reading.start_values.empty() || !reading.lesson.mechanism.drivers.empty()) { return; }
    for (std::size_t k = 0; k < law.quantities.size(); ++k) {
        if (law.formula.uses(LoadLaw::index_of(k, 1))) { return; }
    }
    const auto bodies = kinematics_of(start_state(reading.lesson.mechanism));
    if (std::isfinite(value_of(law, bodies, 0.0))) { return; }
    fields.report(
        Code::formula_without_value, fields.span("law"),
        "the law has no value at the start; expected one that has a value wherever the mechanism moves");
}

}  // namespace

std::optional<LoadLaw> read_load_law(Fields& fields, const Reading& reading) {
    QuantitiesOfLaw quantities(reading);
    const auto read = [&](const std::string& source) {
        return formula::scalar_formula(
            source, formula::time_only(), [&](const std::string& name) { return quantities.index_of(name); });
    };
    auto formula = read_formula(
        fields, "law", read,
        "numbers, the time t, in s, and quantities such as \\text{hinge.angle} and \\text{hinge.angle_dot}");
    if (!formula || !quantities.is_sound()) { return std::nullopt; }
    LoadLaw law{std::move(*formula), quantities.all()};
    for (std::size_t k = 0; k < law.quantities.size(); ++k) {
        auto* angle = std::get_if<RotationalSpring>(&law.quantities[k].measured);
        if (angle != nullptr) { angle->is_read = law.formula.uses(LoadLaw::index_of(k, 0)); }
    }
    check_start(fields, reading, law);
    return law;
}

}  // namespace jw::reading
