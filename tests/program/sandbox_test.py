#!/usr/bin/python3
"""Grades a program where there is a sandbox, where there is none, and without privileges: sandbox_test.py JOINTWISE EXERCISES"""

import csv
import io
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

program, exercises = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
code = "n1-row-code"
BWRAP = "/usr/bin/bwrap"
# the same machine with an empty file that cannot be executed in the place of bubblewrap
WITHOUT = [BWRAP, "--dev-bind", "/", "/", "--ro-bind", "/dev/null", BWRAP]
UNPRIVILEGED = ["setpriv", "--reuid", "65534", "--regid", "65534", "--clear-groups"]

PROGRAM = """
import json, os, sys
def times(row, m): return [sum(row[k] * m[k][c] for k in range(3)) for c in range(3)]
def skew(v): return [[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]]
open(os.environ.get('TMPDIR', '/tmp') + '/RAN', 'w').close()
cases = json.load(sys.stdin)["cases"]
print(json.dumps({"answers": [[-x for x in times(times(c["s_j"], c["A_i"]), skew(c["s_i_local"]))] for c in cases]}))
"""


def run(*arguments, before=()):
    return subprocess.run([*before, program, *map(str, arguments)], capture_output=True, text=True)


def check(condition, message):
    if not condition:
        sys.exit(f"sandbox_test: {message}")


def grade(place, out, *more, before=()):
    return run("grade", place / "in", "--key", place / "key.toml", *(("--out", place / out) if out else ()), *more, before=before)


def check_run(done):
    check(done.returncode == 0, f"status {done.returncode}: {done.stderr}")
    row = next(csv.DictReader(io.StringIO(done.stdout)))
    check(float(row[code]) == 4.0, f"a right program has {row[code]} points: {done.stderr}")


def check_not_run(place, before):
    done = grade(place, "without", "--format", "csv", before=before)
    check(done.returncode == 3, f"without a sandbox the status is {done.returncode}: {done.stderr}")
    check("1 program was not run" in done.stderr and BWRAP in done.stderr, f"no warning: {done.stderr}")
    row = next(csv.DictReader(io.StringIO(done.stdout)))
    check(float(row[code]) == 0.0 and float(row["points"]) > 10, f"the rest is not graded: {row}")
    check("1 program was not run" in (place / "without" / "class.html").read_text(), "the report does not say so")
    check(f"{code}: not run" in grade(place, "", before=before).stdout, "the grade does not say so")
    judged = json.loads(grade(place, "", "--format", "json", before=before).stdout)[0]["exercises"]
    check([e["name"] for e in judged if e["not_run"]] == [code], "JSON does not say so")
    # where programs can be run, kept results are not used
    return "without"


def main():
    # below /tmp itself: other users have to come in
    place = pathlib.Path(tempfile.mkdtemp(prefix="jw-sandbox-"))
    try:
        (place / "key.toml").write_text(f'format = 1\nsecret = "a secret for tests"\nexercises = ["{exercises}/jacobians.toml"]\n')
        made = run("sheet", exercises / "jacobians.toml", "--student", "ann", "--key", place / "key.toml", "--out", place / "in",
                   "--solution", "--no-figures")
        check(made.returncode == 0, made.stderr)
        folder = place / "in" / "ann"
        shutil.copy(folder / "solution" / "answers.toml", folder / "answers.toml")
        (folder / (code + ".py")).write_text(PROGRAM)
        told = []
        with_sandbox = grade(place, "with", "--format", "csv")
        if with_sandbox.returncode == 3:
            check_not_run(place, ())
            told.append("no sandbox here")
        else:
            check_run(with_sandbox)
            kept = check_not_run(place, WITHOUT)
            check_run(grade(place, kept, "--format", "csv"))
            told.append("with and without a sandbox")
            if os.geteuid() == 0 and shutil.which("setpriv"):
                for path in (place, *place.rglob("*")):
                    path.chmod(0o755 if path.is_dir() else 0o644)
                check_run(grade(place, "", "--format", "csv", before=UNPRIVILEGED))
                told.append("as nobody")
        check(not list(place.rglob("RAN")), "a program wrote outside of the sandbox")
        print("programs are graded " + ", ".join(told))
    finally:
        shutil.rmtree(place, ignore_errors=True)


main()
