#include <pybind11/stl.h>

#include "app/python/arrays.hpp"
#include "app/python/bindings.hpp"

namespace jointwise::python {

namespace {

/// Writes the equations to `out`, whose views then show the new numbers; without `out`, to new Equations.
py::object written_equations(
    Evaluator& evaluator, const Pose& pose, const Rates* velocities, Equations* out) {
    Rates at_rest;
    const Rates& rates = rates_or_rest(velocities, pose, at_rest);
    if (out == nullptr) {
        auto made = std::make_unique<Equations>();
        evaluator.equations_at(pose, rates, *made);
        return py::cast(std::move(made));
    }
    // another size would reallocate the numbers, and views of them would dangle
    if (out->phi.size() != evaluator.rows() || out->jacobian.cols() != evaluator.columns()) {
        throw py::value_error(
            "jointwise: 'out' belongs to another mechanism or to other coordinates; expected Equations of "
            "this evaluator");
    }
    evaluator.equations_at(pose, rates, *out);
    return py::cast(out);  // the object that was given
}

Numbers phi_of(Evaluator& evaluator, const Pose& pose) {
    Eigen::VectorXd phi;
    evaluator.phi_at(pose, phi);
    return copied(phi);
}

/// Equations along a motion, and the size of Φq: each row of its table has rows × columns numbers.
struct AlongMotion : EquationsTable {
    py::ssize_t rows;
    py::ssize_t columns;
};

py::array jacobians_of(const py::object& self) {
    const auto& along = self.cast<const AlongMotion&>();
    return view_of(
        along.jacobian.data(), {along.jacobian.rows(), along.rows, along.columns},
        {along.rows * along.columns, along.columns, 1}, self, Access::read);
}

void add_along_motion(py::module_& module) {
    py::class_<AlongMotion> type(
        module, "EquationsTable",
        "Equations at all times of a motion: row-major views of its memory that cannot be written.");
    add_view(type, "phi", &EquationsTable::phi, "Φ [times x rows].");
    add_view(type, "nu", &EquationsTable::nu, "ν [times x rows].");
    add_view(type, "gamma", &EquationsTable::gamma, "γ [times x rows].");
    type.def_property_readonly("jacobian", &jacobians_of, "Φq [times x rows x columns].")
        .def("__repr__", [](const AlongMotion& along) {
            return "<jointwise.EquationsTable: " + counted(along.phi.rows(), "time") + ", " +
                   counted(along.rows, "row") + ", " + counted(along.columns, "column") + ">";
        });
}

}  // namespace

void add_evaluator(py::module_& module) {
    using namespace py::literals;
    add_along_motion(module);
    py::class_<Evaluator>(
        module, "Evaluator",
        "The equations of one mechanism at many poses: structure and memory are made once. Later "
        "changes to the mechanism do not affect them. Rows of p1 and p2 are chosen at the start pose; "
        "`choose_rows` chooses them at another one.")
        .def(
            py::init([](const Mechanism& mechanism, const py::object& coordinates) {
                return Evaluator(mechanism, coordinates_of(coordinates));
            }),
            "mechanism"_a, "coordinates"_a = Coordinates::modified_euler_parameters)
        .def_property_readonly("row_names", &Evaluator::row_names, "'hinge.p1.y', one per row.")
        .def_property_readonly(
            "column_names", &Evaluator::column_names,
            "'crank.x', 'crank.omega_local.z', 'jack.angle', one per column.")
        .def(
            "choose_rows", &Evaluator::choose_rows, "pose"_a,
            "Applies the rule of slide 5 at a pose. True if rows have changed.")
        .def(
            "equations_at", &written_equations, "pose"_a, "velocities"_a = py::none(), "out"_a = py::none(),
            "Φ, Φq, ν and γ. `out`: Equations of this evaluator to overwrite; views of them then show the "
            "new numbers.")
        .def(
            "equations_along",
            [](Evaluator& evaluator, const Trajectory& trajectory) {
                return std::make_unique<AlongMotion>(AlongMotion{
                    evaluator.equations_along(trajectory), evaluator.rows(), evaluator.columns()});
            },
            "trajectory"_a, "Φ, Φq, ν and γ at all times of a motion, with the current choice of rows.")
        .def("phi_at", &phi_of, "pose"_a, "Φ alone [rows].")
        .def(
            "columns_of",
            [](const Evaluator& evaluator, const Pose& pose, const Rates& rates) {
                return copied(evaluator.columns_of(pose, rates));
            },
            "pose"_a, "rates"_a,
            "Velocities as the numbers of the columns: ṙ and ṗ, ω′ or ω of every moving body, then θ̇.")
        .def("assemble", &Evaluator::assemble, "estimate"_a, "t"_a = 0.0)
        .def("rank_at", &Evaluator::rank_at, "pose"_a)
        .def("velocities_at", &Evaluator::velocities_at, "pose"_a)
        .def("accelerations_at", &Evaluator::accelerations_at, "pose"_a, "velocities"_a)
        .def("__repr__", [](const Evaluator& e) {
            return "<jointwise.Evaluator: " + counted(e.rows(), "row") + ", " +
                   counted(e.columns(), "column") + ">";
        });
}

}  // namespace jointwise::python
