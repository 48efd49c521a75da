"""Threads: long calls run beside each other, and each has the mechanism of the moment when it was called."""

import signal
import threading
import unittest

import numpy as np

import jointwise as jw
from scenes import four_bar, pendulum


def in_threads(*calls):
    """The results of calls that run at the same time. Raises what one of them raises."""
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
        times = np.linspace(0, 0.3, 31)
        alone = jw.simulate(pendulum(1.0), times).q
        for repeat in range(5):
            m = pendulum(1.0)
            started = threading.Event()

            def simulated():
                started.set()
                return jw.simulate(m, times).q

            def changed():
                started.wait()
                for k in range(200):
                    m.add_body(f"more {k}", [0, 0, 0])

            # the change comes before the call, and there is a body without mass, or after it, and changes nothing
            try:
                q, _ = in_threads(simulated, changed)
            except ValueError as error:
                self.assertIn("mass", str(error))
            else:
                np.testing.assert_array_equal(q, alone)
            self.assertEqual(len(m.body_names), 202)


    def test_a_signal_ends_a_long_simulation(self):
        class Interrupted(Exception):
            pass

        def interrupt(number, frame):
            raise Interrupted

        before = signal.signal(signal.SIGALRM, interrupt)
        try:
            signal.setitimer(signal.ITIMER_REAL, 0.05)
            # ten million steps: many seconds, unless something ends it
            self.assertRaises(Interrupted, jw.simulate, pendulum(1.0), [0, 1000], method="euler", step=1e-4)
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)


if __name__ == "__main__":
    unittest.main()
