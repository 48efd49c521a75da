#pragma once

#include <pybind11/pybind11.h>

#include "jointwise/evaluator.hpp"

/// The parts of the module, in the order in which module.cpp adds them: each adds types that later ones use.
namespace jointwise::python {

namespace py = pybind11;

void add_errors(py::module_& module);
void add_mechanism(py::module_& module);
void add_poses(py::module_& module);
void add_equations(py::module_& module);
void add_evaluator(py::module_& module);
void add_motion(py::module_& module);
void add_measures(py::module_& module);
void add_statics(py::module_& module);
void add_lessons(py::module_& module);
void add_pictures(py::module_& module);
void add_films(py::module_& module);

/// Calls `f` while other Python threads may run. `f` uses nothing that belongs to Python, and owns its
/// arguments.
template <class F>
auto in_parallel(F&& f) {
    const py::gil_scoped_release release;
    return std::forward<F>(f)();
}

/// Calls `f` like `in_parallel`, with a callback that `f` must call regularly. The callback returns false if
/// a signal asks Python to stop, such as Ctrl-C or the interruption of a notebook. An exception of the
/// signal's handler then takes precedence over the NotReached with which `f` ends.
template <class F>
auto until_interrupted(F&& f) {
    bool interrupted = false;
    const std::function<bool()> go_on = [&] {
        const py::gil_scoped_acquire acquire;
        return !(interrupted = PyErr_CheckSignals() != 0);
    };
    try {
        return in_parallel([&] { return f(go_on); });
    } catch (const NotReached&) {
        if (interrupted) { throw py::error_already_set(); }
        throw;
    }
}

/// An argument `coordinates`: a member of Coordinates or its name. @throws py::value_error
Coordinates coordinates_of(const py::object& value);

/// An argument `velocities`: None means rest. @return the argument itself, or the filled `at_rest`
const Rates& rates_or_rest(const Rates* velocities, const Pose& pose, Rates& at_rest);

/// "4 bodies": a count in words for __repr__.
std::string counted(py::ssize_t count, const char* thing);

/// Adds the ways in which Python copies an object. @param doc  of `copy`
template <class T>
void add_copies(py::class_<T>& type, const char* doc) {
    const auto copied = [](const T& self) { return T(self); };
    type.def("copy", copied, doc)
        .def("__copy__", copied)
        .def("__deepcopy__", [](const T& self, const py::dict&) { return T(self); });
}

}  // namespace jointwise::python
