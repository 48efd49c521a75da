"""Arrays are views of what the results own: they keep it alive, show what is written, and leave no copy behind."""

import copy
import gc
import pickle
import unittest
import weakref

import numpy as np

import jointwise as jw
from scenes import four_bar


def assembled():
    return jw.assemble(four_bar())


def loose_body():
    m = jw.Mechanism()
    m.add_body("one", [0, 0, 0])
    m.add_joint("ball", "spherical", 0, 1)
    return m


MOTION = ("t", "energy", "q", "q_dot", "q_ddot", "r", "p", "r_dot", "omega_local", "r_ddot", "omega_local_dot")
# makers of results, and their arrays: all arrays that show numbers in place
RESULTS = (
    (lambda: jw.equations_at(four_bar(), assembled()), ("phi", "jacobian", "nu", "gamma")),
    (lambda: jw.rank_at(loose_body(), jw.start_pose(loose_body())), ("singular_values", "free_motions")),
    (assembled, ("r", "p")),
    (lambda: jw.velocities_at(four_bar(), assembled()), ("r_dot", "omega_local")),
    (lambda: jw.follow(four_bar(), np.linspace(0, 0.5, 50)), MOTION),
    (
        lambda: jw.Evaluator(four_bar()).equations_along(jw.follow(four_bar(), [0, 0.1, 0.2])),
        ("phi", "jacobian", "nu", "gamma"),
    ),
    (lambda: jw.draw(four_bar(), assembled(), 64, 48), ("rgb",)),
)


class Memory(unittest.TestCase):
    def test_an_array_sees_its_result_in_place(self):
        for make, names in RESULTS:
            what = make()
            for name in names:
                with self.subTest(of=type(what).__name__, name=name):
                    array, again = getattr(what, name), getattr(what, name)
                    self.assertIs(array.base, what)
                    self.assertFalse(array.flags.owndata)
                    self.assertEqual(array.ctypes.data, again.ctypes.data)

    def test_an_array_keeps_its_result_alive_and_lets_it_go_with_itself(self):
        for make, names in RESULTS:
            for name in names:
                owner = make()
                alive = weakref.ref(owner)
                array = getattr(owner, name)
                before = array.copy()
                with self.subTest(of=type(owner).__name__, name=name):
                    del owner
                    gc.collect()
                    self.assertIsNotNone(alive())
                    # these would take up memory that was freed
                    filler = [np.full(array.size, 7.0) for _ in range(50)]
                    np.testing.assert_array_equal(array, before)
                    del array, filler
                    gc.collect()
                    self.assertIsNone(alive())

    def test_results_cannot_be_written_and_poses_can(self):
        for make, names in RESULTS:
            what = make()
            for name in names:
                with self.subTest(of=type(what).__name__, name=name):
                    self.assertEqual(getattr(what, name).flags.writeable, isinstance(what, (jw.Pose, jw.Rates)))
        pose = jw.start_pose(four_bar())
        seen = pose.r
        seen[1] = [1, 2, 3]
        np.testing.assert_array_equal(pose.r[1], [1, 2, 3])
        pose.r = pose.r + 1
        np.testing.assert_array_equal(seen[1], [2, 3, 4])

    def test_a_trajectory_is_one_matrix_and_its_parts_lie_in_it(self):
        motion = jw.follow(four_bar(), np.linspace(0, 0.5, 20))
        self.assertTrue(motion.q.flags.c_contiguous)
        self.assertEqual(motion.q.shape, (20, 4 * 7))
        for part, whole in (("r", "q"), ("p", "q"), ("omega_local", "q_dot"), ("omega_local_dot", "q_ddot")):
            self.assertTrue(np.shares_memory(getattr(motion, part), getattr(motion, whole)))
        np.testing.assert_array_equal(motion.p[:, 2], motion.q[:, 17:21])

    def test_equations_written_again_are_seen_by_the_arrays_of_before(self):
        m = four_bar()
        evaluator = jw.Evaluator(m)
        pose = jw.assemble(m)
        e = evaluator.equations_at(pose)
        phi, jacobian = e.phi, e.jacobian
        kept = jacobian.copy()
        pose.r[1] += 0.1
        pose.p[1] = [0.8, 0.6, 0, 0]
        self.assertIs(evaluator.equations_at(pose, out=e), e)
        self.assertGreater(np.abs(jacobian - kept).max(), 0.01)
        np.testing.assert_array_equal(phi, evaluator.phi_at(pose))

    def test_a_moment_keeps_its_own_numbers_when_the_trajectory_is_gone(self):
        motion = jw.follow(four_bar(), [0.0, 0.1])
        r = motion[1].pose.r
        expected = motion.r[1].copy()
        del motion
        gc.collect()
        np.testing.assert_array_equal(r, expected)

    def test_poses_and_rates_are_kept_by_pickle(self):
        lesson = jw.read_lesson(jw.lesson_file("joints/screw"))
        pose = jw.assemble(lesson.mechanism, t=0.3)
        rates = jw.velocities_at(lesson.mechanism, pose)
        for what, names in ((pose, ("t", "r", "p", "theta")), (rates, ("r_dot", "omega_local", "theta_dot"))):
            again = pickle.loads(pickle.dumps(what))
            for name in names:
                np.testing.assert_array_equal(getattr(again, name), getattr(what, name))

    def test_copies_are_independent(self):
        m = four_bar()
        evaluator = jw.Evaluator(m)
        for other in (m.copy(), copy.copy(m), copy.deepcopy(m)):
            other.add_body("more", [0, 0, 0])
            self.assertEqual((len(m.body_names), len(other.body_names)), (4, 5))
        pose = jw.start_pose(m)
        for other in (pose.copy(), copy.copy(pose), copy.deepcopy(pose)):
            other.r[1] += 1
            self.assertFalse(np.array_equal(pose.r, other.r))
        # an evaluator has the mechanism of the moment when it was made
        m.add_body("later", [0, 0, 0])
        self.assertEqual(evaluator.equations_at(pose).jacobian.shape[1], 3 * 7)


if __name__ == "__main__":
    unittest.main()
