"""Threads: long calls run beside each other, and each has the mechanism of the moment when it was called."""

import signal
import threading
import unittest

import numpy as np

import jointwise as jw
from scenes import four_bar, pendulum


def in_threads(*calls):
    """Results of calls that run at the same time. Raises the exception that one of them raises."""
    results = [None] * len(calls)

    def run(k):
        try:
            results[k] = calls[k]()
        except BaseException as error:  # handed to the thread that waits
            results[k] = error

    threads = [threading.Thread(target=run, args=(k,)) for k in range(len(calls))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for result in results:
        if isinstance(result, BaseException):
            raise result
    return results


class Threads(unittest.TestCase):
    def test_two_threads_compute_what_one_computes(self):
        lesson = jw.read_lesson(jw.lesson_file("loops/bennett"))
        pose = jw.assemble(lesson.mechanism)
        m = four_bar()
        times = np.linspace(0, 0.5, 101)
        calls = [
            lambda: jw.follow(m, times).q,
            lambda: jw.follow(lesson.mechanism, lesson.motion_times).q,
            lambda: jw.simulate(pendulum(1.0), times).q,
            lambda: jw.rank_at(lesson.mechanism, pose).singular_values,
            lambda: jw.draw(lesson, pose, 64, 48).rgb,
            lambda: jw.draw(m, jw.start_pose(m), 64, 48).rgb,
        ]
        alone = [call() for call in calls]
        for repeat in range(3):
            for one, other in zip(alone, in_threads(*calls)):
                np.testing.assert_array_equal(one, other)

    def test_a_mechanism_that_changes_meanwhile_is_computed_as_it_was(self):
        times = np.linspace(0, 0.5, 501)
        alone = jw.follow(four_bar(), times).r
        for repeat in range(5):
            m = four_bar()
            started = threading.Event()

            def followed():
                started.set()
                return jw.follow(m, times).r

            def changed():
                started.wait()
                for k in range(20):
                    m.add_body(f"more {k}", [0, 0, 0])

            r, _ = in_threads(followed, changed)
            # bodies that were added before the call move too: other sums, rounded differently
            np.testing.assert_allclose(r[:, :4], alone, rtol=0, atol=1e-9)
            self.assertEqual(len(m.body_names), 24)

    def ended_by_signal(self, call):
        """True if a signal ends a call that would end by itself with NotReached, and later."""
        class Interrupted(Exception):
            pass

        def interrupt(number, frame):
            raise Interrupted

        ended_by = None
        before = signal.signal(signal.SIGALRM, interrupt)
        try:
            signal.setitimer(signal.ITIMER_REAL, 0.05)
            try:
                call()
            except jw.NotReached:
                ended_by = "itself"
            except Interrupted:
                ended_by = "the signal"
        except Interrupted:  # raised as soon as Python code runs again
            pass
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)
        return ended_by == "the signal"

    def test_a_signal_ends_a_long_simulation(self):
        # twenty million steps: more than are taken, after many seconds, unless something ends it
        self.assertTrue(
            self.ended_by_signal(lambda: jw.simulate(pendulum(1.0), [0, 2000], method="euler", step=1e-4)))

    def test_a_signal_ends_a_long_motion_of_drivers(self):
        # more than a hundred thousand times before it can go no farther, unless something ends it
        times = np.linspace(0, 0.13, 200001)
        self.assertTrue(self.ended_by_signal(lambda: jw.follow(four_bar(driven="D"), times)))


if __name__ == "__main__":
    unittest.main()
