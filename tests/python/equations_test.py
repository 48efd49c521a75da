"""Equations of the module against differences of its Φ, by numpy."""

import unittest

import numpy as np

import euler
import jointwise as jw
from scenes import four_bar, moving, two_bodies

WITH_P = ["true_euler_parameters", "modified_euler_parameters"]
ALL = [*WITH_P, "omega_local", "omega_global"]
STEP = 1e-6  # of central differences: truncation STEP² and rounding 1e-16 / STEP, both below 1e-9


def moved(pose, body, k, by, coordinates):
    """The pose with column k of a body changed."""
    pose = pose.copy()
    if k < 3:
        pose.r[body, k] += by
    elif coordinates in WITH_P:
        pose.p[body, k - 3] += by
    else:
        v = by * np.eye(3)[k - 3]
        p = pose.p[body]
        pose.p[body] = euler.product(p, euler.turn(v)) if coordinates == "omega_local" else euler.product(euler.turn(v), p)
    return pose


def differences(evaluator, pose, coordinates):
    """Φq by central differences of Φ."""
    width = 7 if coordinates in WITH_P else 6
    poses = [
        [moved(pose, body, k, sign * STEP, coordinates) for sign in (1, -1)]
        for body in range(1, len(pose.r)) for k in range(width)
    ]
    for k in range(len(pose.theta)):
        pair = []
        for sign in (1, -1):
            pair.append(pose.copy())
            pair[-1].theta[k] += sign * STEP
        poses.append(pair)
    return np.column_stack([(evaluator.phi_at(a) - evaluator.phi_at(b)) / (2 * STEP) for a, b in poses])


class Equations(unittest.TestCase):
    def test_jacobian_of_every_joint_type_is_the_differences_of_phi(self):
        self.assertGreater(len(jw.joint_types()), 15)
        for joint_type in jw.joint_types():
            m, pose = two_bodies(joint_type)
            for coordinates in ALL:
                with self.subTest(joint_type=joint_type, coordinates=coordinates):
                    evaluator = jw.Evaluator(m, coordinates)
                    evaluator.choose_rows(pose)
                    jacobian = evaluator.equations_at(pose).jacobian
                    self.assertGreater(np.abs(jacobian).max(), 0.1)
                    np.testing.assert_allclose(jacobian, differences(evaluator, pose, coordinates), atol=1e-8)

    def test_gamma_of_every_joint_type_is_minus_the_second_difference_of_phi_at_constant_rates(self):
        h = 1e-4  # truncation h² and rounding 1e-16 / h²: both 1e-8
        for joint_type in jw.joint_types():
            with self.subTest(joint_type=joint_type):
                m, pose = two_bodies(joint_type)
                rates = moving(pose)
                evaluator = jw.Evaluator(m, "omega_local")
                phi = []
                for t in (-h, 0.0, h):
                    at_t = pose.copy()
                    at_t.r += t * rates.r_dot
                    at_t.theta += t * rates.theta_dot
                    for body in (1, 2):
                        at_t.p[body] = euler.product(pose.p[body], euler.turn(t * rates.omega_local[body]))
                    phi.append(evaluator.phi_at(at_t))
                second = (phi[0] - 2 * phi[1] + phi[2]) / h**2
                gamma = evaluator.equations_at(pose, rates).gamma
                self.assertGreater(np.abs(gamma).max(), 1e-3)
                np.testing.assert_allclose(gamma, -second, atol=1e-6)

    def test_an_evaluator_says_what_the_functions_say(self):
        m = four_bar()
        pose = jw.assemble(m)
        rates = jw.velocities_at(m, pose)
        for coordinates in ALL:
            evaluator = jw.Evaluator(m, coordinates)
            one, other = evaluator.equations_at(pose, rates), jw.equations_at(m, pose, rates, coordinates)
            self.assertEqual(one.rows, other.rows)
            self.assertEqual(evaluator.row_names, other.rows)
            for name in ("phi", "jacobian", "nu", "gamma"):
                np.testing.assert_array_equal(getattr(one, name), getattr(other, name))
        np.testing.assert_array_equal(evaluator.velocities_at(pose).r_dot, rates.r_dot)
        np.testing.assert_array_equal(
            evaluator.accelerations_at(pose, rates).r_dot, jw.accelerations_at(m, pose, rates).r_dot
        )
        np.testing.assert_array_equal(evaluator.assemble(jw.start_pose(m)).r, pose.r)
        self.assertEqual(evaluator.rank_at(pose).rank, jw.rank_at(m, pose).rank)

    def test_equations_along_a_motion_are_those_at_its_moments(self):
        m = four_bar()
        motion = jw.follow(m, np.linspace(0, 0.5, 6))
        evaluator = jw.Evaluator(m, "omega_local")
        along = evaluator.equations_along(motion)
        self.assertEqual(along.jacobian.shape, (6, 21, 18))
        for k, moment in enumerate(motion):
            e = evaluator.equations_at(moment.pose, moment.velocity)
            for name in ("phi", "jacobian", "nu", "gamma"):
                np.testing.assert_array_equal(getattr(along, name)[k], getattr(e, name))
        # all velocities of the motion at once: rounding of products of numbers up to 40
        np.testing.assert_allclose(np.einsum("trc,tc->tr", along.jacobian, motion.q_dot[:, 6:]), along.nu, atol=1e-10)

    def test_velocities_and_accelerations_satisfy_their_equations_column_by_column(self):
        m = four_bar()
        pose = jw.assemble(m)
        rates = jw.velocities_at(m, pose)
        for coordinates in ALL:
            evaluator = jw.Evaluator(m, coordinates)
            e = evaluator.equations_at(pose, rates)
            self.assertEqual(len(evaluator.column_names), e.jacobian.shape[1])
            # rounding of products of numbers up to 40, and the pose's own 1e-13
            np.testing.assert_allclose(e.jacobian @ evaluator.columns_of(pose, rates), e.nu, atol=1e-10)
        accelerations = jw.accelerations_at(m, pose, rates)
        np.testing.assert_allclose(e.jacobian @ evaluator.columns_of(pose, accelerations), e.gamma, atol=1e-10)

    def test_free_motions_and_singular_values_are_those_of_numpy(self):
        m = four_bar()
        rank = jw.rank_at(m, jw.assemble(m))
        self.assertEqual((rank.rows, rank.columns, rank.rank, rank.redundant, rank.freedoms), (21, 18, 18, 3, 0))
        self.assertEqual(rank.singular_values.shape, (18,))
        self.assertEqual(len(rank.redundant_rows), 3)
        free = jw.Mechanism()
        free.add_body("one", [0, 0, 0])
        free.add_body("two", [1, 0, 0])
        free.add_joint("ball", "spherical", 1, 2, at=[0.3, 0.4, 0.5])
        pose = jw.assemble(free)
        rank = jw.rank_at(free, pose)
        jacobian = jw.equations_at(free, pose, coordinates="omega_local").jacobian
        self.assertEqual(rank.free_motions.shape, (12, 9))
        np.testing.assert_allclose(jacobian @ rank.free_motions, 0, atol=1e-14)
        self.assertEqual(np.linalg.matrix_rank(rank.free_motions), 9)
        # lengths are in metres here, and rows have the unit 1 m: nothing is scaled
        np.testing.assert_allclose(rank.singular_values[:3], np.linalg.svd(jacobian)[1], atol=1e-12)


if __name__ == "__main__":
    unittest.main()
