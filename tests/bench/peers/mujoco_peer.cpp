#include <cstdio>
#include <cstring>
#include <memory>
#include <sstream>
#include <stdexcept>

#include <mujoco/mujoco.h>

#include "tests/bench/peers/sweep.hpp"

/// MuJoCo: internal coordinates over a tree, fixed steps, loops by soft constraints.
namespace jw::peers {
namespace {

std::string text(const Vec3& v) {
    char out[100];
    std::snprintf(out, sizeof out, "\"%.17g %.17g %.17g\"", v.x(), v.y(), v.z());
    return out;
}
std::string name_of(int body) { return body == 0 ? "world" : "b" + std::to_string(body); }

void write_joint(std::ostream& out, const PeerScene& scene, const PeerJoint& joint) {
    const std::string pos = " pos=" + text(from_centre(scene, joint.child, joint.point));
    const std::string along = pos + " axis=" + text(joint.axis_parent) + "/>";
    switch (joint.kind) {
        case Kind::revolute: out << "<joint type='hinge'" << along; break;
        case Kind::prismatic: out << "<joint type='slide'" << along; break;
        case Kind::cylindrical:
            out << "<joint type='slide'" << along << "<joint type='hinge'" << along;
            break;
        case Kind::universal:
            out << "<joint type='hinge'" << along << "<joint type='hinge'" << pos
                << " axis=" << text(joint.axis_child) << "/>";
            break;
        case Kind::spherical: out << "<joint type='ball'" << pos << "/>"; break;
        case Kind::fixed: break;
        case Kind::free: out << "<freejoint/>"; break;
    }
}

void write_sites(std::ostream& out, const PeerScene& scene, int body) {
    for (std::size_t k = 0; k < scene.springs.size(); ++k) {
        const PeerSpring& s = scene.springs[k];
        if (s.body_i == body) { out << "<site name='i" << k << "' pos=" << text(s.P_i) << "/>"; }
        if (s.body_j == body) { out << "<site name='j" << k << "' pos=" << text(s.P_j) << "/>"; }
    }
}

void write_children(std::ostream& out, const PeerScene& scene, int parent) {
    for (const PeerJoint& joint : scene.tree) {
        if (joint.parent != parent) { continue; }
        const PeerBody& body = scene.bodies[static_cast<std::size_t>(joint.child)];
        const Mat3& J = body.J;
        out << "<body name='" << name_of(joint.child) << "' pos=" << text(from_centre(scene, parent, body.r))
            << "><inertial pos='0 0 0' mass='" << body.mass << "' fullinertia='" << J(0, 0) << ' ' << J(1, 1)
            << ' ' << J(2, 2) << ' ' << J(0, 1) << ' ' << J(0, 2) << ' ' << J(1, 2) << "'/>";
        write_joint(out, scene, joint);
        write_sites(out, scene, joint.child);
        write_children(out, scene, joint.child);
        out << "</body>\n";
    }
}

void write_connect(std::ostream& out, const PeerScene& scene, const PeerJoint& joint, const Vec3& point) {
    out << "<connect body1='" << name_of(joint.parent) << "' body2='" << name_of(joint.child)
        << "' anchor=" << text(from_centre(scene, joint.parent, point)) << "/>\n";
}

std::string mjcf(const PeerScene& scene) {
    std::ostringstream out;
    out.precision(17);
    out << "<mujoco><compiler angle='radian'/><option gravity=" << text(scene.gravity)
        << " tolerance='1e-14' iterations='100'><flag contact='disable'/></option>\n<size njmax='"
        << 50 + 6 * scene.loops.size() << "' nconmax='0'/>\n<worldbody>";
    write_sites(out, scene, 0);
    write_children(out, scene, 0);
    out << "</worldbody>\n<equality>";
    for (const PeerLoop& loop : scene.loops) {
        write_connect(out, scene, loop.joint, loop.joint.point);
        // two points hold an axis
        if (!loop.point_is_enough) {
            write_connect(out, scene, loop.joint, loop.joint.point + loop.joint.axis_parent);
        }
    }
    out << "</equality>\n<tendon>";
    for (std::size_t k = 0; k < scene.springs.size(); ++k) {
        const PeerSpring& s = scene.springs[k];
        out << "<spatial stiffness='" << s.stiffness << "' damping='" << s.damping << "' springlength='"
            << s.free_length << "'><site site='i" << k << "'/><site site='j" << k << "'/></spatial>\n";
    }
    out << "</tendon></mujoco>\n";
    return out.str();
}

struct Delete {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
};
using ModelPointer = std::unique_ptr<mjModel, Delete>;
using DataPointer = std::unique_ptr<mjData, Delete>;

ModelPointer compiled(const std::string& xml) {
    const auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    mj_makeEmptyFileVFS(files.get(), "scene.xml", static_cast<int>(xml.size()));
    std::memcpy(files->filedata[0], xml.data(), xml.size());
    char error[500] = "";
    ModelPointer model(mj_loadXML("scene.xml", files.get(), error, sizeof error));
    mj_deleteVFS(files.get());
    if (!model) { throw std::runtime_error(error); }
    return model;
}

int id_of(const mjModel& model, int body) { return mj_name2id(&model, mjOBJ_BODY, name_of(body).c_str()); }

/// Rates of a body's joints from the velocities of the two bodies.
void set_velocity(const PeerScene& scene, const PeerJoint& joint, const mjModel& model, mjtNum* qvel) {
    const PeerBody& child = scene.bodies[static_cast<std::size_t>(joint.child)];
    const PeerBody& parent = scene.bodies[static_cast<std::size_t>(joint.parent)];
    const Vec3 omega = child.omega - parent.omega;
    const Vec3 v =
        velocity_at(scene, joint.child, joint.point) - velocity_at(scene, joint.parent, joint.point);
    mjtNum* u = qvel + model.body_dofadr[id_of(model, joint.child)];
    switch (joint.kind) {
        case Kind::revolute: u[0] = joint.axis_parent.dot(omega); break;
        case Kind::prismatic: u[0] = joint.axis_parent.dot(v); break;
        case Kind::cylindrical:
            u[0] = joint.axis_parent.dot(v);
            u[1] = joint.axis_parent.dot(omega);
            break;
        case Kind::universal:
            u[0] = joint.axis_parent.dot(omega);
            u[1] = joint.axis_child.dot(omega);
            break;
        case Kind::spherical: std::copy(omega.data(), omega.data() + 3, u); break;
        case Kind::fixed: break;
        case Kind::free:
            std::copy(child.v.data(), child.v.data() + 3, u);
            std::copy(child.omega.data(), child.omega.data() + 3, u + 3);
            break;
    }
}

DataPointer started(const PeerScene& scene, const mjModel& model) {
    DataPointer data(mj_makeData(&model));
    for (const PeerJoint& joint : scene.tree) { set_velocity(scene, joint, model, data->qvel); }
    for (const PeerWrench& w : scene.wrenches) {
        mjtNum* applied = data->xfrc_applied + 6 * id_of(model, w.body);
        for (int k = 0; k < 3; ++k) {
            applied[k] += w.force[k];
            applied[3 + k] += w.torque[k];
        }
    }
    return data;
}

Vec3 point_of(const PeerScene& scene, const mjModel& model, mjData& data) {
    mj_kinematics(&model, &data);
    const int body = id_of(model, scene.body);
    using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    return Eigen::Map<const Vec3>(data.xpos + 3 * body) +
           Eigen::Map<const RowMajor>(data.xmat + 9 * body) * from_centre(scene, scene.body, scene.point);
}

struct Choice {
    const char* name;
    mjtIntegrator integrator;
    int evaluations;  ///< per step
};
constexpr Choice kChoices[] = {
    {"RK4", mjINT_RK4, 4}, {"implicit", mjINT_IMPLICIT, 1}, {"Euler", mjINT_EULER, 1}};

/// Errors of a loop decay with a time constant of `softness` steps, as stiff as MuJoCo allows.
void set_loops(mjModel& model, double softness) {
    for (int k = 0; k < model.neq; ++k) {
        mjtNum* solref = model.eq_solref + k * mjNREF;
        mjtNum* solimp = model.eq_solimp + k * mjNIMP;
        solref[0] = softness * model.opt.timestep;
        solref[1] = 1.0;
        solimp[0] = solimp[1] = mjMAXIMP;
    }
}

Outcome simulate(const PeerScene& scene, mjModel& model, const Choice& choice, int steps, double limit) {
    Outcome outcome;
    const DataPointer data = started(scene, model);
    Run run(scene, limit);
    for (int k = 1; k <= 100 && !run.out_of_time(); ++k) {
        for (int n = 0; n < steps; ++n) {
            mj_step(&model, data.get());
            if (n % 256 == 0 && run.out_of_time()) { break; }
        }
        outcome.evaluations += static_cast<long>(steps) * choice.evaluations;
        if (data->warning[mjWARN_BADQACC].number > 0) {
            outcome.remark = "QACC warning and reset";
            break;
        }
        if (!run.out_of_time()) { run.at_sample(k, point_of(scene, model, *data)); }
    }
    outcome.milliseconds = run.milliseconds();
    outcome.error = run.error();
    outcome.out_of_time = run.out_of_time();
    return outcome;
}

/// 1, 2, 3 ... 8, 10, 12, 14, 16, 20 ...: at most a quarter more, from 4 on.
int next_of(int steps) {
    int unit = 1;
    while (8 * unit <= steps) { unit *= 2; }
    return steps + unit;
}

void measure(const PeerScene& scene, double limit, Report& report) {
    mju_user_warning = [](const char*) {};  // the remark reports it; no log file in the working folder
    const ModelPointer model = compiled(mjcf(scene));
    // as shipped, MuJoCo lifts time constants below two steps; with RK4 half a step is stable and more
    // accurate
    model->opt.disableflags |= mjDSBL_REFSAFE;
    const std::vector<double> softnesses =
        scene.loops.empty() ? std::vector<double>{0.0} : std::vector<double>{2.0, 1.4, 1.0, 0.5};
    for (const Choice& choice : kChoices) {
        model->opt.integrator = choice.integrator;
        for (const double softness : softnesses) {
            for (int steps = 1; steps <= (1 << 20); steps = next_of(steps)) {
                model->opt.timestep = scene.duration / (100.0 * steps);
                set_loops(*model, softness);
                const Outcome outcome =
                    least_of_several([&] { return simulate(scene, *model, choice, steps, limit); });
                char setting[60];
                std::snprintf(
                    setting, sizeof setting, softness > 0.0 ? "dt %.2e time constant %g dt" : "dt %.2e",
                    model->opt.timestep, softness);
                report.add(choice.name, setting, outcome);
                if (outcome.out_of_time || outcome.error < kEnough) { break; }
            }
        }
    }
}

}  // namespace
}  // namespace jw::peers

int main(int count, char** arguments) {
    return jw::peers::for_every_scene(count, arguments, "mujoco", jw::peers::measure);
}
