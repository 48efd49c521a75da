#!/usr/bin/python3
"""Price of a call from Python beside the same call in C++: python_calls.py LIBRARY_CALLS [LESSON].

LIBRARY_CALLS is the program of library_calls.cpp. Times are processor time, the least of ten rounds, in microseconds;
compare them within one run only.
"""

import subprocess
import sys
import time

import jointwise as jw

CALLS = 2000


def least_time(call):
    """Microseconds of one call."""
    least = float("inf")
    for _ in range(10):
        start = time.process_time()
        for _ in range(CALLS):
            call()
        least = min(least, time.process_time() - start)
    return 1e6 * least / CALLS


def calls(m):
    """The calls of library_calls.cpp by its names; and what numpy needs to see the results, which C++ need not do."""
    pose = jw.assemble(m)
    evaluator = jw.Evaluator(m)
    rates = evaluator.velocities_at(pose)
    e = evaluator.equations_at(pose, rates)
    same = {
        "evaluator.equations_at": lambda: evaluator.equations_at(pose, rates),
        "evaluator.equations_at(out)": lambda: evaluator.equations_at(pose, rates, e),
        "evaluator.phi_at": lambda: evaluator.phi_at(pose),
        "evaluator.columns_of": lambda: evaluator.columns_of(pose, rates),
        "evaluator.velocities_at": lambda: evaluator.velocities_at(pose),
        "evaluator.accelerations_at": lambda: evaluator.accelerations_at(pose, rates),
        "evaluator.assemble": lambda: evaluator.assemble(pose, pose.t),
        "equations_at": lambda: jw.equations_at(m, pose, rates),
        "velocities_at": lambda: jw.velocities_at(m, pose),
    }
    views = {
        "view of phi": lambda: e.phi,
        "view of jacobian": lambda: e.jacobian,
        "view of pose.r": lambda: pose.r,
    }
    return same, views


def main():
    program = sys.argv[1]
    lesson = sys.argv[2] if len(sys.argv) > 2 else str(jw.lesson_file("loops/four-bar"))
    output = subprocess.run([program, lesson], check=True, capture_output=True, text=True).stdout
    in_cpp = {name: float(us) for name, us in (line.split() for line in output.splitlines())}
    same, views = calls(jw.read_lesson(lesson).mechanism)
    print(f"{'call':30} {'C++ us':>8} {'Python us':>10} {'more us':>8} {'ratio':>6}")
    for name, call in same.items():
        us = least_time(call)
        print(f"{name:30} {in_cpp[name]:8.2f} {us:10.2f} {us - in_cpp[name]:8.2f} {us / in_cpp[name]:6.2f}")
    for name, call in views.items():
        print(f"{name:30} {'':8} {least_time(call):10.2f}")


if __name__ == "__main__":
    main()
