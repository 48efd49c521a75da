"""Errors of the module: the words of the program, as the exceptions that Python expects."""

import unittest

import numpy as np

import jointwise as jw
from scenes import four_bar, pendulum, two_bodies


class Errors(unittest.TestCase):
    def test_arguments_that_make_no_sense_are_value_errors_and_change_nothing(self):
        m = jw.Mechanism()
        m.add_body("one", [1, 0, 0])
        m.add_body("two", [2, 0, 0])
        m.add_joint("ball", "spherical", "one", "two")
        for words, call in (
            ("'one' is taken", lambda: m.add_body("one", [0, 0, 0])),
            ("r has 2 numbers; expected 3", lambda: m.add_body("x", [0, 0])),
            ("r is not an array of numbers", lambda: m.add_body("x", ["a", "b", "c"])),
            ("r is not an array of numbers", lambda: m.add_body("x", [[1, 2], [3]])),
            ("not finite", lambda: m.add_body("x", [np.nan, 0, 0])),
            ("no joint type 'revolut'", lambda: m.add_joint("x", "revolut", 0, 1)),
            ("no body 3; the last is 2", lambda: m.add_joint("x", "revolute", 0, 3)),
            ("no body 'tree'; expected one of ground, one, two", lambda: m.add_joint("x", "revolute", 0, "tree")),
            ("axis is zero", lambda: m.add_joint("x", "revolute", 0, 1, axis=[0, 0, 0])),
            ("axis2 is absent", lambda: m.add_joint("x", "universal", 0, 1)),
            ("pitch is absent", lambda: m.add_joint("x", "screw", 0, 1)),
            ("'ball' has no angle", lambda: m.add_driver("x", "ball", [1])),
            ("no joint 'x'", lambda: m.add_driver("x", "x", [1])),
            ("value is not a list of numbers", lambda: m.add_driver("x", "ball", 3.0)),
            ("not positive", lambda: m.set_mass(1, 0, np.eye(3))),
            ("J_local is not a 3 x 3 matrix", lambda: m.set_mass(1, 1, [1, 1, 1])),
        ):
            with self.subTest(words=words), self.assertRaisesRegex(ValueError, words):
                call()
        self.assertEqual(m.body_names, ["ground", "one", "two"])
        self.assertEqual(m.joint_names, ["ball"])
        self.assertEqual(m.driver_names, [])

    def test_poses_and_times_that_do_not_fit_are_value_errors(self):
        m = four_bar()
        other = jw.start_pose(pendulum())
        evaluator = jw.Evaluator(m)
        small = jw.Evaluator(two_bodies("spherical")[0]).equations_at(jw.start_pose(two_bodies("spherical")[0]))
        pose = jw.start_pose(m)
        for words, call in (
            ("r of a pose has 2 entries; expected 4", lambda: jw.rank_at(m, other)),
            ("ascending", lambda: jw.follow(m, [1, 0])),
            ("no times", lambda: jw.follow(m, [])),
            ("expected one of euler", lambda: jw.simulate(pendulum(), [0, 1], method="rk5")),
            ("mass", lambda: jw.simulate(m, [0, 1])),
            ("no coordinates 'polar'; expected one of true_euler", lambda: jw.Evaluator(m, "polar")),
            ("to another mechanism", lambda: evaluator.equations_at(pose, out=small)),
            ("r has 2 entries; expected 4", lambda: setattr(pose, "r", [[1, 2, 3], [1, 2, 3]])),
            ("r is not a table of 3 columns", lambda: setattr(pose, "r", [1, 2, 3])),
            ("time is not finite", lambda: jw.assemble(m, np.nan)),
            ("one row for each body", lambda: jw.Pose(0, [[0, 0, 0]], np.eye(4))),
            ("no lesson 'loops/none'", lambda: jw.lesson_file("loops/none")),
        ):
            with self.subTest(words=words), self.assertRaisesRegex(ValueError, words):
                call()

    def test_arguments_of_another_kind_are_type_errors(self):
        m = four_bar()
        pose = jw.start_pose(m)
        for call in (
            lambda: jw.equations_at(m, pose, np.zeros(3)),
            lambda: jw.Evaluator(m).equations_at(pose, out=pose),
            lambda: m.add_joint("x", "revolute", 1.5, 2),
            lambda: m.add_joint("x", "revolute", None, 2),
            lambda: jw.rank_at(pose, m),
            lambda: jw.read_lesson_text(5),
        ):
            self.assertRaises(TypeError, call)
        # an integer of numpy is accepted as the number of a body
        self.assertEqual(m.add_joint("x", "revolute", np.int64(1), 2), 4)

    def test_what_cannot_be_assembled_is_not_reached_and_names_the_row(self):
        m = jw.Mechanism()
        rod = m.add_body("rod", [1, 0, 0])
        m.add_joint("here", "spherical", 0, rod, at=[0, 0, 0])
        m.add_joint("there", "spherical", 0, rod, at=[3, 0, 0], to=[1, 0, 0])
        with self.assertRaisesRegex(jw.NotReached, "cannot be assembled at t = 0.*here.s.x"):
            jw.assemble(m)
        self.assertTrue(issubclass(jw.NotReached, RuntimeError))

    def test_mistakes_in_a_lesson_are_the_report_of_the_program_with_their_places(self):
        with self.assertRaises(jw.LessonError) as raised:
            jw.read_lesson_text('format = 1\ntitle = "t"\ncolor = 3\n[[body]]\nname = "a"\npositoin = 1\n', "my.toml")
        error = raised.exception
        self.assertIn("my.toml:3:1: error: unknown key 'color'", str(error))
        self.assertEqual((error.line, error.column), (3, 1))
        places = [(m.file, m.line, m.code) for m in error.mistakes]
        self.assertIn(("my.toml", 3, "JW201"), places)
        self.assertIn(("my.toml", 6, "JW201"), places)
        hints = [m.hint for m in error.mistakes if m.line == 6]
        self.assertIn("position", "".join(hints))
        self.assertIsInstance(error, ValueError)

    def test_a_file_that_is_not_there_is_a_lesson_error(self):
        with self.assertRaisesRegex(jw.LessonError, "no-such-file.toml"):
            jw.read_lesson("no-such-file.toml")


if __name__ == "__main__":
    unittest.main()
