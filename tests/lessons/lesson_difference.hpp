#pragma once

#include <array>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "lessons/lesson/lesson.hpp"

/// Lessons compared member by member.
namespace jw::test {

/// Finds the first member in which two values differ. Doubles are compared exactly. The place of a claim in
/// the file and the name of the file are not part of a lesson.
class Difference {
public:
    /// "mechanism.joints[2].geometry.s_i_local: 0 0 1 is not 0 0 2", empty if there is none.
    const std::string& first() const { return first_; }

    void compare(const std::string& name, const Lesson& a, const Lesson& b) {
        all(name, a, b, &Lesson::title, "title", &Lesson::chapter, "chapter", &Lesson::source, "source",
            &Lesson::text, "text", &Lesson::mechanism, "mechanism", &Lesson::looks, "looks", &Lesson::order,
            "order", &Lesson::coordinates, "coordinates", &Lesson::motion, "motion", &Lesson::dynamics,
            "dynamics", &Lesson::camera, "camera", &Lesson::step_texts, "step_texts", &Lesson::claims,
            "claims", &Lesson::summary, "summary", &Lesson::questions, "questions", &Lesson::trials,
            "trials");
    }
    void compare(const std::string& name, const Mechanism& a, const Mechanism& b) {
        all(name, a, b, &Mechanism::bodies, "bodies", &Mechanism::joints, "joints", &Mechanism::drivers,
            "drivers");
    }
    void compare(const std::string& name, const Body& a, const Body& b) {
        all(name, a, b, &Body::name, "name", &Body::fixed, "fixed", &Body::r, "r", &Body::p, "p",
            &Body::r_dot, "r_dot", &Body::omega_local, "omega_local");
    }
    void compare(const std::string& name, const Joint& a, const Joint& b) {
        all(name, a, b, &Joint::name, "name", &Joint::type, "type", &Joint::body_i, "body_i", &Joint::body_j,
            "body_j", &Joint::geometry, "geometry", &Joint::parallel_form, "parallel_form", &Joint::without,
            "without");
    }
    void compare(const std::string& name, const EquationOut& a, const EquationOut& b) {
        all(name, a, b, &EquationOut::role, "role", &EquationOut::component, "component");
    }
    void compare(const std::string& name, const JointGeometry& a, const JointGeometry& b) {
        using G = JointGeometry;
        all(name, a, b, &G::P_i_local, "P_i", &G::P_j_local, "P_j", &G::s_i_local, "s_i", &G::s_j_local,
            "s_j", &G::h_i_local, "h_i", &G::h_j_local, "h_j", &G::u_i_local, "u_i", &G::u_j_local, "u_j");
        all(name, a, b, &G::length, "length", &G::formula, "formula", &G::alpha, "alpha", &G::d_0, "d_0",
            &G::theta_0, "theta_0", &G::curve, "curve", &G::ratio, "ratio", &G::radii, "radii",
            &G::screw_angle_form, "screw_angle_form", &G::theta_start, "theta_start", &G::theta_dot_start,
            "theta_dot_start", &G::angle_dot_start, "angle_dot_start", &G::displacement_dot_start,
            "displacement_dot_start");
    }
    void compare(const std::string& name, const Curve& a, const Curve& b) {
        all(name, a, b, &Curve::constant, "constant", &Curve::linear, "linear", &Curve::harmonics,
            "harmonics");
    }
    void compare(const std::string& name, const Curve::Harmonic& a, const Curve::Harmonic& b) {
        all(name, a, b, &Curve::Harmonic::cos, "cos", &Curve::Harmonic::sin, "sin");
    }
    void compare(const std::string& name, const Driver& a, const Driver& b) {
        all(name, a, b, &Driver::name, "name", &Driver::joint, "joint", &Driver::body_i, "body_i",
            &Driver::body_j, "body_j", &Driver::measure, "measure", &Driver::function, "function");
    }
    void compare(const std::string& name, const AngleMeasure& a, const AngleMeasure& b) {
        using M = AngleMeasure;
        all(name, a, b, &M::s_i_local, "s_i", &M::u_i_local, "u_i", &M::u_j_local, "u_j");
    }
    void compare(const std::string& name, const DisplacementMeasure& a, const DisplacementMeasure& b) {
        using M = DisplacementMeasure;
        all(name, a, b, &M::s_i_local, "s_i", &M::B_i_local, "B_i", &M::B_j_local, "B_j");
    }
    void compare(const std::string& name, const SquaredDistanceMeasure& a, const SquaredDistanceMeasure& b) {
        using M = SquaredDistanceMeasure;
        all(name, a, b, &M::P_i_local, "P_i", &M::P_j_local, "P_j");
    }
    void compare(const std::string& name, const CoordinateMeasure& a, const CoordinateMeasure& b) {
        compare(name, a.coordinate, b.coordinate);
    }
    void compare(const std::string& /*name*/, const ThetaMeasure& /*a*/, const ThetaMeasure& /*b*/) {}
    void compare(const std::string& name, const TimeFunction& a, const TimeFunction& b) {
        all(name, a, b, &TimeFunction::polynomial, "polynomial", &TimeFunction::harmonics, "harmonics",
            &TimeFunction::steps, "steps", &TimeFunction::table, "table", &TimeFunction::formula, "formula");
    }
    void compare(const std::string& name, const TimeFormula& a, const TimeFormula& b) {
        all(name, a, b, &TimeFormula::formula, "formula", &TimeFormula::unit, "unit");
    }
    void compare(const std::string& name, const ScalarFormula& a, const ScalarFormula& b) {
        compare(name, a.source, b.source);
    }
    void compare(const std::string& name, const DryFriction& a, const DryFriction& b) {
        all(name, a, b, &DryFriction::size, "size", &DryFriction::speed, "speed");
    }
    void compare(const std::string& name, const TimeTable& a, const TimeTable& b) {
        using T = TimeTable;
        all(name, a, b, &T::interpolation, "interpolation", &T::times, "times", &T::values, "values");
    }
    void compare(const std::string& name, const TimeFunction::Harmonic& a, const TimeFunction::Harmonic& b) {
        using H = TimeFunction::Harmonic;
        all(name, a, b, &H::amplitude, "amplitude", &H::omega, "omega", &H::phase, "phase");
    }
    void compare(
        const std::string& name, const TimeFunction::SmoothStep& a, const TimeFunction::SmoothStep& b) {
        using S = TimeFunction::SmoothStep;
        all(name, a, b, &S::from, "from", &S::to, "to", &S::start, "start", &S::end, "end");
    }
    void compare(const std::string& name, const Look& a, const Look& b) {
        all(name, a, b, &Look::shapes, "shapes", &Look::colour, "colour");
    }
    void compare(const std::string& name, const Colour& a, const Colour& b) {
        all(name, a, b, &Colour::red, "red", &Colour::green, "green", &Colour::blue, "blue");
    }
    void compare(const std::string& name, const Box& a, const Box& b) {
        all(name, a, b, &Box::size, "size", &Box::centre, "centre", &Box::axes, "axes");
    }
    void compare(const std::string& name, const Sphere& a, const Sphere& b) {
        all(name, a, b, &Sphere::centre, "centre", &Sphere::radius, "radius");
    }
    void compare(const std::string& name, const Cylinder& a, const Cylinder& b) {
        all(name, a, b, &Cylinder::from, "from", &Cylinder::to, "to", &Cylinder::radius, "radius");
    }
    void compare(const std::string& name, const Rod& a, const Rod& b) {
        all(name, a, b, &Rod::from, "from", &Rod::to, "to", &Rod::radius, "radius");
    }
    void compare(const std::string& name, const MotionPlan& a, const MotionPlan& b) {
        all(name, a, b, &MotionPlan::from, "from", &MotionPlan::to, "to", &MotionPlan::duration, "duration",
            &MotionPlan::steps, "steps");
    }
    void compare(const std::string& name, const DynamicsPlan& a, const DynamicsPlan& b) {
        using P = DynamicsPlan;
        all(name, a, b, &P::loads, "loads", &P::duration, "duration", &P::settings, "settings", &P::point,
            "point", &P::point_at_end, "point_at_end");
    }
    void compare(const std::string& name, const SimulationSettings& a, const SimulationSettings& b) {
        using S = SimulationSettings;
        all(name, a, b, &S::method, "method", &S::treatment, "treatment", &S::tolerance, "tolerance",
            &S::step, "step");
    }
    void compare(const std::string& name, const BodyPoint& a, const BodyPoint& b) {
        all(name, a, b, &BodyPoint::body, "body", &BodyPoint::point_local, "point_local");
    }
    void compare(const std::string& name, const Loads& a, const Loads& b) {
        all(name, a, b, &Loads::masses, "masses", &Loads::gravity, "gravity", &Loads::forces, "forces",
            &Loads::torques, "torques", &Loads::springs, "springs", &Loads::rotational_springs,
            "rotational_springs", &Loads::bushings, "bushings");
    }
    void compare(const std::string& name, const Bushing& a, const Bushing& b) {
        all(name, a, b, &Bushing::body_i, "body_i", &Bushing::body_j, "body_j", &Bushing::P_i_local, "P_i",
            &Bushing::P_j_local, "P_j", &Bushing::axes_i_local, "axes_i", &Bushing::axes_j_local, "axes_j",
            &Bushing::stiffness, "stiffness", &Bushing::damping, "damping", &Bushing::rotational_stiffness,
            "rotational_stiffness", &Bushing::rotational_damping, "rotational_damping");
    }
    void compare(const std::string& name, const MassProperties& a, const MassProperties& b) {
        using M = MassProperties;
        all(name, a, b, &M::mass, "mass", &M::centre_local, "centre_local", &M::J_local, "J_local");
    }
    void compare(const std::string& name, const AppliedForce& a, const AppliedForce& b) {
        using F = AppliedForce;
        all(name, a, b, &F::body, "body", &F::point_local, "point_local", &F::direction, "direction",
            &F::frame, "frame", &F::magnitude, "magnitude", &F::law, "law");
    }
    void compare(const std::string& name, const LoadLaw& a, const LoadLaw& b) {
        all(name, a, b, &LoadLaw::formula, "formula", &LoadLaw::quantities, "quantities");
    }
    void compare(const std::string& name, const LoadLaw::Quantity& a, const LoadLaw::Quantity& b) {
        all(name, a, b, &LoadLaw::Quantity::name, "name", &LoadLaw::Quantity::measured, "measured");
    }
    void compare(const std::string& name, const AppliedTorque& a, const AppliedTorque& b) {
        using T = AppliedTorque;
        all(name, a, b, &T::body, "body", &T::direction, "direction", &T::frame, "frame", &T::magnitude,
            "magnitude", &T::against, "against", &T::law, "law");
    }
    void compare(const std::string& name, const Spring& a, const Spring& b) {
        all(name, a, b, &Spring::body_i, "body_i", &Spring::body_j, "body_j", &Spring::P_i_local, "P_i",
            &Spring::P_j_local, "P_j", &Spring::stiffness, "stiffness", &Spring::free_length, "free_length",
            &Spring::damping, "damping", &Spring::s_i_local, "s_i", &Spring::friction, "friction",
            &Spring::law, "law");
    }
    void compare(const std::string& name, const RotationalSpring& a, const RotationalSpring& b) {
        using S = RotationalSpring;
        all(name, a, b, &S::body_i, "body_i", &S::body_j, "body_j", &S::angle, "angle", &S::stiffness,
            "stiffness", &S::free_angle, "free_angle", &S::damping, "damping", &S::friction, "friction",
            &S::law, "law");
    }
    void compare(const std::string& name, const CameraWish& a, const CameraWish& b) {
        all(name, a, b, &CameraWish::from, "from", &CameraWish::target, "target", &CameraWish::distance,
            "distance", &CameraWish::up, "up", &CameraWish::orthographic, "orthographic");
    }
    void compare(const std::string& name, const Addition& a, const Addition& b) {
        all(name, a, b, &Addition::kind, "kind", &Addition::index, "index");
    }
    void compare(const std::string& name, const StepTexts& a, const StepTexts& b) {
        all(name, a, b, &StepTexts::bodies, "bodies", &StepTexts::joints, "joints", &StepTexts::drivers,
            "drivers", &StepTexts::motion, "motion", &StepTexts::times, "times");
    }
    void compare(const std::string& name, const StepTexts::AtTime& a, const StepTexts::AtTime& b) {
        all(name, a, b, &StepTexts::AtTime::from, "from", &StepTexts::AtTime::text, "text");
    }
    void compare(const std::string& name, const Claim& a, const Claim& b) {
        all(name, a, b, &Claim::when, "when", &Claim::fact, "fact", &Claim::why, "why");
    }
    void compare(const std::string& /*name*/, const AsGiven& /*a*/, const AsGiven& /*b*/) {}
    void compare(const std::string& /*name*/, const AnyState& /*a*/, const AnyState& /*b*/) {}
    void compare(const std::string& /*name*/, const AtRest& /*a*/, const AtRest& /*b*/) {}
    void compare(const std::string& name, const FormulaClaim& a, const FormulaClaim& b) {
        all(name, a, b, &FormulaClaim::formula, "formula", &FormulaClaim::holds, "holds");
    }
    void compare(const std::string& name, const formula::Formula& a, const formula::Formula& b) {
        if (!(a == b)) { differ(name, a.source, b.source); }
    }
    void compare(const std::string& name, const Question& a, const Question& b) {
        all(name, a, b, &Question::place, "place", &Question::addition, "addition", &Question::ask, "ask",
            &Question::answer, "answer", &Question::why, "why");
    }
    void compare(const std::string& name, const CountAnswer& a, const CountAnswer& b) {
        all(name, a, b, &CountAnswer::count, "count");
    }
    void compare(const std::string& name, const DroppedAnswer& a, const DroppedAnswer& b) {
        all(name, a, b, &DroppedAnswer::joint, "joint", &DroppedAnswer::role, "role");
    }
    void compare(const std::string& name, const QuantityAnswer& a, const QuantityAnswer& b) {
        all(name, a, b, &QuantityAnswer::text, "text", &QuantityAnswer::derivative, "derivative",
            &QuantityAnswer::when, "when", &QuantityAnswer::in_degrees, "in_degrees",
            &QuantityAnswer::tolerance, "tolerance");
    }
    void compare(const std::string& name, const ChoiceAnswer& a, const ChoiceAnswer& b) {
        all(name, a, b, &ChoiceAnswer::choices, "choices", &ChoiceAnswer::right, "right");
    }
    void compare(const std::string& name, const PointedAnswer& a, const PointedAnswer& b) {
        all(name, a, b, &PointedAnswer::kind, "kind", &PointedAnswer::right, "right", &PointedAnswer::found,
            "found");
    }
    void compare(const std::string& name, const PoseAnswer& a, const PoseAnswer& b) {
        all(name, a, b, &PoseAnswer::body, "body", &PoseAnswer::when, "when", &PoseAnswer::tolerance_m,
            "tolerance_m", &PoseAnswer::tolerance_rad, "tolerance_rad");
    }
    void compare(const std::string& name, const Thing& a, const Thing& b) {
        all(name, a, b, &Thing::kind, "kind", &Thing::index, "index", &Thing::part, "part", &Thing::driven,
            "driven", &Thing::equation, "equation");
    }
    void compare(const std::string& name, const Trial& a, const Trial& b) {
        all(name, a, b, &Trial::text, "text", &Trial::actions, "actions", &Trial::breaks, "breaks");
    }
    void compare(const std::string& name, const AfterAddition& a, const AfterAddition& b) {
        compare(name + ".count", a.count, b.count);
    }
    void compare(const std::string& name, const AtTime& a, const AtTime& b) {
        all(name, a, b, &AtTime::t, "t", &AtTime::by_forces, "by_forces");
    }
    void compare(const std::string& name, const CountClaim& a, const CountClaim& b) {
        all(name, a, b, &CountClaim::count, "count", &CountClaim::value, "value");
    }
    void compare(const std::string& name, const DroppedClaim& a, const DroppedClaim& b) {
        all(name, a, b, &DroppedClaim::joint, "joint", &DroppedClaim::role, "role", &DroppedClaim::component,
            "component");
    }
    void compare(const std::string& name, const BoundClaim& a, const BoundClaim& b) {
        all(name, a, b, &BoundClaim::bound, "bound", &BoundClaim::limit, "limit");
    }
    void compare(const std::string& name, const VerdictClaim& a, const VerdictClaim& b) {
        all(name, a, b, &VerdictClaim::verdict, "verdict", &VerdictClaim::value, "value");
    }
    void compare(const std::string& name, const QuantityClaim& a, const QuantityClaim& b) {
        using Q = QuantityClaim;
        all(name, a, b, &Q::quantity, "quantity", &Q::text, "text", &Q::derivative, "derivative",
            &Q::named_derivative, "named_derivative", &Q::in_degrees, "in_degrees", &Q::value, "value",
            &Q::tolerance, "tolerance");
    }
    void compare(const std::string& name, const MeasureQuantity& a, const MeasureQuantity& b) {
        using Q = MeasureQuantity;
        all(name, a, b, &Q::measure, "measure", &Q::body_i, "body_i", &Q::body_j, "body_j", &Q::joint,
            "joint", &Q::driver, "driver");
    }
    void compare(
        const std::string& name, const AngularVelocityQuantity& a, const AngularVelocityQuantity& b) {
        using Q = AngularVelocityQuantity;
        all(name, a, b, &Q::body, "body", &Q::local, "local", &Q::component, "component");
    }
    void compare(const std::string& name, const PointQuantity& a, const PointQuantity& b) {
        using Q = PointQuantity;
        all(name, a, b, &Q::body, "body", &Q::s_local, "s_local", &Q::component, "component");
    }
    void compare(const std::string& name, const PointSpeedQuantity& a, const PointSpeedQuantity& b) {
        using Q = PointSpeedQuantity;
        all(name, a, b, &Q::body, "body", &Q::s_local, "s_local");
    }
    void compare(const std::string& name, const BodySizeQuantity& a, const BodySizeQuantity& b) {
        using Q = BodySizeQuantity;
        all(name, a, b, &Q::body, "body", &Q::vector, "vector");
    }
    void compare(const std::string& name, const DirectionsQuantity& a, const DirectionsQuantity& b) {
        using Q = DirectionsQuantity;
        all(name, a, b, &Q::body_i, "body_i", &Q::a_i_local, "a_i_local", &Q::body_j, "body_j", &Q::a_j_local,
            "a_j_local");
    }
    void compare(const std::string& name, const EnergyQuantity& a, const EnergyQuantity& b) {
        compare(name, a.part, b.part);
    }
    void compare(const std::string& name, const ReactionQuantity& a, const ReactionQuantity& b) {
        using Q = ReactionQuantity;
        all(name, a, b, &Q::joint, "joint", &Q::driver, "driver", &Q::part, "part", &Q::component,
            "component");
    }
    void compare(const std::string& name, const EffortQuantity& a, const EffortQuantity& b) {
        compare(name, a.driver, b.driver);
    }
    void compare(const std::string& name, const ParameterErrorQuantity& a, const ParameterErrorQuantity& b) {
        compare(name, a.body, b.body);
    }
    void compare(const std::string& name, const ResidualQuantity& a, const ResidualQuantity& b) {
        using Q = ResidualQuantity;
        all(name, a, b, &Q::joint, "joint", &Q::driver, "driver", &Q::role, "role", &Q::component,
            "component");
    }
    void compare(
        const std::string& /*name*/, const SingularValueQuantity& /*a*/, const SingularValueQuantity& /*b*/) {
    }
    void compare(const std::string& name, const PairConditionQuantity& a, const PairConditionQuantity& b) {
        using Q = PairConditionQuantity;
        all(name, a, b, &Q::joint, "joint", &Q::role, "role");
    }

