#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "app/python/arrays.hpp"
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
        "The numerical methods did not reach a result; the message names the time and the joint.";
    // the exceptions live as long as the interpreter: they must not be released after its end
    static py::handle lesson_error =
        py::exception<LessonError>(module, "LessonError", PyExc_ValueError).release();
    lesson_error.doc() =
        "Mistakes in a lesson: the report of the program. `mistakes` has them one by one, `line` and "
        "`column` are those of the first.";
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            std::rethrow_exception(std::move(thrown));
        } catch (const LessonError& error) { raise(lesson_error, error); }
    });
}

void add_lessons(py::module_& module) {
    using namespace py::literals;
    py::class_<Lesson>(module, "Lesson", "A lesson that was read.")
        .def_property_readonly("title", &Lesson::title)
        .def_property_readonly("text", &Lesson::text)
        .def_property_readonly(
            "mechanism", &Lesson::mechanism,
            "A copy of the lesson's mechanism; changes to it do not affect the lesson.")
        .def_property_readonly(
            "warnings", &Lesson::warnings, "Warnings of the reader; empty if there are none.")
        .def_property_readonly(
            "motion_times", [](const Lesson& lesson) { return copied_list(lesson.motion_times()); },
            "Times of the motion that the lesson shows [s]; empty if it shows none.")
        .def_property_readonly(
            "simulation_times", [](const Lesson& lesson) { return copied_list(lesson.simulation_times()); },
            "Times of its motion by masses and forces [s]; empty if there are none.")
        .def_property_readonly(
            "simulation",
            [](const Lesson& lesson) {
                const Simulation own = lesson.simulation();
                return py::dict("method"_a = own.method, "tolerance"_a = own.tolerance, "step"_a = own.step);
            },
            "Arguments `method`, `tolerance` and `step` of simulate that the lesson asks for.")
        .def("__repr__", [](const Lesson& lesson) { return "<jointwise.Lesson '" + lesson.title() + "'>"; });
    module.def("read_lesson", &read_lesson, "file"_a, "Reads a lesson file. Raises LessonError.");
    module.def(
        "read_lesson_text", &read_lesson_text, "toml"_a, "name"_a = "lesson.toml",
        "Reads a lesson from text; messages call it `name`. Raises LessonError.");
}

}  // namespace jointwise::python
