#include <pybind11/stl.h>

#include "app/python/bindings.hpp"
#include "jointwise/lesson.hpp"

namespace jointwise::python {

namespace {

/// Raises the exception with the places of the mistakes, so that an editor need not parse the text.
void raise(const py::handle& type, const LessonError& error) {
    const py::object raised = type(error.what());
    raised.attr("mistakes") = py::cast(error.mistakes());
    const Mistake& first = error.mistakes().front();
    raised.attr("line") = first.line;
    raised.attr("column") = first.column;
    PyErr_SetObject(type.ptr(), raised.ptr());
}

}  // namespace

void add_errors(py::module_& module) {
    py::class_<Mistake>(
        module, "Mistake", "One mistake in a lesson; line and column count from 1, line 0 is the file.")
        .def_readonly("file", &Mistake::file)
        .def_readonly("line", &Mistake::line)
        .def_readonly("column", &Mistake::column)
        .def_readonly("code", &Mistake::code, "As `jointwise explain` takes it: 'JW201'.")
        .def_readonly("message", &Mistake::message)
        .def_readonly("hint", &Mistake::hint)
        .def("__repr__", [](const Mistake& m) {
            return "<jointwise.Mistake " + m.file + ":" + std::to_string(m.line) + ":" +
                   std::to_string(m.column) + ": " + m.message + " [" + m.code + "]>";
        });

    py::register_exception<NotReached>(module, "NotReached", PyExc_RuntimeError).doc() =
        "The numerics could not do it; the text names time and joint.";
    // the exceptions live as long as the interpreter: they must not be released after its end
    static py::handle lesson_error =
        py::exception<LessonError>(module, "LessonError", PyExc_ValueError).release();
    lesson_error.doc() =
        "Mistakes in a lesson: the report of the program. `mistakes` has them one by one, `line` and "
        "`column` are "
        "those of the first.";
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            std::rethrow_exception(std::move(thrown));
        } catch (const LessonError& error) { raise(lesson_error, error); }
    });
}

}  // namespace jointwise::python
