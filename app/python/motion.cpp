#include <pybind11/stl.h>

#include "app/python/arrays.hpp"
#include "app/python/bindings.hpp"
#include "jointwise/trajectory.hpp"

namespace jointwise::python {

namespace {

/// A part of a table as an array: numbers of every body, or the numbers that follow those of all bodies.
struct Part {
    const char* name;
    Table Trajectory::*table;
    int of_body;  ///< columns of the table for each body
    int first;    ///< of these, the first column of the part
    int width;    ///< numbers of the part; 0: the numbers after those of the bodies
    const char* doc;
};

constexpr Part kParts[] = {
    {"r", &Trajectory::q, 7, 0, 3, "Origins [times x bodies x 3, m], global."},
    {"p", &Trajectory::q, 7, 3, 4, "Euler parameters [times x bodies x 4]."},
    {"theta", &Trajectory::q, 7, 0, 0, "Angles of screws [times x screws, rad]."},
    {"r_dot", &Trajectory::q_dot, 6, 0, 3, "[times x bodies x 3, m/s]"},
    {"omega_local", &Trajectory::q_dot, 6, 3, 3, "ω′ [times x bodies x 3, rad/s]."},
    {"theta_dot", &Trajectory::q_dot, 6, 0, 0, "[times x screws, rad/s]"},
    {"r_ddot", &Trajectory::q_ddot, 6, 0, 3, "[times x bodies x 3, m/s²]"},
    {"omega_local_dot", &Trajectory::q_ddot, 6, 3, 3, "ω̇′ [times x bodies x 3, rad/s²]."},
    {"theta_ddot", &Trajectory::q_ddot, 6, 0, 0, "[times x screws, rad/s²]"},
};

py::array part_of(const py::object& self, const Part& part) {
    const auto& trajectory = self.cast<const Trajectory&>();
    const Table& table = trajectory.*part.table;
    const py::ssize_t bodies = trajectory.bodies;
    if (part.width == 0) {
        const py::ssize_t behind = part.of_body * bodies;
        return view_of(
            table.data() + behind, {table.rows(), table.cols() - behind}, {table.cols(), 1}, self,
            Access::read);
    }
    return view_of(
        table.data() + part.first, {table.rows(), bodies, part.width}, {table.cols(), part.of_body, 1}, self,
        Access::read);
}

void add_tables(py::class_<Trajectory>& type) {
    add_view(type, "t", &Trajectory::t, "Times [s].");
    add_view(type, "energy", &Trajectory::energy, "Kinetic and potential energy [J]; 0 in `follow`.");
    add_view(
        type, "q", &Trajectory::q,
        "r and p of every body, 7 columns each, the ground first; then the angles of screws.");
    add_view(
        type, "q_dot", &Trajectory::q_dot,
        "ṙ and ω′ of every body, 6 columns each; then the rates of the angles.");
    add_view(type, "q_ddot", &Trajectory::q_ddot, "r̈ and ω̇′, likewise.");
    for (const Part& part : kParts) {
        type.def_property_readonly(
            part.name, [&part](const py::object& self) { return part_of(self, part); }, part.doc);
    }
}

Moment moment_of(const Trajectory& trajectory, int index) {
    const int row = index < 0 ? index + trajectory.times() : index;
    if (row < 0 || row >= trajectory.times()) {
        throw py::index_error("jointwise: the trajectory has " + counted(trajectory.times(), "time"));
    }
    return trajectory.moment(row);
}

}  // namespace

void add_motion(py::module_& module) {
    using namespace py::literals;
    py::class_<Trajectory> type(
        module, "Trajectory",
        "A motion at ascending times. Each of `q`, `q_dot` and `q_ddot` is one row-major matrix [times x "
        "columns]; the other arrays are views of these. None can be written. An index gives a Moment.");
    type.def("__len__", &Trajectory::times)
        .def("__getitem__", &moment_of, "index"_a)
        .def(
            "__iter__",
            [](const py::object& self) {
                return py::reinterpret_steal<py::iterator>(PySeqIter_New(self.ptr()));
            })
        .def("__repr__", [](const Trajectory& trajectory) {
            return "<jointwise.Trajectory: " + counted(trajectory.times(), "time") + ", " +
                   counted(trajectory.bodies, "body") + ">";
        });
    add_tables(type);

    module.def(
        "follow",
        [](Mechanism mechanism, const py::object& times) {
            const std::vector<double> at = list_of(times, "times");
            return until_interrupted([&](const std::function<bool()>& go_on) {
                return std::make_unique<Trajectory>(follow_trajectory(mechanism, at, go_on));
            });
        },
        "mechanism"_a, "times"_a,
        "Motion that the drivers prescribe, at ascending times [s]. Raises NotReached.");
    const Simulation usual;
    module.def(
        "simulate",
        [](Mechanism mechanism, const py::object& times, const std::string& method, double tolerance,
           double step) {
            const std::vector<double> at = list_of(times, "times");
            return until_interrupted([&](const std::function<bool()>& go_on) {
                const Simulation settings{method, tolerance, step, go_on};
                return std::make_unique<Trajectory>(simulate_trajectory(mechanism, at, settings));
            });
        },
        "mechanism"_a, "times"_a, py::kw_only(), "method"_a = usual.method, "tolerance"_a = usual.tolerance,
        "step"_a = usual.step,
        "Motion by masses and forces, from t = 0 through ascending times [s]. `method` as for `jointwise "
        "simulate`, `tolerance` of adaptive methods, `step` of the others [s]. Every moving body needs a "
        "mass. Raises NotReached where it ends early.");
}

}  // namespace jointwise::python
