#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "app/python/arrays.hpp"
#include "app/python/bindings.hpp"
#include "jointwise/lesson.hpp"

namespace jointwise::python {

void add_lessons(py::module_& module) {
    using namespace py::literals;
    py::class_<Lesson>(module, "Lesson", "A lesson that was read.")
        .def_property_readonly("title", &Lesson::title)
        .def_property_readonly("text", &Lesson::text)
        .def_property_readonly(
            "mechanism", &Lesson::mechanism, "A mechanism of its own; changing it changes no lesson.")
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
