#include <pybind11/stl.h>

#include "app/python/arrays.hpp"
#include "app/python/bindings.hpp"

namespace jointwise::python {

namespace {

constexpr const char* kCopied = "Other numbers, of the same size.";

Pose pose_with(double t, const py::object& r, const py::object& p, const py::object& theta) {
    Pose pose{t, rows_of<3>(r, "r"), rows_of<4>(p, "p"), list_of(theta, "theta")};
    if (pose.r.size() != pose.p.size()) {
        throw py::value_error("jointwise: r and p of a pose do not have one row for each body");
    }
    return pose;
}

Rates rates_with(const py::object& r_dot, const py::object& omega_local, const py::object& theta_dot) {
    Rates rates{
        rows_of<3>(r_dot, "r_dot"), rows_of<3>(omega_local, "omega_local"), list_of(theta_dot, "theta_dot")};
    if (rates.r_dot.size() != rates.omega_local.size()) {
        throw py::value_error("jointwise: r_dot and omega_local do not have one row for each body");
    }
    return rates;
}

/// Adds a member as an array that is viewed in place. An assignment must not change its size.
template <class T, class Member, class Read>
void add_array(py::class_<T>& type, const char* name, Member T::*member, Read read, const char* doc) {
    type.def_property(
        name, [member](const py::object& self) { return view_of(self.cast<T&>().*member, self); },
        [member, read, name](T& self, const py::object& value) {
            assign(self.*member, read(value, name), name);
        },
        doc);
}

void add_pose(py::module_& module) {
    using namespace py::literals;
    py::class_<Pose> type(
        module, "Pose",
        "Positions at a time. The arrays are views: what is written to them changes the pose. `r` [bodies x "
        "3] in m, `p` [bodies x 4] Euler parameters, the ground first; `theta` [screws] in rad.");
    type.def(py::init(&pose_with), "t"_a, "r"_a, "p"_a, "theta"_a = py::tuple())
        .def_readwrite("t", &Pose::t, "Time [s].")
        .def(py::pickle(
            [](const py::object& self) {
                return py::make_tuple(self.attr("t"), self.attr("r"), self.attr("p"), self.attr("theta"));
            },
            [](const py::tuple& saved) {
                return pose_with(saved[0].cast<double>(), saved[1], saved[2], saved[3]);
            }))
        .def("__repr__", [](const Pose& pose) {
            return "<jointwise.Pose at t = " + py::str(py::float_(pose.t)).cast<std::string>() +
                   " s: " + counted(std::ssize(pose.r), "body") + ", " +
                   counted(std::ssize(pose.theta), "screw") + ">";
        });
    add_array(type, "r", &Pose::r, &rows_of<3>, "Origins of the bodies [bodies x 3, m], global.");
    add_array(type, "p", &Pose::p, &rows_of<4>, "Euler parameters e0, e1, e2, e3 [bodies x 4].");
    add_array(type, "theta", &Pose::theta, &list_of, "Angles of screws [rad].");
    add_copies(type, kCopied);
}

void add_rates(py::module_& module) {
    using namespace py::literals;
    py::class_<Rates> type(
        module, "Rates",
        "Velocities, or accelerations under the same names; the arrays are views that can be written. "
        "`r_dot` [bodies x 3] in m/s, `omega_local` [bodies x 3] in rad/s and in the frame of the body, "
        "`theta_dot` [screws] in rad/s.");
    type.def(py::init(&rates_with), "r_dot"_a, "omega_local"_a, "theta_dot"_a = py::tuple())
        .def(py::pickle(
            [](const py::object& self) {
                return py::make_tuple(self.attr("r_dot"), self.attr("omega_local"), self.attr("theta_dot"));
            },
            [](const py::tuple& saved) { return rates_with(saved[0], saved[1], saved[2]); }))
        .def("__repr__", [](const Rates& rates) {
            return "<jointwise.Rates: " + counted(std::ssize(rates.r_dot), "body") + ", " +
                   counted(std::ssize(rates.theta_dot), "screw") + ">";
        });
    add_array(type, "r_dot", &Rates::r_dot, &rows_of<3>, "Velocities of the origins [bodies x 3, m/s].");
    add_array(
        type, "omega_local", &Rates::omega_local, &rows_of<3>, "Angular velocities ω′ [bodies x 3, rad/s].");
    add_array(type, "theta_dot", &Rates::theta_dot, &list_of, "Rates of the angles of screws [rad/s].");
    add_copies(type, kCopied);
}

}  // namespace

const Rates& rates_or_rest(const Rates* velocities, const Pose& pose, Rates& at_rest) {
    if (velocities != nullptr) { return *velocities; }
    at_rest.r_dot.assign(pose.r.size(), Vector3::Zero());
    at_rest.omega_local.assign(pose.r.size(), Vector3::Zero());
    at_rest.theta_dot.assign(pose.theta.size(), 0.0);
    return at_rest;
}

void add_poses(py::module_& module) {
    using namespace py::literals;
    add_pose(module);
    add_rates(module);
    py::class_<Moment>(module, "Moment", "A moment of a motion.")
        .def(
            py::init([](Pose pose, Rates velocity, Rates acceleration, double energy) {
                return Moment{std::move(pose), std::move(velocity), std::move(acceleration), energy};
            }),
            "pose"_a, "velocity"_a, "acceleration"_a, "energy"_a = 0.0)
        .def_readonly("pose", &Moment::pose)
        .def_readonly("velocity", &Moment::velocity)
        .def_readonly(
            "acceleration", &Moment::acceleration, "r̈, ω̇′ and θ̈; the members have the names for ṙ, ω′ and θ̇.")
        .def_readonly("energy", &Moment::energy, "Kinetic and potential [J]; 0 in `follow`.")
        .def("__repr__", [](const Moment& m) {
            return "<jointwise.Moment at t = " + py::str(py::float_(m.pose.t)).cast<std::string>() + " s>";
        });
    module.def(
        "start_pose", &start_pose, "mechanism"_a,
        "The start estimate, whether it satisfies the equations or not.");
    module.def("start_rates", &start_rates, "mechanism"_a, "The start velocities of the mechanism.");
}

}  // namespace jointwise::python
