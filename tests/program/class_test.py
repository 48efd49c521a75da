#!/usr/bin/python3
"""Grades a class in which submissions of every kind are malformed or hostile: class_test.py JOINTWISE EXERCISES [STUDENTS]

The first students are hostile, each kind once, but every fourth; of a larger class a tenth is.

Every honest submission has to get all of its points whatever its neighbours do, every program with a known mistake the name of that
mistake, every other submission a result and a reason; grading twice gives the same; nobody reads the key or another submission, writes
outside of the sandbox, or ends the grader.
"""

import csv
import html.parser
import io
import os
import pathlib
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import time
import zipfile

program, exercises = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
code = "n1-row-code"
# of the file those of each kind of answer: more of them would be more of the same
ASKED = ["n1-row", code, "n1-which", "n2-row", "s-row", "n1-gamma"]

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
    "half": "print('{\"answers\": [[1, 2, 3], [4,')",
    "write": """
import os, pathlib
for folder in ('/', '/submission', '/usr', '/usr/local', '/etc', '/proc/1', '/dev', '..', '../..', os.path.dirname(os.path.abspath(__file__)), 'PLACE', 'PLACE/in',
               'PLACE/out', 'PLACE/out/results'):
    for name in ('WRITTEN', 'answers.toml', 'n1-row-code.py', 's0000.json'):
        try: pathlib.Path(folder, name).write_text('WRITTEN')
        except OSError: pass
        try: os.remove(folder + '/' + name)
        except OSError: pass
print('{\"answers\": []}')
""",
    "kill parent": "import os\nos.kill(os.getppid(), 9)\nos.kill(os.getppid(), 19)\nprint('{')",
    "kill first": "import os\nos.kill(1, 9)\nos.kill(1, 15)\nos.kill(1, 19)\nprint('{')",
    "kill group": "import os\nos.killpg(0, 9)",
    "kill all": "import os\nfor p in [-1, *range(2, 70000)]:\n try: os.kill(p, 9)\n except OSError: pass",
    "kill in session": "import os, signal\nos.setsid() if os.fork() == 0 else None\nos.kill(-1, signal.SIGKILL)",
}


def zip_bomb(levels=3, copies=16):
    """A small file that unpacks to 64 MB x 16 x 16."""
    data, name = bytes(64 << 20), "zeros"
    for level in range(levels):
        packed = io.BytesIO()
        with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
            for copy in range(copies if level else 1):
                archive.writestr(f"{name}{copy}", data)
        data, name = packed.getvalue(), f"level{level}.zip"
    return data


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
    elif kind == "huge":
        with file.open("wb") as wide:
            for _ in range(100):
                wide.write(b"n1-row = [1, 2, 3]\n" * 52_000)
    elif kind == "sparse":
        with file.open("wb") as wide:
            wide.truncate(1 << 40)
    elif kind == "folder":
        file.unlink()
        (file / "answers.toml").mkdir(parents=True)
    elif kind == "socket":
        file.unlink()
        # the name of a socket has at most 107 bytes
        with socket.socket(socket.AF_UNIX) as made:
            here = os.getcwd()
            os.chdir(folder)
            made.bind("answers.toml")
            os.chdir(here)
    elif kind == "device":
        file.unlink()
        try:
            os.mknod(file, 0o666 | 0o020000, os.makedev(1, 5))  # /dev/zero
        except PermissionError:
            file.symlink_to("/dev/zero")
    elif kind == "link to itself":
        file.unlink()
        file.symlink_to("answers.toml")
    elif kind == "link to another":
        file.unlink()
        file.symlink_to("../s0000/answers.toml")
    elif kind == "bomb":
        bomb = zip_bomb()
        assert len(bomb) < 2_000_000
        for name in (code + ".zip", "answers.zip"):
            (folder / name).write_bytes(bomb)
        file.unlink()
        file.write_bytes(bomb)


BAD_ANSWERS = ["binary", "link", "pipe", "large", "brackets", "parentheses", "name", "escape", "bomb", "huge", "sparse", "folder", "socket",
               "device", "link to itself", "link to another"]
