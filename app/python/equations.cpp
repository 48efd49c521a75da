#include <pybind11/stl.h>

#include <array>

#include "app/python/arrays.hpp"
#include "app/python/bindings.hpp"

namespace jointwise::python {

namespace {

struct CoordinatesName {
    const char* name;
    Coordinates coordinates;
    const char* doc;
};

constexpr std::array kCoordinates{
    CoordinatesName{"true_euler_parameters", Coordinates::true_euler_parameters, "(r, p), slide 21"},
    CoordinatesName{"modified_euler_parameters", Coordinates::modified_euler_parameters, "(r, p), slide 22"},
    CoordinatesName{"omega_local", Coordinates::omega_local, "(r, ω′), slide 20"},
    CoordinatesName{"omega_global", Coordinates::omega_global, "(r, ω)"}};

void add_coordinates(py::module_& module) {
    py::enum_<Coordinates> type(
        module, "Coordinates",
        "Coordinates that equations are written in; functions take their names as well.");
    for (const CoordinatesName& entry : kCoordinates) {
        type.value(entry.name, entry.coordinates, entry.doc);
    }
}

void add_results(py::module_& module) {
    py::class_<Equations> equations(
        module, "Equations",
        "Φ, Φq and the right sides of Φq q̇ = ν and Φq q̈ = γ. The arrays are views of its memory that cannot "
        "be written.");
    equations.def_readonly("rows", &Equations::rows, "'hinge.p1.y', one per row.")
        .def("__repr__", [](const Equations& e) {
            return "<jointwise.Equations: " + counted(std::ssize(e.rows), "row") + ", " +
                   counted(e.jacobian.cols(), "column") + ">";
        });
    add_view(equations, "phi", &Equations::phi, "Φ [rows].");
    add_view(equations, "jacobian", &Equations::jacobian, "Φq [rows x columns], column-major.");
    add_view(equations, "nu", &Equations::nu, "ν = -Φ_t [rows].");
    add_view(equations, "gamma", &Equations::gamma, "γ [rows].");

    py::class_<Rank> rank(module, "Rank", "Verdict on the rank of Φq at a pose, in (r, ω′) coordinates.");
    rank.def_readonly("rows", &Rank::rows)
        .def_readonly("columns", &Rank::columns)
        .def_readonly("rank", &Rank::rank)
        .def_readonly("freedoms", &Rank::freedoms, "columns - rank")
        .def_readonly("redundant", &Rank::redundant, "rows - rank")
        .def_readonly("by_counting", &Rank::by_counting, "Freedoms after Grübler.")
        .def_readonly(
            "decided", &Rank::decided, "False: a singular value is within its error of the threshold.")
        .def_readonly("redundant_rows", &Rank::redundant_rows, "Their names.")
        .def("__repr__", [](const Rank& r) {
            return "<jointwise.Rank " + std::to_string(r.rank) + " of " + std::to_string(r.rows) + " x " +
                   std::to_string(r.columns) + ": freedoms " + std::to_string(r.freedoms) + ", redundant " +
                   std::to_string(r.redundant) + (r.decided ? ">" : ", undecided>");
        });
    add_view(
        rank, "singular_values", &Rank::singular_values,
        "Of Φq scaled, largest first; empty for very large mechanisms.");
    add_view(
        rank, "free_motions", &Rank::free_motions, "Null space of Φq [columns x freedoms], column-major.");
}

Equations equations_of(
    const Mechanism& mechanism, const Pose& pose, const Rates* velocities, const py::object& coordinates) {
    Rates at_rest;
    return equations_at(
        mechanism, pose, rates_or_rest(velocities, pose, at_rest), coordinates_of(coordinates));
}

}  // namespace

Coordinates coordinates_of(const py::object& value) {
    if (py::isinstance<Coordinates>(value)) { return value.cast<Coordinates>(); }
    const std::string name = py::isinstance<py::str>(value) ? value.cast<std::string>() : "";
    std::string all;
    for (const CoordinatesName& entry : kCoordinates) {
        if (name == entry.name) { return entry.coordinates; }
        all += (all.empty() ? "" : ", ") + std::string(entry.name);
    }
    throw py::value_error(
        "jointwise: there are no coordinates " + py::repr(value).cast<std::string>() + "; expected one of " +
        all);
}

void add_equations(py::module_& module) {
    using namespace py::literals;
    add_coordinates(module);
    add_results(module);
    module.def(
        "equations_at", &equations_of, "mechanism"_a, "pose"_a, "velocities"_a = py::none(),
        "coordinates"_a = Coordinates::modified_euler_parameters,
        "Equations of all joints and drivers at a pose; the columns are seven or six of each moving body, "
        "then the angles of screws. Without velocities γ is that of rest.");
    module.def(
        "assemble",
        [](Mechanism mechanism, double t) { return in_parallel([&] { return assemble(mechanism, t); }); },
        "mechanism"_a, "t"_a = 0.0,
        "Assembles the mechanism at a time [s], from the start estimate: Φ(q, t) = 0. Raises NotReached.");
    module.def(
        "assemble",
        [](Mechanism mechanism, Pose estimate, double t) {
            return in_parallel([&] { return assemble(mechanism, estimate, t); });
        },
        "mechanism"_a, "estimate"_a, "t"_a = 0.0,
        "Assembles the mechanism at a time [s], from the given estimate. Raises NotReached.");
    module.def(
        "rank_at",
        [](Mechanism mechanism, Pose pose) { return in_parallel([&] { return rank_at(mechanism, pose); }); },
        "mechanism"_a, "pose"_a, "Rank of Φq at a pose, in (r, ω′) coordinates.");
    module.def(
        "velocities_at", &velocities_at, "mechanism"_a, "pose"_a,
        "Velocities with Φq q̇ = ν; the smallest ones if the equations do not determine them. Raises "
        "NotReached if equations contradict each other.");
    module.def(
        "accelerations_at", &accelerations_at, "mechanism"_a, "pose"_a, "velocities"_a,
        "Accelerations with Φq q̈ = γ, returned as Rates; the smallest ones if the equations do not determine "
        "them.");
}

}  // namespace jointwise::python
