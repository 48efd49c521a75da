#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cstdio>

#include "app/python/bindings.hpp"
#include "jointwise/film.hpp"

namespace jointwise::python {

namespace {

constexpr double kBytesOfMegabyte = 1e6;

void save(Film film, const std::filesystem::path& file) {
    until_interrupted([&](const std::function<bool()>& go_on) { film.save(file, go_on); });
}

/// "8.3 s, 250 pictures of 960 x 540, 0.8 MB"
std::string size_text(const Film& film, std::size_t bytes) {
    char numbers[64];
    std::snprintf(numbers, sizeof numbers, "%.1f s, ", film.seconds());
    std::string text = numbers + counted(film.pictures(), "picture") + " of " +
                       std::to_string(film.options().width) + " x " + std::to_string(film.options().height);
    std::snprintf(numbers, sizeof numbers, ", %.1f MB", static_cast<double>(bytes) / kBytesOfMegabyte);
    return text + numbers;
}

/// The film as an HTML element that needs no other file: an APNG, which all browsers play, with its size.
std::string html_of(const Film& film) {
    const py::object folder = py::module_::import("tempfile").attr("TemporaryDirectory")();
    const py::object path =
        py::module_::import("pathlib").attr("Path")(folder.attr("name")) / py::str("film.apng");
    save(film, path.cast<std::filesystem::path>());
    const py::bytes bytes = path.attr("read_bytes")();
    const auto data =
        py::module_::import("base64").attr("b64encode")(bytes).attr("decode")().cast<std::string>();
    folder.attr("cleanup")();
    const std::string size = size_text(film, py::len(bytes));
    return "<figure><img src=\"data:image/apng;base64," + data + "\" width=\"" +
           std::to_string(film.options().width) + "\" height=\"" + std::to_string(film.options().height) +
           "\" style=\"max-width: 100%; height: auto\" alt=\"film, " + size + "\"><figcaption>" + size +
           "</figcaption></figure>";
}

std::unique_ptr<Film> film_of(
    Lesson lesson, const std::string& from, const std::string& to, double fps, bool loop, bool tween,
    bool dark, double text, const std::optional<std::array<double, 3>>& camera, bool panels, bool transparent,
    int width, int height) {
    const FilmOptions options{from, to,     fps,    loop,        tween, dark,
                              text, camera, panels, transparent, width, height};
    return in_parallel([&] { return std::make_unique<Film>(lesson, options); });
}

}  // namespace

void add_films(py::module_& module) {
    using namespace py::literals;
    py::class_<Film>(
        module, "Film",
        "A lesson as a film, made by Lesson.film; notebooks show it. Pictures are drawn when it is shown or "
        "saved.")
        .def_property_readonly("seconds", &Film::seconds, "How long it takes [s].")
        .def_property_readonly("pictures", &Film::pictures, "How many pictures it has.")
        .def_property_readonly(
            "width", [](const Film& film) { return film.options().width; }, "Pixels.")
        .def_property_readonly(
            "height", [](const Film& film) { return film.options().height; }, "Pixels.")
        .def(
            "save", &save, "file"_a,
            "Writes the film completely or not at all. The extension selects the format: .gif, .apng, .html, "
            "or with ffmpeg .mp4, .webm (and a file of captions beside them). Ctrl-C interrupts it.")
        .def("_repr_html_", &html_of)
        .def("__repr__", [](const Film& film) {
            return "<jointwise.Film: " + counted(film.pictures(), "picture") + ">";
        });
    const FilmOptions usual;
    const py::object lesson = module.attr("Lesson");
    lesson.attr("film") = py::cpp_function(
        &film_of, py::name("film"), py::is_method(lesson), py::kw_only(), "from_"_a = usual.from,
        "to"_a = usual.to, "fps"_a = usual.fps, "loop"_a = usual.loop, "tween"_a = usual.tween,
        "dark"_a = usual.dark, "text"_a = usual.text, "camera"_a = usual.camera, "panels"_a = usual.panels,
        "transparent"_a = usual.transparent, "width"_a = usual.width, "height"_a = usual.height,
        "The lesson as a Film, as `jointwise render` makes it. `from_` and `to` are steps: a number from 1, "
        "a joint or driver, or 't=0.5'; `camera` is the direction in which the eye is. Raises ValueError.");
}

}  // namespace jointwise::python