    template <class T>
    void compare(const std::string& name, const std::vector<T>& a, const std::vector<T>& b) {
        compare(name + ".size", a.size(), b.size());
        for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
            compare(name + '[' + std::to_string(k) + ']', a[k], b[k]);
        }
    }
    template <class T, std::size_t N>
    void compare(const std::string& name, const std::array<T, N>& a, const std::array<T, N>& b) {
        for (std::size_t k = 0; k < N; ++k) { compare(name + '[' + std::to_string(k) + ']', a[k], b[k]); }
    }
    template <class T>
    void compare(const std::string& name, const std::optional<T>& a, const std::optional<T>& b) {
        compare(name + ".has_value", a.has_value(), b.has_value());
        if (a && b) { compare(name, *a, *b); }
    }
    template <class... Ts>
    void compare(const std::string& name, const std::variant<Ts...>& a, const std::variant<Ts...>& b) {
        compare(name + ".index", a.index(), b.index());
        if (a.index() != b.index()) { return; }
        std::visit(
            [&](const auto& value) { compare(name, value, std::get<std::decay_t<decltype(value)>>(b)); }, a);
    }
    template <class T>
    requires std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_pointer_v<T>
    void compare(const std::string& name, T a, T b) {
        if (a == b) { return; }
        if constexpr (std::is_enum_v<T>) {
            differ(name, static_cast<int>(a), static_cast<int>(b));
        } else {
            differ(name, a, b);
        }
    }
    void compare(const std::string& name, const std::string& a, const std::string& b) {
        if (a != b) { differ(name, '"' + a + '"', '"' + b + '"'); }
    }
    void compare(const std::string& name, const Text& a, const Text& b) {
        if (!same_in_all_languages(a, b)) { differ(name, '"' + a + '"', '"' + b + '"'); }
    }
    template <class A>
    void compare(const std::string& name, const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<A>& b) {
        if (a != b) { differ(name, a.transpose().eval(), b.transpose().eval()); }
    }

private:
    template <class T>
    void differ(const std::string& name, const T& a, const T& b) {
        if (!first_.empty()) { return; }
        std::ostringstream text;
        text.precision(17);
        text << name << ": " << a << " is not " << b;
        first_ = text.str();
    }

    /// Pairs of a member and its name.
    template <class T>
    void all(const std::string& /*name*/, const T& /*a*/, const T& /*b*/) {}
    template <class T, class M, class... Rest>
    void all(const std::string& name, const T& a, const T& b, M member, const char* called, Rest... rest) {
        compare(name + '.' + called, a.*member, b.*member);
        all(name, a, b, rest...);
    }

    std::string first_;
};

inline std::string first_difference(const Lesson& a, const Lesson& b) {
    Difference difference;
    difference.compare("lesson", a, b);
    return difference.first();
}

}  // namespace jw::test