KINDS = [*((name, "wrong program") for name in PROGRAMS), *((name, "bad answers") for name in BAD_ANSWERS)]
# three of four students are hostile until each kind has occurred
fewest = -(-4 * len(KINDS) // 3) + 1
count = int(sys.argv[3]) if len(sys.argv) > 3 else fewest
if count < fewest:
    sys.exit(f"class_test: {count} students are too few for {len(KINDS)} kinds; expected at least {fewest}")


def write_exercises(file):
    head, *tables = (exercises / "jacobians.toml").read_text().split("[[exercise]]\n")
    kept = [table for table in tables if re.match(r'name = "(.*)"', table).group(1) in ASKED]
    check(len(kept) == len(ASKED), f"{len(kept)} of the exercises {ASKED} are there")
    file.write_text("[[exercise]]\n".join([head, *kept]).replace('scene = "', f'scene = "{exercises}/'))


def prepare(place):
    write_exercises(place / "asked.toml")
    (place / "key.toml").write_text(f'format = 1\nsecret = "a secret for tests"\nexercises = ["{place}/asked.toml"]\n')
    students = [f"s{k:04d}" for k in range(count)]
    (place / "roster.csv").write_text("student\n" + "\n".join(students) + "\n")
    made = run("sheet", place / "asked.toml", "--class", place / "roster.csv", "--key", place / "key.toml", "--out",
               place / "in", "--solution", "--no-figures")
    check(made.returncode == 0, made.stderr)
    expected = {}
    hostile = 0
    for k, student in enumerate(students):
        folder = place / "in" / student
        shutil.copy(folder / "solution" / "answers.toml", folder / "answers.toml")
        shutil.rmtree(folder / "solution")
        (folder / (code + ".py")).write_text(RIGHT.replace("SIGN", "-1"))
        expected[student] = "right"
        if k % 12 == 4:
            expected[student] = "sign"
            (folder / (code + ".py")).write_text(RIGHT.replace("SIGN", "1"))
        if k % 4 == 0 or (k % 10 != 7 and hostile >= len(KINDS)):
            continue
        name, expected[student] = KINDS[hostile % len(KINDS)]
        hostile += 1
        if expected[student] == "wrong program":
            (folder / (code + ".py")).write_text(PROGRAMS[name].replace("PLACE", str(place)))
        else:
            hostile_answers(name, place, folder)
    check(hostile >= len(KINDS), f"only {hostile} of {len(KINDS)} kinds of hostile submissions")
    (place / "in" / "late.zip").write_bytes(zip_bomb())
    return expected


class Page(html.parser.HTMLParser):
    """What a page links to, what its links lead to, and tables with empty cells."""

    def __init__(self, text):
        super().__init__()
        self.links, self.anchors, self.empty, self.cell = set(), set(), 0, None
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        of = dict(attributes)
        self.anchors |= {of["id"]} if "id" in of else set()
        self.links |= {of["href"]} if tag == "a" else set()
        self.cell = "" if tag == "td" else self.cell

    def handle_data(self, data):
        self.cell = None if self.cell is None else self.cell + data

    def handle_endtag(self, tag):
        if tag == "td":
            self.empty += not self.cell.strip()
            self.cell = None


def check_page(text):
    check("<script" not in text, "a script came into the page")
    page = Page(text)
    check(page.empty == 0, f"{page.empty} cells of the page are empty")
    check(any(link.startswith("#lesson-") for link in page.links), "no mistake has a link to a lesson")
    check(page.links <= {"#" + anchor for anchor in page.anchors}, f"links that lead nowhere: {page.links}")


def check_row(student, kind, row, full, sandbox):
    """Checks a student's row of the table; `full` has the points of each exercise except the one that asks for a program."""
    lost = [name for name in full if float(row[name]) != full[name]]
    if kind == "bad answers":
        check(row["problem"] or lost, f"{student}: bad answers lost no points")
        check(float(row["points"]) < float(row["of"]), f"{student}: bad answers have all points")
        return
    check(not row["problem"] and not lost, f"{student} lost points: {lost} {row['problem']}")
    if not sandbox:
        check(float(row[code]) == 0.0, f"{student}: points for a program that is not run")
    elif kind == "right":
        check(float(row[code]) == 4.0, f"{student}: a right program has {row[code]} points")
    elif kind == "sign":
        check(row[code + " mistake"] == "sign", f"{student}: the mistake is '{row[code + ' mistake']}'")
    else:
        check(float(row[code]) < 4.0, f"{student}: a hostile program has all points")


def main():
    place = pathlib.Path(tempfile.mkdtemp(prefix="jw-class-"))
    try:
        expected = prepare(place)
        key = (place / "key.toml").read_bytes()
        began = time.time()
        graded = run("grade", place / "in", "--key", place / "key.toml", "--out", place / "out", "--format", "csv")
        seconds = time.time() - began
        sandbox = graded.returncode != 3
        check(graded.returncode == 0 or "not run" in graded.stderr, f"status {graded.returncode}: {graded.stderr}")
        check("'late.zip' is an archive" in graded.stderr, "an archive is not named")
        check("\x1b" not in graded.stdout, "a terminal's escape came through")
        rows = {row["submission"]: row for row in csv.DictReader(io.StringIO(graded.stdout))}
        check(set(rows) == set(expected), f"{len(rows)} of {count} submissions have a grade")
        head = ("student", "submission", "points", "of", "problem")
        names = [n for n in rows["s0000"] if n not in head and not n.endswith(" mistake") and n != code]
        full = {name: float(rows["s0000"][name]) for name in names}
        check(sum(full.values()) > 10, "the honest have no points")
        for student, row in rows.items():
            check_row(student, expected[student], row, full, sandbox)
        # results of programs that ran out of time are not kept: there are none
        results = {file.stem: file.read_text() for file in (place / "out" / "results").iterdir()}
        check(set(results) == set(expected), f"results are missing: {set(expected) - set(results)}")
        check(not any("SPY" in text for text in results.values()), "a program found the key or another submission")
        check((place / "key.toml").read_bytes() == key, "the key was changed")
        check(not list(place.rglob("WRITTEN")), "a program wrote outside of the sandbox")
        again = run("grade", place / "in", "--key", place / "key.toml", "--out", place / "out", "--format", "csv")
        check(again.stdout == graded.stdout, "kept results differ")
        check_page((place / "out" / "class.html").read_text())
        print(f"{count} submissions graded in {seconds:.1f} s" + ("" if sandbox else "; no sandbox here, programs not run"))
    finally:
        shutil.rmtree(place, ignore_errors=True)


main()
