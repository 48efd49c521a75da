#include <pybind11/stl.h>

#include "app/python/arrays.hpp"
#include "app/python/bindings.hpp"

namespace jointwise::python {

namespace {

/// Number of the body or joint that an argument gives by its number or by its name.
/// @throws py::value_error for an unknown name, py::type_error for an argument that is neither
int number_of(const py::object& value, const std::vector<std::string>& names, const std::string& what) {
    if (!py::isinstance<py::str>(value)) {
        const long number = PyIndex_Check(value.ptr()) != 0 ? PyLong_AsLong(py::int_(value).ptr()) : -1;
        if (PyErr_Occurred() != nullptr) { throw py::error_already_set(); }
        if (PyIndex_Check(value.ptr()) == 0 || number != static_cast<int>(number)) {
            throw py::type_error("jointwise: expected the number or the name of a " + what);
        }
        return static_cast<int>(number);
    }
    const auto name = value.cast<std::string>();
    std::string all;
    for (std::size_t k = 0; k < names.size(); ++k) {
        if (names[k] == name) { return static_cast<int>(k); }
        all += (k == 0 ? "" : ", ") + names[k];
    }
    throw py::value_error("jointwise: there is no " + what + " '" + name + "'; expected one of " + all);
}

int body_of(const Mechanism& m, const py::object& value) { return number_of(value, m.body_names(), "body"); }

int add_joint(
    Mechanism& m, const std::string& name, const std::string& type, const py::object& body_i,
    const py::object& body_j, const py::object& at, const py::object& to, const py::object& axis,
    const py::object& axis2, const py::object& side, const std::optional<double>& pitch,
    const std::optional<double>& ratio, const std::optional<double>& radius, const py::object& curve) {
    Place place;
    place.at = vector_of<3>(at, "at");
    place.to = optional_vector_of(to, "to");
    place.axis = vector_of<3>(axis, "axis");
    place.axis2 = optional_vector_of(axis2, "axis2");
    place.side = optional_vector_of(side, "side");
    place.pitch = pitch;
    place.ratio = ratio;
    place.radius = radius;
    if (!curve.is_none()) {
        for (const py::handle point : curve) {
            place.curve.push_back(
                vector_of<3>(py::reinterpret_borrow<py::object>(point), "a point of curve"));
        }
    }
    return m.add_joint(name, type, body_of(m, body_i), body_of(m, body_j), place);
}

std::string text_of(const Mechanism& m) {
    return "<jointwise.Mechanism: " + counted(std::ssize(m.body_names()) - 1, "body") + " and the ground, " +
           counted(std::ssize(m.joint_names()), "joint") + ", " +
           counted(std::ssize(m.driver_names()), "driver") + ">";
}

void add_building(py::class_<Mechanism>& type) {
    using namespace py::literals;
    const auto zero = py::make_tuple(0.0, 0.0, 0.0);
    type.def(
            "add_body",
            [](Mechanism& m, const std::string& name, const py::object& r, const py::object& p) {
                return m.add_body(name, vector_of<3>(r, "r"), vector_of<4>(p, "p"));
            },
            "name"_a, "r"_a, "p"_a = py::make_tuple(1.0, 0.0, 0.0, 0.0),
            "Adds a moving body at its start estimate: r [m] and Euler parameters p = (e0, e1, e2, e3). "
            "Returns its number.")
        .def(
            "add_joint", &add_joint, "name"_a, "type"_a, "body_i"_a, "body_j"_a, py::kw_only(), "at"_a = zero,
            "to"_a = py::none(), "axis"_a = py::make_tuple(0.0, 0.0, 1.0), "axis2"_a = py::none(),
            "side"_a = py::none(), "pitch"_a = py::none(), "ratio"_a = py::none(), "radius"_a = py::none(),
            "curve"_a = py::none(),
            "Adds a joint of a type of `joint_types()` between two bodies, given by number or name. The "
            "place is global, at the start pose: point `at` of the first body and `to` of the second (None: "
            "the same) [m], `axis` of both and `axis2` of the second where it has another, `side` where "
            "angles begin, `pitch` of a screw [m per turn], `ratio` of a gear or a belt (turns of the second "
            "wheel in one of the first), `radius` of the wheel on a rack [m], `curve`: points of a closed "
            "curve in the frame of the first body [m]. Returns its number.")
        .def(
            "add_driver",
            [](Mechanism& m, const std::string& name, const py::object& joint, const py::object& value) {
                return m.add_driver(
                    name, number_of(joint, m.joint_names(), "joint"), list_of(value, "value"));
            },
            "name"_a, "joint"_a, "value"_a,
            "Prescribes the angle of a joint [rad], or where it has none its displacement [m], as c0 + c1 t "
            "+ c2 t² + ...: `value` is [c0, c1, ...]. Returns its number.");
}

void add_forces(py::class_<Mechanism>& type) {
    using namespace py::literals;
    const auto zero = py::make_tuple(0.0, 0.0, 0.0);
    type.def(
            "set_velocity",
            [](Mechanism& m, const py::object& body, const py::object& r_dot, const py::object& omega_local) {
                m.set_velocity(
                    body_of(m, body), vector_of<3>(r_dot, "r_dot"), vector_of<3>(omega_local, "omega_local"));
            },
            "body"_a, "r_dot"_a, "omega_local"_a,
            "Velocity of a body at the start: of its origin [m/s], and its angular velocity in its own frame "
            "[rad/s].")
        .def(
            "set_mass",
            [](Mechanism& m, const py::object& body, double mass, const py::object& J_local,
               const py::object& centre) {
                m.set_mass(
                    body_of(m, body), mass, matrix_of(J_local, "J_local"),
                    vector_of<3>(centre, "centre_local"));
            },
            "body"_a, "mass"_a, "J_local"_a, "centre_local"_a = zero,
            "Mass [kg], 3 x 3 inertia about the centre of mass in axes of the body [kg m²], centre in its "
            "frame [m].")
        .def(
            "set_gravity", [](Mechanism& m, const py::object& g) { m.set_gravity(vector_of<3>(g, "g")); },
            "g"_a, "Gravity, global [m/s²].")
        .def(
            "add_spring",
            [](Mechanism& m, const py::object& body_i, const py::object& P_i_local, const py::object& body_j,
               const py::object& P_j_local, double k, double free_length, double c) {
                m.add_spring(
                    body_of(m, body_i), vector_of<3>(P_i_local, "P_i_local"), body_of(m, body_j),
                    vector_of<3>(P_j_local, "P_j_local"), k, free_length, c);
            },
            "body_i"_a, "P_i_local"_a, "body_j"_a, "P_j_local"_a, "k"_a, "free_length"_a, "c"_a = 0.0,
            "Spring and damper between two points in the frames of their bodies [m]: f = k (l - free_length) "
            "+ c dl/dt; k [N/m], c [N s/m].");
}

}  // namespace

std::string counted(py::ssize_t count, const char* thing) {
    std::string plural = std::string(thing) + "s";
    if (plural == "bodys") { plural = "bodies"; }
    return std::to_string(count) + " " + (count == 1 ? thing : plural);
}

void add_mechanism(py::module_& module) {
    py::class_<Mechanism> type(
        module, "Mechanism",
        "Bodies, joints and drivers as data. Bodies, joints and drivers have numbers in the order in which "
        "they were added; body 0 is the ground. An invalid argument raises ValueError and changes nothing.");
    type.def(py::init<>())
        .def_property_readonly("body_names", &Mechanism::body_names)
        .def_property_readonly("joint_names", &Mechanism::joint_names)
        .def_property_readonly("driver_names", &Mechanism::driver_names)
        .def("__repr__", &text_of);
    add_copies(type, "An independent copy.");
    add_building(type);
    add_forces(type);
    module.def(
        "joint_types", &joint_types,
        "Names of the joint types that `add_joint` takes: all but 'formula', whose equation is text in a "
        "lesson.");
}

}  // namespace jointwise::python
