#include "tests/support/generators/mechanism_of.hpp"

#include <cmath>

#include "core/model/joint_types.hpp"
#include "tests/reference/general/mechanics.hpp"
#include "tests/support/generators/placing.hpp"
#include "tests/support/generators/to_model.hpp"

namespace jw::test {

namespace general = reference::general;

namespace {

// what rounding of the pose leaves of rows that repeat others; rows that part at second order are not
// rounding
constexpr long double kContradicts = 1e-9L;

class Cook {
public:
    explicit Cook(const Recipe& recipe)
        : placing_(recipe), random_(static_cast<unsigned>(recipe.seed) * 6700417U + 11U) {
        out_.recipe = recipe;
        out_.length = placing_.length();
        out_.mechanism.bodies.push_back(placing_.ground());
        out_.loads.masses.emplace_back();
    }

    std::optional<Generated> cooked() {
        const Recipe recipe = out_.recipe;
        if (recipe.afloat) { add_body({0, kFreeBody, 0, 0, true, recipe.seed}); }
        for (const BodyRecipe& body : recipe.bodies) { add_body(body); }
        for (const JointRecipe& joint : recipe.joints) { add_joint(joint); }
        if (recipe.drive_all) { drive_all(); }
        for (const DriverRecipe& driver : recipe.drivers) { add_driver(driver); }
        if (recipe.gravity && !recipe.afloat) { out_.loads.gravity = random_.vector(9.81 * out_.length); }
        for (const LoadRecipe& load : recipe.loads) { add_load(load); }
        if (out_.mechanism.bodies.size() < 2 || !set_motion()) { return std::nullopt; }
        return out_;
    }

private:
    Mechanism& mechanism() { return out_.mechanism; }
    int bodies() const { return static_cast<int>(out_.mechanism.bodies.size()); }
    /// True if there are no two bodies between which anything could be put.
    bool is_alone() const { return bodies() < (out_.recipe.afloat ? 3 : 2); }
    /// The body that `number` points at, the ground only where something may hang from it.
    int body_of(int number) const {
        const int first = out_.recipe.afloat && bodies() > 1 ? 1 : 0;
        return first + number % (bodies() - first);
    }

    void add_body(const BodyRecipe& recipe) {
        const int parent = body_of(recipe.parent);
        Body body = placing_.body("body " + std::to_string(bodies()), recipe.seed);
        if (out_.recipe.at_rest) {
            body.r_dot.setZero();
            body.omega_local.setZero();
        }
        mechanism().bodies.push_back(body);
        out_.loads.masses.emplace_back(mass(recipe));
        if (recipe.joint == kFreeBody) { return; }
        const JointType& type = placing_.type_of(recipe.joint);
        mechanism().joints.push_back(
            placing_.joint(mechanism(), type, parent, bodies() - 1, recipe.form, recipe.seed));
    }

    MassProperties mass(const BodyRecipe& recipe) const {
        Random random(static_cast<unsigned>(recipe.seed) * 32452843U + 5U);
        const double factor = std::pow(10.0, recipe.mass_decade);
        MassProperties m;
        m.mass = factor * random.number(0.3, 3.0);
        if (recipe.offset) { m.centre_local = random.vector(0.3 * out_.length); }
        const Mat3 axes = rotation_matrix(random.unit_p());
        const Vec3 moments(random.number(0.1, 0.2), random.number(0.1, 0.2), random.number(0.1, 0.2));
        const double square = out_.length * out_.length;
        const Mat3 J = m.mass * square * (axes * moments.asDiagonal() * axes.transpose());
        m.J_local = 0.5 * (J + J.transpose());
        return m;
    }

    /// Rank of all equations there are now, and whether those that repeat others agree with them.
    int rank_now() {
        general::Mechanics mechanics(model_of(mechanism(), out_.loads));
        return mechanics.rank_at(mechanics.start());
    }

    std::pair<int, int> two_bodies(int i, int j) const {
        const int first = body_of(i);
        const int second = body_of(j);
        // never the same twice, never two that do not move
        return {first, second == first ? body_of(j + 1) : second};
    }

