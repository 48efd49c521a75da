#!/usr/bin/python3
"""Grades a class of which a tenth is malformed or hostile: class_test.py JOINTWISE EXERCISES [STUDENTS]

Every honest submission has to get all of its points, every program with a known mistake the name of that mistake, every
other submission a reason; grading twice gives the same; nobody reads the key or another submission.
"""

import csv
import io
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

program, exercises = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
count = int(sys.argv[3]) if len(sys.argv) > 3 else 60
code = "n1-row-code"

RIGHT = """
import json, sys
def times(row, m): return [sum(row[k] * m[k][c] for k in range(3)) for c in range(3)]
def skew(v): return [[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]]
cases = json.load(sys.stdin)["cases"]
answers = [[SIGN * x for x in times(times(c["s_j"], c["A_i"]), skew(c["s_i_local"]))] for c in cases]
json.dump({"answers": answers}, sys.stdout)
"""
PROGRAMS = {
    "loop": "while True: pass",
    "fork": "import os\nwhile True: os.fork()",
    "output": "while True: print('x' * 100000)",
    "memory": "x = []\nwhile True: x.append(' ' * 10**7)",
    "sleep": "import time\ntime.sleep(1000)",
    "spy": "import os, sys\nfor root, _, files in os.walk('/'):\n for f in files:\n  if f in ('key.toml', 'answers.toml'): sys.exit('SPY ' + root)",
    "network": "import socket\nsocket.create_connection(('127.0.0.1', 22), 2)",
    "escape": "print('\\x1b[2J\\x1b]0;owned\\x07')",
    "nonsense": "print('{\"answers\": [[1]]}')",
    "nothing": "",
    "deep": "print('[' * 10**6)",
}


def run(*arguments):
    return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, errors="replace")


def check(condition, message):
    if not condition:
        sys.exit("class_test: " + message)


def hostile_answers(kind, place, folder):
    """Damages the answers of a submission."""
    file = folder / "answers.toml"
    if kind == "binary":
        file.write_bytes(os.urandom(5000))
    elif kind == "link":
        file.unlink()
        file.symlink_to(place / "key.toml")
    elif kind == "pipe":
        file.unlink()
        os.mkfifo(file)
    elif kind == "large":
        file.write_bytes(b"x" * 3_000_000)
    elif kind == "brackets":
        file.write_text("format = 1\nstudent = 'x'\n[answers]\nn1-row = " + "[" * 100_000)
    elif kind == "parentheses":
        file.write_text("format = 1\nstudent = 'x'\n[answers]\nn1-row = '" + "(" * 15_000 + "'")
    elif kind == "name":
        file.write_text("format = 1\nstudent = '../../../etc'\n[answers]\n")
    elif kind == "escape":
        file.write_text("format = 1\nstudent = 'x'\n[answers]\nn1-row = \"\\u001b[2J<script>\"\n")
    elif kind == "bomb":
        (folder / (code + ".zip")).write_bytes(b"PK\x03\x04" * 1000)
        file.write_text("")


def prepare(place):
    (place / "key.toml").write_text(f'format = 1\nsecret = "a secret for tests"\nexercises = ["{exercises}/jacobians.toml"]\n')
    students = [f"s{k:04d}" for k in range(count)]
    (place / "roster.csv").write_text("student\n" + "\n".join(students) + "\n")
    made = run("sheet", exercises / "jacobians.toml", "--class", place / "roster.csv", "--key", place / "key.toml", "--out",
               place / "in", "--solution", "--no-figures")
    check(made.returncode == 0, made.stderr)
    programs = list(PROGRAMS.items())
    answers = ["binary", "link", "pipe", "large", "brackets", "parentheses", "name", "escape", "bomb"]
    expected = {}
    for k, student in enumerate(students):
        folder = place / "in" / student
        shutil.copy(folder / "solution" / "answers.toml", folder / "answers.toml")
        shutil.rmtree(folder / "solution")
        (folder / (code + ".py")).write_text(RIGHT.replace("SIGN", "-1"))
        expected[student] = "right"
        if k % 10 == 3:
            expected[student] = "sign"
            (folder / (code + ".py")).write_text(RIGHT.replace("SIGN", "1"))
        if k % 10 != 7:
            continue
        which = (k // 10) % (len(programs) + len(answers))
        if which < len(programs):
            expected[student] = "wrong program"
            (folder / (code + ".py")).write_text(programs[which][1])
        else:
            expected[student] = "bad answers"
            hostile_answers(answers[which - len(programs)], place, folder)
    return expected


def main():
    place = pathlib.Path(tempfile.mkdtemp(prefix="jw-class-"))
    try:
        expected = prepare(place)
        began = time.time()
        graded = run("grade", place / "in", "--key", place / "key.toml", "--out", place / "out", "--format", "csv")
        seconds = time.time() - began
        check(graded.returncode == 0, graded.stderr)
        check("\x1b" not in graded.stdout, "a terminal's escape came through")
        rows = {row["submission"]: row for row in csv.DictReader(io.StringIO(graded.stdout))}
        check(len(rows) == count, f"{len(rows)} of {count} submissions have a grade")
        sandbox = "sandbox" not in run("grade", place / "in" / "s0000", "--key", place / "key.toml").stdout
        others = [name for name in rows["s0000"] if not name.startswith(code)]
        values = [n for n in others if n not in ("student", "submission", "points", "of", "problem") and not n.endswith(" mistake")]
        full = rows["s0000"]
        for student, row in rows.items():
            kind = expected[student]
            if kind == "bad answers":
                check(row["points"] == "0" or row["problem"] or row["points"] < full["points"], f"{student}: {row}")
                continue
            check(all(row[v] == full[v] for v in values), f"{student} lost points: {row}")
            if not sandbox:
                continue
            if kind == "right":
                check(float(row[code]) == 4.0, f"{student}: a right program has {row[code]} points")
            elif kind == "sign":
                check(row[code + " mistake"] == "sign", f"{student}: the mistake is '{row[code + ' mistake']}'")
            else:
                check(float(row[code]) < 4.0, f"{student}: a hostile program has all points")
        for result in (place / "out" / "results").iterdir():
            check("SPY" not in result.read_text(), "a program found the key or another submission")
        again = run("grade", place / "in", "--key", place / "key.toml", "--out", place / "out", "--format", "csv")
        check(again.stdout == graded.stdout, "kept results differ")
        check("<script" not in (place / "out" / "class.html").read_text(), "a script came into the page")
        print(f"{count} submissions graded in {seconds:.1f} s" + ("" if sandbox else "; no sandbox here, programs not run"))
    finally:
        shutil.rmtree(place, ignore_errors=True)


main()
