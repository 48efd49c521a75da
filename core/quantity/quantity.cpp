#include "core/quantity/quantity.hpp"

namespace jw {

namespace {

struct UnitOfMeasure {
    Unit operator()(const AngleMeasure& /*m*/) const { return Unit::radian; }
    Unit operator()(const ThetaMeasure& /*m*/) const { return Unit::radian; }
    Unit operator()(const DisplacementMeasure& /*m*/) const { return Unit::metre; }
    Unit operator()(const SquaredDistanceMeasure& /*m*/) const { return Unit::metre; }
    Unit operator()(const CoordinateMeasure& m) const { return m.coordinate < 3 ? Unit::metre : Unit::none; }
};

UnitRate dimension_of_vector(BodyVector vector) {
    switch (vector) {
        case BodyVector::r: return {Unit::metre, 0};
        case BodyVector::r_dot: return {Unit::metre, 1};
        case BodyVector::r_ddot: return {Unit::metre, 2};
        case BodyVector::omega: return {Unit::radian, 1};
        case BodyVector::omega_dot: break;
    }
    return {Unit::radian, 2};
}

int derivatives_of_vector(BodyVector vector) {
    switch (vector) {
        case BodyVector::r: return 2;
        case BodyVector::r_dot:
        case BodyVector::omega: return 1;
        case BodyVector::r_ddot:
        case BodyVector::omega_dot: break;
    }
    return 0;
}

struct DimensionOf {
    UnitRate operator()(const MeasureQuantity& q) const { return {unit_of(q.measure), 0}; }
    UnitRate operator()(const AngularVelocityQuantity& /*q*/) const { return {Unit::radian, 1}; }
    UnitRate operator()(const PointQuantity& /*q*/) const { return {Unit::metre, 0}; }
    UnitRate operator()(const PointSpeedQuantity& /*q*/) const { return {Unit::metre, 1}; }
    UnitRate operator()(const BodySizeQuantity& q) const { return dimension_of_vector(q.vector); }
    UnitRate operator()(const DirectionsQuantity& /*q*/) const { return {Unit::radian, 0}; }
    UnitRate operator()(const EnergyQuantity& /*q*/) const { return {Unit::joule, 0}; }
    UnitRate operator()(const ReactionQuantity& q) const {
        return {q.part == WrenchPart::force ? Unit::newton : Unit::newton_metre, 0};
    }
    UnitRate operator()(const EffortQuantity& q) const {
        return {q.is_torque ? Unit::newton_metre : Unit::newton, 0};
    }
    UnitRate operator()(const ParameterErrorQuantity& /*q*/) const { return {}; }
    UnitRate operator()(const ResidualQuantity& /*q*/) const { return {}; }
    UnitRate operator()(const SingularValueQuantity& /*q*/) const { return {}; }
    UnitRate operator()(const PairConditionQuantity& /*q*/) const { return {}; }
};

struct DerivativesOf {
    int operator()(const MeasureQuantity& /*q*/) const { return 2; }
    int operator()(const AngularVelocityQuantity& /*q*/) const { return 1; }
    int operator()(const PointQuantity& /*q*/) const { return 2; }
    int operator()(const PointSpeedQuantity& /*q*/) const { return 1; }
    int operator()(const BodySizeQuantity& q) const { return derivatives_of_vector(q.vector); }
    int operator()(const DirectionsQuantity& /*q*/) const { return 2; }
    int operator()(const EnergyQuantity& /*q*/) const { return 1; }
    int operator()(const ReactionQuantity& /*q*/) const { return 0; }
    int operator()(const EffortQuantity& /*q*/) const { return 0; }
    int operator()(const ParameterErrorQuantity& /*q*/) const { return 0; }
    int operator()(const ResidualQuantity& /*q*/) const { return 2; }
    int operator()(const SingularValueQuantity& /*q*/) const { return 0; }
    int operator()(const PairConditionQuantity& /*q*/) const { return 0; }
};

struct NeedsMasses {
    bool operator()(const MeasureQuantity& /*q*/) const { return false; }
    bool operator()(const AngularVelocityQuantity& /*q*/) const { return false; }
    bool operator()(const PointQuantity& /*q*/) const { return false; }
    bool operator()(const PointSpeedQuantity& /*q*/) const { return false; }
    bool operator()(const BodySizeQuantity& /*q*/) const { return false; }
    bool operator()(const DirectionsQuantity& /*q*/) const { return false; }
    bool operator()(const EnergyQuantity& /*q*/) const { return true; }
    bool operator()(const ReactionQuantity& /*q*/) const { return true; }
    bool operator()(const EffortQuantity& /*q*/) const { return true; }
    bool operator()(const ParameterErrorQuantity& /*q*/) const { return false; }
    bool operator()(const ResidualQuantity& /*q*/) const { return false; }
    bool operator()(const SingularValueQuantity& /*q*/) const { return false; }
    bool operator()(const PairConditionQuantity& /*q*/) const { return false; }
};

}  // namespace

Unit unit_of(const Measure& measure) { return std::visit(UnitOfMeasure{}, measure); }

UnitRate dimension_of(const Quantity& quantity) { return std::visit(DimensionOf{}, quantity); }

int derivatives_of(const Quantity& quantity) { return std::visit(DerivativesOf{}, quantity); }

bool is_modulo_turn(const Quantity& quantity) {
    const auto* m = std::get_if<MeasureQuantity>(&quantity);
    return m != nullptr && std::holds_alternative<AngleMeasure>(m->measure);
}

bool needs_masses(const Quantity& quantity) { return std::visit(NeedsMasses{}, quantity); }

int joint_of(const Quantity& quantity) {
    // a quantity that belongs to a joint has the joint's index as a member
    return std::visit(
        [](const auto& q) {
            if constexpr (requires { q.joint; }) {
                return q.joint;
            } else {
                return -1;
            }
        },
        quantity);
}

int driver_of(const Quantity& quantity) {
    return std::visit(
        [](const auto& q) {
            if constexpr (requires { q.driver; }) {
                return q.driver;
            } else {
                return -1;
            }
        },
        quantity);
}

}  // namespace jw