    void add_joint(const JointRecipe& recipe) {
        if (is_alone()) { return; }
        const auto [i, j] = two_bodies(recipe.i, recipe.j);
        const JointType& type = placing_.type_of(recipe.type);
        const int before = rank_now();
        Joint joint = placing_.joint(mechanism(), type, i, j, recipe.form, recipe.seed);
        take_out(joint, recipe.without);
        const int rows = static_cast<int>(equations_of_joint(joint, 0).size());
        mechanism().joints.push_back(joint);
        const int after = rank_now();
        // loops of the other families repeat rows wherever they are; elsewhere only a structure does
        const bool wanted = recipe.repeats || out_.recipe.family != Family::general;
        if (after >= 6 * (bodies() - 1) || (after < before + rows && !wanted)) {
            mechanism().joints.pop_back();
            ++out_.left_out;
        }
    }

    /// Takes an equation out where it is known which one that is.
    void take_out(Joint& joint, int number) const {
        if (number <= 0) { return; }
        const bool known = joint.parallel_form == ParallelForm::pair;
        std::vector<EquationOut> all;
        if (joint.type->artificial > 0) { return; }
        for (const Role role : joint.type->roles) {
            if (is_parallel(role) && !known) { continue; }
            // two bodies held along one global axis feel a couple that the ground would have to take
            if (role == Role::same_point && out_.recipe.afloat) { continue; }
            for (int k = 0; k < traits_of(role).independent; ++k) { all.push_back({role, k}); }
        }
        // the last equation stays
        if (all.size() < 2) { return; }
        joint.without.push_back(all[static_cast<std::size_t>(number) % all.size()]);
    }

    TimeFunction function(int kind, double length) {
        TimeFunction f;
        f.polynomial = {0.0};
        if (kind % 4 == 0 || kind % 4 == 3) {
            f.polynomial = {0.0, length * random_.number(), length * random_.number()};
        }
        if (kind % 4 == 1 || kind % 4 == 3) {
            f.harmonics = {{0.5 * length * random_.number(), random_.number(0.5, 3.0), random_.number()}};
        }
        if (kind % 4 >= 2) {
            f.steps = {
                {0.0, 0.5 * length * random_.number(), random_.number(-0.5, 0.2), random_.number(0.5, 1.5)}};
        }
        if (kind % 8 >= 4) {
            const auto value = [&] { return 0.2 * length * random_.number(); };
            f.table = table_through(
                {-0.5, 0.1, 0.7, 1.5}, {value(), value(), value(), value()},
                TimeTable::Interpolation::smooth);
            const TimeTable& table = *f.table;
            if (kind % 2 == 0) { f.formula = dying_swing(table.values[0], 2.0, table.values[1] / length); }
        }
        return f;
    }

    void add_driver(const DriverRecipe& recipe) {
        if (is_alone()) { return; }
        const auto [i, j] = two_bodies(recipe.i, recipe.j);
        Driver driver;
        driver.name = "driver " + std::to_string(mechanism().drivers.size() + 1);
        const double length = out_.length;
        switch (recipe.quantity % 4) {
            case 0:
            case 1:
                if (!along_joint(driver, recipe.joint, recipe.quantity % 4 == 1)) {
                    ++out_.left_out;
                    return;
                }
                break;
            case 2: {
                driver.body_i = i;
                driver.body_j = j;
                driver.measure = SquaredDistanceMeasure{random_.vector(length), random_.vector(length)};
                break;
            }
            default: {
                if (out_.recipe.afloat) {
                    ++out_.left_out;
                    return;
                }
                driver.body_j = j == 0 ? i : j;
                const auto& own = out_.loads.masses[static_cast<std::size_t>(driver.body_j)];
                const bool origin_is_centre = own && own->centre_local.isZero();
                const int number = recipe.joint % 7;
                driver.measure = CoordinateMeasure{origin_is_centre ? number : 3 + number % 4};
            }
        }
        take_driver(driver, recipe.function);
    }

