"""The module against the program, which computes the same in other ways: program_test.py JOINTWISE.

Times, poses and quantities of `jointwise solve` and `jointwise simulate` are those of follow, simulate and Quantities.
"""

import json
import subprocess
import sys
import unittest

import numpy as np

import jointwise as jw

PROGRAM = sys.argv.pop(1)


def table_of(command, name, quantities, *options):
    """Columns by name, and times, of a table of the program."""
    arguments = [PROGRAM, command, str(jw.lesson_file(name)), "--format", "json", *options]
    for quantity in quantities:
        arguments += ["--quantities", quantity]
    run = subprocess.run(arguments, check=True, capture_output=True, text=True)
    table = json.loads(run.stdout)
    rows = [row["values"] if isinstance(row, dict) else row for row in table["rows"]]
    values = np.array(rows, dtype=float)
    return dict(zip(table["columns"], values.T))


def compared(case, command, name, motion, quantities, tolerance, *options):
    table = table_of(command, name, quantities, *options)
    lesson = jw.read_lesson(jw.lesson_file(name))
    np.testing.assert_allclose(table["time_s"], motion.t, rtol=0, atol=1e-12)
    names = list(quantities) + [f"{body}.{k}" for body in lesson.mechanism.body_names[1:] for k in "xyz"]
    names = [n for n in names if n in table]
    case.assertGreater(len(names), len(quantities))
    found = jw.Quantities(lesson.mechanism, names).along(motion)
    for k, column in enumerate(names):
        with case.subTest(lesson=name, column=column):
            # NaN where the program has an empty cell
            scale = 1 + np.nanmax(np.abs(table[column]), initial=0)
            np.testing.assert_allclose(found[:, k], table[column], rtol=0, atol=tolerance * scale)


class Program(unittest.TestCase):
    def test_solve_and_follow_agree(self):
        for name, quantities in (
            ("loops/four-bar", ["B.angle", "B.angle_ddot", "jacobian.smallest_singular_value", "A.residual.s.x"]),
            ("joints/screw", ["energy.sum"]),
            ("loops/double-cardan", []),
        ):
            lesson = jw.read_lesson(jw.lesson_file(name))
            motion = jw.follow(lesson.mechanism, lesson.motion_times)
            compared(self, "solve", name, motion, quantities, 1e-9, "--analysis", "acceleration")

    def test_simulate_and_simulate_agree(self):
        for name, quantities in (
            # its spring is twisted by more than a turn
            ("dynamics/torsion-pendulum", ["energy.potential", "energy.sum"]),
            ("dynamics/four-bar-1", ["energy.kinetic_dot"]),
            ("dynamics/spatial-slider-crank-falling", ["energy.sum"]),
        ):
            lesson = jw.read_lesson(jw.lesson_file(name))
            motion = jw.simulate(lesson.mechanism, lesson.simulation_times, **lesson.simulation)
            compared(self, "simulate", name, motion, quantities, 1e-9)


if __name__ == "__main__":
    unittest.main()
