#include <pybind11/stl.h>

#include "app/python/arrays.hpp"
#include "app/python/bindings.hpp"
#include "jointwise/measures.hpp"

namespace jointwise::python {

namespace {

/// The table as an array that owns it.
py::array array_of(Table table) {
    auto owned = std::make_unique<Table>(std::move(table));
    const Table& numbers = *owned;
    const py::capsule owner(owned.release(), [](void* p) { delete static_cast<Table*>(p); });
    return view_of(
        numbers.data(), {numbers.rows(), numbers.cols()}, {numbers.cols(), 1}, owner, Access::write);
}

void add_quantities(py::module_& module) {
    using namespace py::literals;
    py::class_<Quantities>(
        module, "Quantities",
        "Quantities of one mechanism by their names, as docs/quantities.md lists them: 'crank.x', "
        "'hinge.angle_dot', '|hinge.force|', 'energy.sum'. SI units and radians; NaN where there is no "
        "value.")
        .def(py::init<const Mechanism&, const std::vector<std::string>&>(), "mechanism"_a, "names"_a)
        .def_property_readonly("names", &Quantities::names, "The current names.")
        .def_property_readonly("units", &Quantities::units, "'rad/s', 'N m'; '1' where a number has no unit.")
        .def(
            "at",
            [](const Quantities& quantities, const Moment& moment) { return copied(quantities.at(moment)); },
            "moment"_a, "One value per name.")
        .def(
            "along", [](const Quantities& q, const Trajectory& motion) { return array_of(q.along(motion)); },
            "trajectory"_a,
            "Values [times x names]. Turns of rotational springs are counted from row to row.")
        .def("__repr__", [](const Quantities& quantities) {
            std::string all;
            for (const std::string& name : quantities.names()) { all += (all.empty() ? " " : ", ") + name; }
            return "<jointwise.Quantities" + all + ">";
        });
    module.def(
        "quantity_names", &quantity_names, "mechanism"_a,
        "The names of all quantities of a mechanism, except those that need a point or a direction.");
}

void add_reactions(py::module_& module) {
    using namespace py::literals;
    py::class_<Reaction> reaction(
        module, "Reaction",
        "Force and torque of a joint or driver on its body j; the opposite acts on body i at the same point. "
        "Global.");
    reaction.def_readonly("name", &Reaction::name)
        .def_readonly("of_driver", &Reaction::of_driver)
        .def_readonly("body_i", &Reaction::body_i)
        .def_readonly("body_j", &Reaction::body_j)
        .def_readonly(
            "force_unique", &Reaction::force_unique, "True if x, y, z are the same in every solution.")
        .def_readonly("torque_unique", &Reaction::torque_unique)
        .def_readonly("effort", &Reaction::effort, "Of a driver: effort times rate is its power [N, N m].")
        .def("__repr__", [](const Reaction& r) { return "<jointwise.Reaction of " + r.name + ">"; });
    add_view(reaction, "point", &Reaction::point, "On body j [m].");
    add_view(reaction, "force", &Reaction::force, "[N]");
    add_view(reaction, "torque", &Reaction::torque, "About the point [N m].");

    py::class_<Reactions>(
        module, "Reactions",
        "Reactions of a motion; the smallest ones if redundant equations leave them undetermined.")
        .def_readonly("reactions", &Reactions::reactions, "Of joints, then of drivers.")
        .def_readonly("open", &Reactions::open, "Independent reactions that can be added without any motion.")
        .def_readonly(
            "residual", &Reactions::residual, "Part of M q̈ - Q that no reaction explains, relative.")
        .def_readonly("bound", &Reactions::bound, "Largest residual that rounding explains.")
        .def("__repr__", [](const Reactions& r) {
            return "<jointwise.Reactions: " + counted(std::ssize(r.reactions), "reaction") +
                   (r.open > 0 ? ", not unique>" : ">");
        });
    module.def(
        "reactions_at", &reactions_at, "mechanism"_a, "moment"_a,
        "Reactions at a moment of a motion. Every moving body needs a mass.");
}

}  // namespace

void add_measures(py::module_& module) {
    add_quantities(module);
    add_reactions(module);
}

}  // namespace jointwise::python