    /// Angle (θ of a screw) or displacement of the first joint from `number` on that has it.
    bool along_joint(Driver& driver, int number, bool displacement) {
        const auto count = static_cast<int>(mechanism().joints.size());
        for (int k = 0; k < count; ++k) {
            const int index = (number + k) % count;
            const Joint& joint = mechanism().joints[static_cast<std::size_t>(index)];
            if (displacement ? !joint.type->has_displacement() : !joint.type->has_angle()) { continue; }
            driver.joint = index;
            driver.body_i = joint.body_i;
            driver.body_j = joint.body_j;
            driver.measure = displacement                  ? Measure(displacement_of(joint))
                             : joint.type->artificial == 0 ? Measure(angle_of(joint))
                                                           : Measure(ThetaMeasure{});
            return true;
        }
        return false;
    }

    bool is_a_length(const Driver& driver) const {
        if (const auto* c = std::get_if<CoordinateMeasure>(&driver.measure)) { return c->coordinate < 3; }
        return std::holds_alternative<DisplacementMeasure>(driver.measure) ||
               std::holds_alternative<SquaredDistanceMeasure>(driver.measure);
    }

    /// Makes a driver start at the present pose. Euler parameters move a little only: they end at ±1.
    void take_driver(Driver& driver, int kind) {
        const bool parameter = std::holds_alternative<CoordinateMeasure>(driver.measure) &&
                               std::get<CoordinateMeasure>(driver.measure).coordinate >= 3;
        driver.function = function(kind, is_a_length(driver) ? 0.4 * out_.length : parameter ? 0.1 : 1.0);
        const general::Mechanics mechanics(model_of(mechanism(), out_.loads));
        const general::Equation equation = equation_of_driver(mechanism(), driver, 0);
        general::Mechanics copy = mechanics;
        const general::PlacedBodies& placed = copy.bodies_at(copy.start());
        long double value = general::measured(equation.measure, placed).value;
        if (equation.squared) { value = std::sqrt(value); }
        if (equation.squared && value < 0.3L * out_.length) { return; }
        driver.function.polynomial[0] =
            static_cast<double>(value - general::time_function(equation.target, 0.0L).value);
        const int before = rank_now();
        mechanism().drivers.push_back(driver);
        if (rank_now() == before) {
            mechanism().drivers.pop_back();
            ++out_.left_out;
        }
    }

    void drive_all() {
        const auto count = static_cast<int>(mechanism().joints.size());
        for (int k = 0; k < count; ++k) {
            for (const bool displacement : {false, true}) {
                const Joint& joint = mechanism().joints[static_cast<std::size_t>(k)];
                if (displacement ? !joint.type->has_displacement() : !joint.type->has_angle()) { continue; }
                Driver driver;
                driver.name = "driver " + std::to_string(mechanism().drivers.size() + 1);
                along_joint(driver, k, displacement);
                take_driver(driver, k);
            }
        }
    }

    double own_mass(int body) const {
        const auto& mass = out_.loads.masses[static_cast<std::size_t>(body)];
        return mass ? mass->mass : 1e300;
    }

