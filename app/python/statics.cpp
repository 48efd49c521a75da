#include <pybind11/complex.h>
#include <pybind11/stl.h>

#include "app/python/bindings.hpp"
#include "jointwise/statics.hpp"

namespace jointwise::python {

namespace {

void add_small_motion(py::module_& module) {
    py::class_<SmallMotion>(
        module, "SmallMotion",
        "A small motion about an equilibrium: the real part of exp(s t) (shape + i shape_late) is added to "
        "the pose. Its largest movement is 1.")
        .def_readonly(
            "s", &SmallMotion::s, "[1/s]; its imaginary part, 0 or positive, is the angular frequency.")
        .def_readonly("shape", &SmallMotion::shape, "Movements [m], turns in the frames of the bodies [rad].")
        .def_readonly("shape_late", &SmallMotion::shape_late, "The same, a quarter of a period later.")
        .def("__repr__", [](const SmallMotion& motion) {
            return "<jointwise.SmallMotion: s = " + py::repr(py::cast(motion.s)).cast<std::string>() +
                   " 1/s>";
        });
}

}  // namespace

void add_statics(py::module_& module) {
    using namespace py::literals;
    add_small_motion(module);
    py::class_<Equilibrium>(
        module, "Equilibrium", "A pose at which a mechanism stays at rest under its loads.")
        .def_readonly("moment", &Equilibrium::moment, "At rest at t = 0; `reactions_at` takes it.")
        .def_property_readonly(
            "stable",
            [](const Equilibrium& found) -> py::object {
                if (found.stability == Stability::not_known) { return py::none(); }
                return py::bool_(found.stability == Stability::stable);
            },
            "True, False, or None if it is not known.")
        .def_readonly(
            "small_motions", &Equilibrium::small_motions, "Growing ones first, then from slow to fast.")
        .def_readonly("freedoms", &Equilibrium::freedoms)
        .def_readonly("steps", &Equilibrium::steps, "Steps of the search.")
        .def_readonly(
            "residual", &Equilibrium::residual,
            "Largest force or torque that is left over on a body, relative to the loads and reactions on it.")
        .def("__repr__", [](const Equilibrium& found) {
            return "<jointwise.Equilibrium: " + counted(found.freedoms, "freedom") +
                   (found.stability == Stability::stable     ? ", stable>"
                    : found.stability == Stability::unstable ? ", unstable>"
                                                             : ", stability not known>");
        });
    module.def(
        "find_equilibrium",
        [](Mechanism mechanism, bool nearest) {
            const Seek seek = nearest ? Seek::nearest : Seek::where_it_rests;
            return in_parallel([&] { return find_equilibrium(mechanism, seek); });
        },
        "mechanism"_a, py::kw_only(), "nearest"_a = false,
        "Equilibrium of the assembled mechanism under its loads, to which these push it from the start; with "
        "`nearest` the one to which Newton's method leads, stable or not. Drivers keep their values at t = "
        "0. Every moving body needs a mass. Raises NotReached.");
}

}  // namespace jointwise::python
