"""Motions: trajectories against differences of their own numbers and against a closed formula."""

import unittest

import numpy as np

import jointwise as jw
from scenes import four_bar, pendulum


class Motion(unittest.TestCase):
    def test_velocities_and_accelerations_of_follow_are_differences_of_its_rows(self):
        h = 1e-4
        motion = jw.follow(four_bar(), [0.3 - h, 0.3, 0.3 + h])
        # h² / 6 times the third derivative, below 1e3 at one turn in a second
        np.testing.assert_allclose((motion.r[2] - motion.r[0]) / (2 * h), motion.r_dot[1], atol=1e-5)
        np.testing.assert_allclose(
            (motion.r_dot[2] - motion.r_dot[0]) / (2 * h), motion.r_ddot[1], atol=1e-4
        )
        np.testing.assert_allclose(
            (motion.omega_local[2] - motion.omega_local[0]) / (2 * h), motion.omega_local_dot[1], atol=1e-4
        )

    def test_rows_of_a_trajectory_are_its_moments(self):
        lesson = jw.read_lesson(jw.lesson_file("joints/screw"))
        times = lesson.motion_times[:3]
        motion = jw.follow(lesson.mechanism, times)
        self.assertEqual(len(motion), 3)
        self.assertEqual(motion.theta.shape[0], 3)
        self.assertGreater(motion.theta.shape[1], 0)
        for k, moment in enumerate(motion):
            self.assertEqual(moment.pose.t, times[k])
            for of, name in (
                (moment.pose, "r"), (moment.pose, "p"), (moment.pose, "theta"),
                (moment.velocity, "r_dot"), (moment.velocity, "omega_local"), (moment.velocity, "theta_dot"),
            ):
                np.testing.assert_array_equal(getattr(of, name), getattr(motion, name)[k])
            np.testing.assert_array_equal(moment.acceleration.r_dot, motion.r_ddot[k])
            np.testing.assert_array_equal(moment.acceleration.omega_local, motion.omega_local_dot[k])
            np.testing.assert_array_equal(moment.acceleration.theta_dot, motion.theta_ddot[k])
        self.assertEqual(motion[-1].pose.t, times[2])
        self.assertRaises(IndexError, lambda: motion[3])

    def test_a_row_of_velocities_has_the_columns_of_the_jacobian_behind_the_ground(self):
        m = four_bar()
        motion = jw.follow(m, [0.0, 0.1])
        evaluator = jw.Evaluator(m, "omega_local")
        for k, moment in enumerate(motion):
            np.testing.assert_array_equal(
                motion.q_dot[k, 6:], evaluator.columns_of(moment.pose, moment.velocity)
            )

    def test_a_pendulum_keeps_its_energy_and_swings_with_the_period_of_small_swings(self):
        angle = 1e-3
        period = 2 * np.pi * np.sqrt((1 + 0.5e-3) / 9.81)
        motion = jw.simulate(pendulum(angle), [0, period / 2, period], tolerance=1e-10)
        # the period of large swings is longer by angle²/16; at the turning points its effect is of second order
        np.testing.assert_allclose(motion.r[:, 1, 0], np.sin(angle) * np.array([1, -1, 1]), rtol=1e-6)
        np.testing.assert_allclose(motion.energy, motion.energy[0], rtol=1e-9)

    def test_a_lesson_moves_at_its_own_times(self):
        lesson = jw.read_lesson(jw.lesson_file("loops/four-bar"))
        self.assertIn("four", lesson.title.lower())
        motion = jw.follow(lesson.mechanism, lesson.motion_times)
        self.assertEqual(len(motion), len(lesson.motion_times))


if __name__ == "__main__":
    unittest.main()
