#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>

#include <mujoco/mujoco.h>

#include "tests/bench/peers/mjcf.hpp"
#include "tests/bench/peers/sweep.hpp"

/// MuJoCo: internal coordinates over a tree, fixed steps, loops by soft constraints.
namespace jw::peers {
namespace {

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

DataPointer started(const PeerScene& scene, const mjModel& model) {
    DataPointer data(mj_makeData(&model));
    for (const PeerJoint& joint : scene.tree) {
        std::ranges::copy(rates_of(scene, joint), data->qvel + model.body_dofadr[id_of(model, joint.child)]);
    }
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
