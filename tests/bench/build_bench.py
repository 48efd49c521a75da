#!/usr/bin/env python3
"""Times that a newcomer, a contributor and CI wait for: builds of this commit and of an earlier one in fresh clones, on the same
machine in the same run, and the table of docs/build.md. build_bench.py ROOT [--against COMMIT] [STEP...]; packages are
installed before. Rows of steps that are not named stay as they are."""

import argparse
import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile
import time

# the commit that the aims of docs/build.md are ratios to
BEFORE = "010bc1c"
FOUR_BAR = "lessons/catalogue/loops/four-bar.toml"
BEGIN, END = "<!-- table: written by ./dev bench build -->", "<!-- table: end -->"


def edit(source):
    """A command that changes one source and runs a lesson with the program that is built from it."""
    return f"echo '// edited' >> {source} && ./dev run step {FOUR_BAR} > step.txt"


# name: (what is waited for, command); each begins where those before it have ended
STEPS = {
    "first": ("README's first command, without apt", f"./dev run render {FOUR_BAR} --out frames"),
    "core": ("edit of a source of core to a running program", edit("core/kinematics/kinematics.cpp")),
    "session": ("edit of a source of session", edit("app/session/story/sentences.cpp")),
    "panel": ("edit of a panel", edit("app/panels/column/rank_panel.cpp") + f" && ./dev run render {FOUR_BAR} --from 1 --to 1 --out one"),
    "second": ("README's second command, from there", "./dev test"),
    "web": ("`./dev web`, without its download", "./dev web"),
    "ci": ("`.ci/run` in a fresh clone", "git clone -q . fresh && cd fresh && bash .ci/run"),
}


def seconds(step, clone):
    """Wall and CPU seconds of a step; ends the program where it fails."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    began = time.monotonic()
    log = clone / f"bench-{step}.log"
    with log.open("wb") as file:
        status = subprocess.run(["bash", "-c", STEPS[step][1]], cwd=clone, stdout=file, stderr=subprocess.STDOUT).returncode
    wall = time.monotonic() - began
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if status != 0:
        sys.exit(f"{STEPS[step][1]}: status {status}\n{log.read_text(errors='replace')[-2000:]}")
    return wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def minutes(value):
    return f"{int(value) // 60} min {int(value) % 60:02} s" if value >= 60 else f"{value:.1f} s"


def row(step, old, new):
    numbers = " | ".join(f"{minutes(old[k])} | {minutes(new[k])} | {new[k] / old[k]:.2f}" for k in (0, 1))
    return f"| {STEPS[step][0]} | {numbers} |"


def write(page, rows):
    text = page.read_text()
    begin, end = text.index(BEGIN), text.index(END)
    lines = text[begin:end].splitlines()
    for step, new in rows.items():
        place = next((k for k, line in enumerate(lines) if line.startswith(f"| {STEPS[step][0]} |")), None)
        if place is None:
            lines.append(new)
        else:
            lines[place] = new
    page.write_text(text[:begin] + "\n".join(lines) + "\n" + text[end:])


def main():
    parser = argparse.ArgumentParser(prog="./dev bench build")
    parser.add_argument("root", type=pathlib.Path, help=argparse.SUPPRESS)
    parser.add_argument("--against", default=BEFORE, metavar="COMMIT", help="the commit to compare with (default: %(default)s)")
    parser.add_argument("steps", nargs="*", metavar="STEP", help=f"some of {', '.join(STEPS)} (default: all)")
    given = parser.parse_args()
    unknown = [step for step in given.steps if step not in STEPS]
    if unknown:
        parser.error(f"no step '{unknown[0]}'; expected some of {', '.join(STEPS)}")
    wanted = [step for step in STEPS if not given.steps or step in given.steps]

    rows = {}
    with tempfile.TemporaryDirectory(prefix="jointwise-build-", dir=os.environ.get("TMPDIR")) as folder:
        # programs of students run as another user, who must find the checkout
        os.chmod(folder, 0o755)
        clones = {}
        for commit in (given.against, "HEAD"):
            clones[commit] = pathlib.Path(folder) / re.sub(r"\W", "", commit)
            subprocess.run(["git", "clone", "-q", str(given.root), str(clones[commit])], check=True)
            head = subprocess.run(["git", "-C", str(given.root), "rev-parse", commit], check=True, capture_output=True, text=True)
            subprocess.run(["git", "-C", str(clones[commit]), "checkout", "-q", head.stdout.strip()], check=True)
        for step in wanted:
            old, new = (seconds(step, clones[commit]) for commit in (given.against, "HEAD"))
            rows[step] = row(step, old, new)
            print(rows[step], flush=True)
    write(given.root / "docs/build.md", rows)


main()