    void add_load(const LoadRecipe& recipe) {
        if (is_alone()) { return; }
        Random random(static_cast<unsigned>(recipe.seed) * 86028121U + 7U);
        const auto [i, j] = two_bodies(recipe.i, recipe.j);
        const int moving = j == 0 ? i : j;
        const double L = out_.length;
        // accelerations of the size of the scene in 1/s², whatever the masses are
        const double lightest = std::min(own_mass(i), own_mass(j));
        const double force = lightest * L;
        const double damping = recipe.damped ? random.number(0.1, 1.0) : 0.0;
        const Frame frame = recipe.damped ? Frame::local : Frame::global;
        switch (recipe.kind % (out_.recipe.afloat ? 2 : 4)) {
            case 0: {
                Spring spring{
                    i,
                    j,
                    random.vector(L),
                    random.vector(L),
                    random.number(1.0, 10.0) * lightest,
                    random.number(0.2, 1.0) * L,
                    damping * lightest};
                if (recipe.damped) {
                    spring.friction = {0.5 * damping * lightest * L, 0.3 * L};
                    spring.law = sine_law(damping * lightest, 0.1 * damping * lightest / (L * L), "d");
                }
                // along an axis instead, also where no joint keeps to it
                if (recipe.kind % 8 >= 4) { spring.s_i_local = random.direction(); }
                out_.loads.springs.push_back(spring);
                break;
            }
            case 1: {
                Driver place;
                if (!along_joint(place, recipe.i, false)) { return; }
                const Joint& joint = mechanism().joints[static_cast<std::size_t>(place.joint)];
                const double lighter = std::min(own_mass(joint.body_i), own_mass(joint.body_j)) * L * L;
                out_.loads.rotational_springs.push_back(
                    {joint.body_i, joint.body_j, angle_of(joint), random.number(0.1, 1.0) * lighter,
                     random.number(-3.0, 3.0), 0.1 * damping * lighter});
                if (recipe.damped) {
                    RotationalSpring& spring = out_.loads.rotational_springs.back();
                    spring.friction = {0.1 * damping * lighter, 0.3};
                    spring.law = sine_law(0.1 * damping * lighter, 0.01 * damping * lighter, "\\theta");
                }
                if (recipe.kind % 8 >= 4) {
                    // it does not resist turning: its rotation vector jumps where a body turns by half a turn
                    const Vec3 share(random.number(0.1, 1.0), random.number(0.1, 1.0), 0.0);
                    out_.loads.bushings.push_back(
                        {i, j, random.vector(L), random.vector(L), rotation_matrix(random.unit_p()),
                         Mat3::Identity(), 10.0 * lightest * share, damping * lightest * share});
                }
                break;
            }
            case 2:
                out_.loads.forces.push_back(
                    {moving, random.vector(L), force * random.direction(), frame, random_function(random)});
                break;
            default:
                out_.loads.torques.push_back(
                    {moving, 0.1 * force * L * random.direction(), frame, random_function(random),
                     recipe.kind % 8 >= 4 ? i + j - moving : -1});
        }
    }

    /// Velocities that the constraints allow. @return false where the start is singular
    bool set_motion() {
        general::Mechanics mechanics(model_of(mechanism(), out_.loads));
        reference::VecX y = mechanics.start();
        // a redundant equation must be satisfied by the velocities that the others leave
        if (mechanics.project_velocities(y) > kContradicts) { return false; }
        const general::Accelerations a = mechanics.accelerations_at(y);
        if (!(a.contradiction < kContradicts)) { return false; }
        out_.rank = a.rank;
        out_.freedoms = mechanics.unknowns() - a.rank;
        out_.condition = static_cast<double>(a.condition);
        const general::PlacedBodies& placed = mechanics.bodies_at(y);
        for (std::size_t b = 1; b < mechanism().bodies.size(); ++b) {
            const general::Placed& body = placed[b];
            const reference::Vec3 arm = body.A * body.centre;
            mechanism().bodies[b].r_dot = (body.v - body.omega.cross(arm)).cast<double>();
            mechanism().bodies[b].omega_local = (body.A.transpose() * body.omega).cast<double>();
        }
        set_theta_rates(placed);
        return true;
    }

    void set_theta_rates(const general::PlacedBodies& placed) {
        for (Joint& joint : mechanism().joints) {
            if (joint.type->artificial == 0) { continue; }
            if (joint.type->uses(Role::curve_x)) {
                // the rate of the start pose follows from the bodies
                joint.geometry.theta_dot_start = std::nullopt;
                continue;
            }
            if (!joint.type->has_angle()) {
                joint.geometry.theta_dot_start =
                    static_cast<double>(general::measured(first_wheel_of(joint), placed).rate);
                continue;
            }
            const general::Placed& i = placed[static_cast<std::size_t>(joint.body_i)];
            const general::Placed& j = placed[static_cast<std::size_t>(joint.body_j)];
            const reference::Vec3 s = i.A * joint.geometry.s_i_local.normalized().cast<long double>();
            joint.geometry.theta_dot_start = static_cast<double>(s.dot(j.omega - i.omega));
        }
    }

    Placing placing_;
    Random random_;
    Generated out_;
};

}  // namespace

std::optional<Generated> mechanism_of(const Recipe& recipe) { return Cook(recipe).cooked(); }

}  // namespace jw::test
