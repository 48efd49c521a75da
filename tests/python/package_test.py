"""The package as a whole: its stubs, its words, its pictures."""

import ast
import inspect
import tempfile
import unittest
from pathlib import Path

import numpy as np

import jointwise as jw
from scenes import four_bar

# those names with underscores that users rely on
SPECIAL = {
    "__init__", "__len__", "__getitem__", "__iter__", "__copy__", "__deepcopy__", "__int__", "__index__", "__members__",
}
PACKAGE = Path(jw.__file__).parent


def stub_names():
    """Names in the stub: those of the module, and for each class its members."""
    module, classes = set(), {}
    for node in ast.parse((PACKAGE / "__init__.pyi").read_text(encoding="utf-8")).body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            module.add(node.name)  # of types alone: with an underscore
        if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
            members = {n.name for n in node.body if isinstance(n, ast.FunctionDef)}
            members |= {n.target.id for n in node.body if isinstance(n, ast.AnnAssign)}
            classes[node.name] = members
    return module, classes


def stub_arguments():
    """'Mechanism.add_body' -> names of its arguments, for every function and method."""
    found = {}

    def add(prefix, node):
        if isinstance(node, ast.FunctionDef) and not any(
            isinstance(d, (ast.Name, ast.Attribute)) and ast.unparse(d) in ("property", "overload") or
            ast.unparse(d).endswith(".setter") for d in node.decorator_list
        ):
            found[prefix + node.name] = [a.arg for a in node.args.args + node.args.kwonlyargs]
        if isinstance(node, ast.ClassDef):
            for inner in node.body:
                add(node.name + ".", inner)

    for node in ast.parse((PACKAGE / "__init__.pyi").read_text(encoding="utf-8")).body:
        add("", node)
    return found


class Package(unittest.TestCase):
    def test_stubs_name_what_there_is_and_nothing_else(self):
        module, classes = stub_names()
        self.assertEqual({name for name in module if not name.startswith("_")}, set(jw.__all__))
        for name, members in classes.items():
            cls = getattr(jw, name)
            own = {n for n in vars(cls) if not n.startswith("__") or n in SPECIAL}
            if issubclass(cls, Exception):
                continue
            with self.subTest(name=name):
                made_by_users = "__init__" in members
                expected = {n for n in own if n != "__init__" or made_by_users}
                self.assertEqual(members, expected)

    def test_stubs_name_arguments_as_the_module_does(self):
        for name, arguments in stub_arguments().items():
            target = jw
            for part in name.split("."):
                target = getattr(target, part)
            if inspect.isfunction(target):
                self.assertEqual(list(inspect.signature(target).parameters), arguments)
                continue
            # the first line of a docstring of pybind11: name(a: type, b: type = value) -> type
            signature = (target.__doc__ or "").split("\n")[0]
            for argument in arguments:
                if argument == "self" or name.startswith(("Trajectory.__", "Coordinates.__")):
                    continue
                with self.subTest(name=name, argument=argument):
                    self.assertRegex(signature, rf"[(,] ?{argument}: ")

    def test_everything_has_a_docstring(self):
        for name in jw.__all__:
            thing = getattr(jw, name)
            with self.subTest(name=name):
                # pybind11 writes the signature: the description comes after it
                said = [line for line in (thing.__doc__ or "").split("\n") if line and "->" not in line]
                self.assertTrue(any(len(line) > 15 for line in said))

    def test_things_say_what_they_are(self):
        m = four_bar()
        pose = jw.assemble(m)
        self.assertEqual(repr(m), "<jointwise.Mechanism: 3 bodies and the ground, 4 joints, 1 driver>")
        self.assertEqual(repr(pose), "<jointwise.Pose at t = 0.0 s: 4 bodies, 0 screws>")
        self.assertEqual(repr(jw.equations_at(m, pose)), "<jointwise.Equations: 24 rows, 21 columns>")
        self.assertEqual(repr(jw.rank_at(m, pose)), "<jointwise.Rank 18 of 21 x 18: freedoms 0, redundant 3>")
        self.assertEqual(repr(jw.follow(m, [0, 1])), "<jointwise.Trajectory: 2 times, 4 bodies>")

    def test_pictures_are_shown_by_notebooks_and_written_to_files(self):
        m = four_bar()
        image = jw.draw(m, jw.assemble(m), width=64, height=48)
        self.assertEqual(image.rgb.shape, (48, 64, 3))
        self.assertEqual(image.rgb.dtype, np.uint8)
        self.assertGreater(int(image.rgb.max()) - int(image.rgb.min()), 50)
        self.assertEqual(image._repr_png_()[:8], b"\x89PNG\r\n\x1a\n")
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "four-bar.png"
            image.write_png(file)
            self.assertEqual(file.read_bytes(), image.png())
        lesson = jw.read_lesson(jw.lesson_file("loops/four-bar"))
        for shown in (m, lesson):
            self.assertEqual(shown._repr_png_()[:4], b"\x89PNG")

    def test_what_cannot_be_assembled_is_still_shown(self):
        lesson = jw.read_lesson(jw.lesson_file("hard/cannot-close"))
        self.assertRaises(jw.NotReached, jw.assemble, lesson.mechanism)
        self.assertEqual(lesson._repr_png_()[:4], b"\x89PNG")

    def test_lessons_come_with_the_package(self):
        self.assertGreater(len(list(jw.lessons_folder().glob("*/*.toml"))), 40)


if __name__ == "__main__":
    unittest.main()
