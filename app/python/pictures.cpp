#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "app/python/arrays.hpp"
#include "app/python/bindings.hpp"
#include "jointwise/picture.hpp"

namespace jointwise::python {

namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 720;
// for pictures without a requested size: half the width of a notebook's page
constexpr int kInlineWidth = 640;
constexpr int kInlineHeight = 360;

py::bytes png_bytes(const Image& image) {
    const std::vector<std::uint8_t> bytes = png_of(image);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

py::array pixels(const py::object& self) {
    const auto& image = self.cast<const Image&>();
    py::array_t<std::uint8_t> array({image.height, image.width, 3}, image.rgb.data(), self);
    py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}

/// @param what  a Mechanism or a Lesson
template <class T>
Image drawn(T what, Pose pose, int width, int height) {
    return in_parallel([&] { return draw(what, pose, width, height); });
}

const Mechanism& mechanism_of(const Mechanism& mechanism) { return mechanism; }
const Mechanism& mechanism_of(const Lesson& lesson) { return lesson.mechanism(); }

/// Picture for a notebook: the assembled mechanism, or the start pose if it cannot be assembled.
template <class T>
py::bytes inline_png(const T& what) {
    Pose pose = start_pose(mechanism_of(what));
    try {
        pose = assemble(mechanism_of(what));
    } catch (const NotReached&) {
        // the start estimate shows what does not fit
    }
    return png_bytes(drawn(what, pose, kInlineWidth, kInlineHeight));
}

}  // namespace

void add_pictures(py::module_& module) {
    using namespace py::literals;
    py::class_<Image>(module, "Image", "A picture in RGB; notebooks show it.")
        .def_readonly("width", &Image::width)
        .def_readonly("height", &Image::height)
        .def_property_readonly(
            "rgb", &pixels, "[height x width x 3], 8 bits a channel, top row first; a view.")
        .def("png", &png_bytes, "The bytes of a PNG file.")
        .def("_repr_png_", &png_bytes)
        .def(
            "write_png",
            [](const Image& image, const std::filesystem::path& file) { write_png(image, file); }, "file"_a,
            "Writes a PNG file completely or not at all.")
        .def("__repr__", [](const Image& image) {
            return "<jointwise.Image " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                   ">";
        });
    module.def(
        "draw", &drawn<Mechanism>, "mechanism"_a, "pose"_a, "width"_a = kWidth, "height"_a = kHeight,
        "A mechanism at a pose, drawn without a display.");
    module.def(
        "draw", &drawn<Lesson>, "lesson"_a, "pose"_a, "width"_a = kWidth, "height"_a = kHeight,
        "A lesson at a pose, with its shapes and colours, from the direction that it asks for.");
    const py::object mechanism = module.attr("Mechanism");
    mechanism.attr("_repr_png_") = py::cpp_function(&inline_png<Mechanism>, py::is_method(mechanism));
    const py::object lesson = module.attr("Lesson");
    lesson.attr("_repr_png_") = py::cpp_function(&inline_png<Lesson>, py::is_method(lesson));
}

}  // namespace jointwise::python
