"""Quantities and reactions: against the numbers that they are made of, and Newton's law by hand."""

import gc
import unittest

import numpy as np

import jointwise as jw
from scenes import four_bar, pendulum


class Measures(unittest.TestCase):
    def test_quantities_are_the_numbers_of_the_trajectory(self):
        m = four_bar()
        motion = jw.follow(m, np.linspace(0, 0.4, 5))
        quantities = jw.Quantities(m, ["crank.x", "rocker.omega_local.z", "coupler.r_ddot.y", "A.angle"])
        self.assertEqual(quantities.units, ["m", "rad/s", "m/s²", "rad"])
        table = quantities.along(motion)
        self.assertEqual(table.shape, (5, 4))
        np.testing.assert_array_equal(table[:, 0], motion.r[:, 1, 0])
        np.testing.assert_array_equal(table[:, 1], motion.omega_local[:, 3, 2])
        np.testing.assert_array_equal(table[:, 2], motion.r_ddot[:, 2, 1])
        np.testing.assert_allclose(table[:, 3], 2 * np.pi * motion.t, atol=1e-12)  # the motor's function
        np.testing.assert_array_equal(quantities.at(motion[2]), table[2])
        kept = table.copy()
        del quantities, motion
        gc.collect()
        np.testing.assert_array_equal(table, kept)

    def test_names_that_stand_for_nothing_are_said(self):
        with self.assertRaisesRegex(ValueError, "no quantity 'crnk.x'"):
            jw.Quantities(four_bar(), ["crnk.x"])
        self.assertIn("C.angle_dot", jw.quantity_names(four_bar()))

    def test_reactions_are_what_newton_asks_for(self):
        m = pendulum(1.0)
        motion = jw.simulate(m, np.linspace(0, 0.5, 6), tolerance=1e-10)
        forces = jw.Quantities(m, ["pin.force.x", "pin.force.y", "pin.force.z"]).along(motion)
        expected = 2.0 * (motion.r_ddot[:, 1] - np.array([0, 0, -9.81]))
        np.testing.assert_allclose(forces, expected, atol=1e-8)
        found = jw.reactions_at(m, motion[3])
        self.assertEqual([r.name for r in found.reactions], ["pin"])
        self.assertLessEqual(found.residual, found.bound)
        pin = found.reactions[0]
        del found
        gc.collect()
        np.testing.assert_allclose(pin.force, expected[3], atol=1e-8)
        self.assertEqual((pin.body_i, pin.body_j, pin.of_driver), (0, 1, False))
        self.assertTrue(all(pin.force_unique) and all(pin.torque_unique))

    def test_reactions_of_redundant_joints_are_marked(self):
        m = four_bar()
        for body in (1, 2, 3):
            m.set_mass(body, 1.0, 0.1 * np.eye(3))
        found = jw.reactions_at(m, jw.follow(m, [0.0, 0.1])[1])
        self.assertEqual(found.open, 3)
        self.assertEqual([r.name for r in found.reactions], ["A", "B", "C", "D", "motor"])
        # forces out of the plane and torques in it are not unique
        self.assertTrue(found.reactions[0].force_unique[0] and found.reactions[0].force_unique[1])
        self.assertFalse(found.reactions[0].force_unique[2])
        values = jw.Quantities(m, ["A.force.x", "A.force.z"]).at(jw.follow(m, [0.0, 0.1])[1])
        self.assertTrue(np.isfinite(values[0]) and np.isnan(values[1]))

    def test_a_pendulum_rests_below_its_pin_and_swings_as_the_textbook_says(self):
        m = pendulum(2.0)
        rest = jw.find_equilibrium(m)
        self.assertIs(rest.stable, True)
        self.assertEqual((rest.freedoms, len(rest.small_motions)), (1, 1))
        np.testing.assert_allclose(rest.moment.pose.r[1], [0, 0, -1], atol=1e-9)
        swing = rest.small_motions[0]
        inertia = 1e-3 + 2.0  # about the pin
        self.assertAlmostEqual(swing.s.imag, np.sqrt(2.0 * 9.81 / inertia), places=7)
        # its largest movement is 1: the bob moves by a metre where the rod turns by a radian
        turn, way = swing.shape.omega_local[1][1], swing.shape.r_dot[1][0]
        self.assertAlmostEqual(abs(turn), abs(way), places=9)
        np.testing.assert_allclose(jw.reactions_at(m, rest.moment).reactions[0].force, [0, 0, 2 * 9.81], atol=1e-7)
        self.assertIn("stable", repr(rest))
        self.assertIs(jw.find_equilibrium(pendulum(3.0), nearest=True).stable, False)


if __name__ == "__main__":
    unittest.main()
