#include <array>
#include <memory>

#include <Simbody.h>  // its integrators complain to stderr

#include "tests/bench/peers/sweep.hpp"

/// Simbody: internal coordinates over a tree, loops by multipliers and projection.
namespace jw::peers {
namespace {

SimTK::Vec3 simtk(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
Vec3 eigen(const SimTK::Vec3& v) { return {v[0], v[1], v[2]}; }

SimTK::Inertia inertia(const Mat3& J) { return {J(0, 0), J(1, 1), J(2, 2), J(0, 1), J(0, 2), J(1, 2)}; }

/// Joint frame with the axes that Simbody's mobilizers turn about.
SimTK::Rotation frame_of(const PeerJoint& joint) {
    const SimTK::UnitVec3 axis(simtk(joint.axis_parent));
    switch (joint.kind) {
        case Kind::revolute:
        case Kind::cylindrical: return {axis, SimTK::ZAxis};
        case Kind::prismatic: return {axis, SimTK::XAxis};
        case Kind::universal: return {axis, SimTK::XAxis, simtk(joint.axis_child), SimTK::YAxis};
        default: return {};
    }
}

class Model {
public:
    explicit Model(const PeerScene& scene)
        : scene_(&scene), matter_(system_), forces_(system_), bodies_(scene.bodies.size()) {
        if (scene.gravity.norm() > 0.0) {
            SimTK::Force::UniformGravity(forces_, matter_, simtk(scene.gravity));
        }
        bodies_[0] = matter_.Ground();
        for (const PeerJoint& joint : scene.tree) { add(joint); }
        for (const PeerLoop& loop : scene.loops) { close(loop); }
        add_loads();
        state_ = system_.realizeTopology();
        for (const PeerJoint& joint : scene.tree) { set_velocity(joint); }
    }

    const SimTK::MultibodySystem& system() const { return system_; }
    const SimTK::State& start() const { return state_; }
    Vec3 point(const SimTK::State& state) const {
        system_.realize(state, SimTK::Stage::Position);
        return eigen(body(scene_->body)
                         .findStationLocationInGround(
                             state, simtk(from_centre(*scene_, scene_->body, scene_->point))));
    }

private:
    SimTK::MobilizedBody& body(int b) { return bodies_[static_cast<std::size_t>(b)]; }
    const SimTK::MobilizedBody& body(int b) const { return bodies_[static_cast<std::size_t>(b)]; }

    void add(const PeerJoint& joint) {
        using M = SimTK::MobilizedBody;
        const PeerBody& data = scene_->bodies[static_cast<std::size_t>(joint.child)];
        const SimTK::Body::Rigid rigid(SimTK::MassProperties(data.mass, SimTK::Vec3(0), inertia(data.J)));
        const bool free = joint.kind == Kind::free;
        const Vec3 point = free ? data.r : joint.point;
        const SimTK::Transform F(frame_of(joint), simtk(from_centre(*scene_, joint.parent, point)));
        const SimTK::Transform B(frame_of(joint), simtk(from_centre(*scene_, joint.child, point)));
        M& parent = body(joint.parent);
        M& child = body(joint.child);
        switch (joint.kind) {
            case Kind::revolute: child = M::Pin(parent, F, rigid, B); break;
            case Kind::prismatic: child = M::Slider(parent, F, rigid, B); break;
            case Kind::cylindrical: child = M::Cylinder(parent, F, rigid, B); break;
            case Kind::universal: child = M::Universal(parent, F, rigid, B); break;
            case Kind::spherical: child = M::Ball(parent, F, rigid, B); break;
            case Kind::fixed: child = M::Weld(parent, F, rigid, B); break;
            case Kind::free: child = M::Free(parent, F, rigid, B); break;
        }
    }

    void close(const PeerLoop& loop) {
        const PeerJoint& joint = loop.joint;
        SimTK::MobilizedBody& i = body(joint.parent);
        SimTK::MobilizedBody& j = body(joint.child);
        SimTK::Constraint::Ball(
            i, simtk(from_centre(*scene_, joint.parent, joint.point)), j,
            simtk(from_centre(*scene_, joint.child, joint.point)));
        if (loop.point_is_enough) { return; }
        const auto right_angle = [&](const Vec3& a, const Vec3& b) {
            SimTK::Constraint::ConstantAngle(
                i, SimTK::UnitVec3(simtk(a)), j, SimTK::UnitVec3(simtk(b)), SimTK::Pi / 2);
        };
        if (joint.kind == Kind::universal) { right_angle(joint.axis_parent, joint.axis_child); }
        if (joint.kind == Kind::revolute) {
            const Vec3 side = perpendicular_to(joint.axis_parent);
            right_angle(side, joint.axis_child);
            right_angle(joint.axis_parent.cross(side), joint.axis_child);
        }
    }

    void add_loads() {
        for (const PeerSpring& s : scene_->springs) {
            SimTK::MobilizedBody& i = body(s.body_i);
            SimTK::MobilizedBody& j = body(s.body_j);
            const SimTK::Vec3 P_i = simtk(s.P_i);
            const SimTK::Vec3 P_j = simtk(s.P_j);
            SimTK::Force::TwoPointLinearSpring(forces_, i, P_i, j, P_j, s.stiffness, s.free_length);
            if (s.damping > 0.0) { SimTK::Force::TwoPointLinearDamper(forces_, i, P_i, j, P_j, s.damping); }
        }
        for (const PeerWrench& w : scene_->wrenches) {
            SimTK::Force::ConstantForce(forces_, body(w.body), SimTK::Vec3(0), simtk(w.force));
            SimTK::Force::ConstantTorque(forces_, body(w.body), simtk(w.torque));
        }
    }

    void set_velocity(const PeerJoint& joint) {
        const Vec3 point =
            joint.kind == Kind::free ? scene_->bodies[static_cast<std::size_t>(joint.child)].r : joint.point;
        const Vec3 v = velocity_at(*scene_, joint.child, point) - velocity_at(*scene_, joint.parent, point);
        const Vec3 omega = scene_->bodies[static_cast<std::size_t>(joint.child)].omega -
                           scene_->bodies[static_cast<std::size_t>(joint.parent)].omega;
        const SimTK::Rotation R = frame_of(joint);
        body(joint.child).setUToFitVelocity(state_, SimTK::SpatialVec(~R * simtk(omega), ~R * simtk(v)));
    }

    const PeerScene* scene_;
    SimTK::MultibodySystem system_;
    SimTK::SimbodyMatterSubsystem matter_;
    SimTK::GeneralForceSubsystem forces_;
    std::vector<SimTK::MobilizedBody> bodies_;
    SimTK::State state_;
};

using MakeIntegrator = std::unique_ptr<SimTK::Integrator> (*)(const SimTK::System&);
struct Choice {
    const char* name;
    MakeIntegrator make;
    double tightest;  ///< accuracy beyond which its low order only costs time
};

template <class I>
std::unique_ptr<SimTK::Integrator> plain(const SimTK::System& system) {
    return std::make_unique<I>(system);
}
template <SimTK::CPodes::LinearMultistepMethod method, SimTK::CPodes::NonlinearSystemIterationType iteration>
std::unique_ptr<SimTK::Integrator> cpodes(const SimTK::System& system) {
    return std::make_unique<SimTK::CPodesIntegrator>(system, method, iteration);
}

constexpr std::array kChoices{
    Choice{"RungeKuttaMerson", plain<SimTK::RungeKuttaMersonIntegrator>, 1e-12},
    Choice{"RungeKuttaFeldberg", plain<SimTK::RungeKuttaFeldbergIntegrator>, 1e-12},
    Choice{"RungeKutta3", plain<SimTK::RungeKutta3Integrator>, 1e-8},
    Choice{"CPodes BDF", cpodes<SimTK::CPodes::BDF, SimTK::CPodes::Newton>, 1e-12},
    Choice{"CPodes Adams", cpodes<SimTK::CPodes::Adams, SimTK::CPodes::Functional>, 1e-12},
    Choice{"SemiExplicitEuler2", plain<SimTK::SemiExplicitEuler2Integrator>, 1e-5}};

Outcome simulate(
    const Model& model, const PeerScene& scene, const Choice& choice, double accuracy, double limit) {
    Outcome outcome;
    const auto integrator = choice.make(model.system());
    integrator->setAccuracy(accuracy);
    integrator->setConstraintTolerance(std::min(1e-4, 0.1 * accuracy));
    const int before = model.system().getNumRealizationsOfThisStage(SimTK::Stage::Acceleration);
    Run run(scene, limit);
    try {
        integrator->setReturnEveryInternalStep(true);
        integrator->initialize(model.start());
        for (int k = 1; k <= 100; ++k) {
            while (integrator->getTime() < run.sample_time(k) * (1.0 - 1e-14)) {
                integrator->stepTo(run.sample_time(k));
                if (run.out_of_time()) { break; }
            }
            if (run.out_of_time()) { break; }
            run.at_sample(k, model.point(integrator->getState()));
        }
    } catch (const std::exception& e) { outcome.remark = e.what(); }
    outcome.milliseconds = run.milliseconds();
    outcome.error = run.error();
    outcome.evaluations = model.system().getNumRealizationsOfThisStage(SimTK::Stage::Acceleration) - before;
    outcome.out_of_time = run.out_of_time();
    return outcome;
}

void measure(const PeerScene& scene, double limit, Report& report) {
    const Model model(scene);
    for (const Choice& choice : kChoices) {
        for (double accuracy = 1e-2; accuracy > 0.9 * choice.tightest; accuracy *= kTighter) {
            const Outcome outcome =
                least_of_several([&] { return simulate(model, scene, choice, accuracy, limit); });
            char setting[40];
            std::snprintf(setting, sizeof setting, "accuracy %.1e", accuracy);
            report.add(choice.name, setting, outcome);
            if (outcome.out_of_time || outcome.error < kEnough) { break; }
        }
    }
}

}  // namespace
}  // namespace jw::peers

int main(int count, char** arguments) {
    return jw::peers::for_every_scene(count, arguments, "simbody", jw::peers::measure);
}
