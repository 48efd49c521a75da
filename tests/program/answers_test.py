#!/usr/bin/python3
"""Solves exercises in a second way: answers_test.py JOINTWISE EXERCISES [STUDENTS]

Reads the numbers on the sheets of students as they do, computes the answers from definitions (products of quaternions, cross
products, derivatives of components), hands them in rounded to five digits, and asks the grader: all have to be right. The same answers
with an entry off by 1.2 % of the largest one have to be wrong.
"""

import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from course import write_course

program, exercises = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
count = int(sys.argv[3]) if len(sys.argv) > 3 else 10
files = [exercises / (name + ".toml") for name in ("vectors", "orientation", "jacobians", "analysis")]


# ---- vectors and rotations ---------------------------------------------------------------------

def dot(a, b): return sum(x * y for x, y in zip(a, b))
def add(*all_of): return [sum(x) for x in zip(*all_of)]
def scale(f, a): return [f * x for x in a]
def sub(a, b): return add(a, scale(-1, b))
def cross(a, b): return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
def times(m, v): return [dot(row, v) for row in m]
def turned(m): return [list(column) for column in zip(*m)]
def unit(k, n=3): return [float(j == k) for j in range(n)]
def by_columns(function, n=3): return turned([function(unit(k, n)) for k in range(n)])
def skew(a): return by_columns(lambda x: cross(a, x))


def quaternion(p, q):
    return [p[0] * q[0] - dot(p[1:], q[1:])] + add(scale(p[0], q[1:]), scale(q[0], p[1:]), cross(p[1:], q[1:]))


def conjugate(p): return [p[0]] + scale(-1, p[1:])
def rotated(p, v): return quaternion(quaternion(p, [0] + v), conjugate(p))[1:]
def matrix(p): return by_columns(lambda x: rotated(p, x))
def rate(p, local): return scale(0.5, quaternion(p, [0] + local))
def twice(w, s): return cross(w, cross(w, s))
def normalised(y): return scale(1 / math.sqrt(dot(y, y)), y)


def solved(m, right):
    """By elimination with pivots."""
    rows = [list(row) + [b] for row, b in zip(m, right)]
    n = len(rows)
    for k in range(n):
        best = max(range(k, n), key=lambda r: abs(rows[r][k]))
        rows[k], rows[best] = rows[best], rows[k]
        for r in range(n):
            if r != k:
                rows[r] = sub(rows[r], scale(rows[r][k] / rows[k][k], rows[k]))
    return [rows[k][n] / rows[k][k] for k in range(n)]


# ---- the slider-crank: crank 0.2 m, rod 0.5 m --------------------------------------------------

def slider(angle): return 0.2 * math.cos(angle) + math.sqrt(0.25 - (0.2 * math.sin(angle)) ** 2)


def derivatives(function, x, h=1e-4):
    return (function(x + h) - function(x - h)) / (2 * h), (function(x + h) - 2 * function(x) + function(x - h)) / h**2


def rod_pose(phi):
    beta = math.asin(0.4 * math.sin(phi))
    return [0.2 * math.cos(phi), 0.2 * math.sin(phi), 0, math.cos(beta / 2), 0, 0, -math.sin(beta / 2)]


def n1_of_p(g):
    """The matrix of slide 13 is of second degree in p, so that central differences are exact; e0² + eᵀe is not replaced by 1."""
    def value(p):
        e0, e, s = p[0], p[1:], g["s_i'"]
        return dot(g["s_j"], add(scale(2 * e0 * e0 - 1, s), scale(2 * dot(e, s), e), scale(2 * e0, cross(e, s))))
    return [(value(add(g["p_i"], unit(k, 4))) - value(sub(g["p_i"], unit(k, 4)))) / 2 for k in range(4)]


def g_of(p): return by_columns(lambda x: quaternion(x, conjugate(p))[1:], 4)


SOLVERS = {
    "global-vector": lambda g: rotated(g["p_i"], g["s_i'"]),
    "local-vector": lambda g: times(turned(g["A_j"]), g["s_j"]),
    "n1-value": lambda g: dot(g["s_i"], times(g["A_j"], g["s_j'"])),
    "d-vector": lambda g: sub(add(g["r_j"], times(g["A_j"], g["s_j'B"])), add(g["r_i"], times(g["A_i"], g["s_i'B"]))),
    "n2-value": lambda g: dot(g["s_i"], sub(add(g["r_j"], g["s_jB"]), add(g["r_i"], g["s_iB"]))),
    "skew-matrix": lambda g: skew(times(g["A_i"], g["s_i'"])),
    "p1-vector": lambda g: cross(g["s_i"], times(g["A_j"], g["s_j'"])),
    "p2-vector": lambda g: cross(g["s_i"], sub(add(g["r_j"], g["s_jB"]), add(g["r_i"], g["s_iB"]))),
    "pose-of-gate": lambda g: g["r"] + [math.cos(g["phi"] / 2)] + scale(math.sin(g["phi"] / 2), g["u"]),
    "angle-of-p": lambda g: math.degrees(2 * math.acos(g["p"][0])),
    "matrix-of-p": lambda g: matrix(g["p"]),
    "g-matrix": lambda g: g_of(g["p"]),
    "pdot-of-omega": lambda g: rate(g["p"], g["w'"]),
    "omega-of-pdot": lambda g: scale(2, quaternion(conjugate(g["p"]), g["dp"])[1:]),
    "omega-global": lambda g: rotated(g["p"], g["w'"]),
    "a-dot": lambda g: by_columns(lambda x: times(g["A"], cross(g["w'"], x))),
    "n1-row": lambda g: [dot(g["s_j"], cross(column, g["s_i"])) for column in turned(g["A_i"])],
    "n2-row": lambda g: [dot(add(g["d"], g["s_iB"]), cross(column, g["s_i"])) for column in turned(g["A_i"])],
    "p1-row": lambda g: turned([cross(g["s_i"], cross(column, g["s_j"])) for column in turned(g["A_j"])]),
    "s-row": lambda g: by_columns(lambda x: times(g["A_i"], cross(x, g["s_i'P"]))),
    "n1-gamma": lambda g: -dot(cross(g["w_i"], g["ds_i"]), g["s_j"]) - 2 * dot(g["ds_i"], g["ds_j"])
                          - dot(g["s_i"], cross(g["w_j"], g["ds_j"])),
    "s-gamma": lambda g: sub(twice(g["w_j"], g["s_jP"]), twice(g["w_i"], g["s_iP"])),
    "p1-gamma": lambda g: scale(-1, add(cross(twice(g["w_i"], g["s_i"]), g["s_j"]),
                                        scale(2, cross(cross(g["w_i"], g["s_i"]), cross(g["w_j"], g["s_j"]))),
                                        cross(g["s_i"], twice(g["w_j"], g["s_j"])))),
    "n2-gamma": lambda g: -dot(cross(g["w_i"], g["ds_i"]), g["d"]) - 2 * dot(g["ds_i"], g["dd"])
                          - dot(g["s_i"], sub(cross(g["w_j"], g["ds_jB"]), cross(g["w_i"], g["ds_iB"]))),
    "n1-p-row": n1_of_p,
    "s-modified": lambda g: by_columns(lambda x: scale(2, times(g["G_i"], quaternion(x, [0] + g["s_i'P"]))), 4),
    "n1-gamma-modified": lambda g: dot(g["s_i"], g["h_j"]) + dot(g["s_j"], g["h_i"]) - 2 * dot(g["ds_i"], g["ds_j"]),
    "row-converted": lambda g: [dot(g["Phi_p_i"], rate(g["p_i"], unit(k))) for k in range(3)],
    "newton-step": lambda g: solved(g["Phi_q"], scale(-1, g["Phi"])),
    "rod-pose": lambda g: rod_pose(g["phi"]),
    "velocities-solved": lambda g: solved(g["Phi_q"], scale(-1, g["Phi_t"])),
    "slider-speed": lambda g: derivatives(slider, g["phi"])[0] * g["Omega"],
    "slider-acceleration": lambda g: derivatives(slider, g["phi"])[1] * g["Omega"] ** 2,
    "gamma-converted": lambda g: g["gamma"] + sum(dot(g["w_" + b + "'"], g["w_" + b + "'"]) / 4 * dot(g["Phi_p_" + b], g["p_" + b])
                                                  for b in "ij"),
    "point-of-top": lambda g: add(g["r_j"], rotated(g["p_j"], g["s_j'P"])),
    "euler-step-r": lambda g: add(g["r_jP"], scale(0.1, add(g["dr_j"], times(g["A_j"], cross(g["w_j'"], g["s_j'P"]))))),
    "euler-step-p": lambda g: normalised(add(g["p"], scale(0.1, rate(g["p"], g["w'"])))),
    # three bodies have 18 coordinates; the kinds of the joints tell which freedoms are left
    "four-bar-rank": lambda g: 18 - {"RRRR": 0 if g["motor"] else 1, "RRSS": 2, "CCCC": 4}[g["kinds"]],
    # all of these loops have one freedom
    "bennett-redundant": lambda g: equations(g) - 17,
    "slider-crank-grubler": lambda g: 18 - equations(g),
    "rssr-freedoms": lambda g: {"RSSR": 2, "RUSR": 1, "RSSC": 3, "CSSC": 4}[g["kinds"]],
}


EQUATIONS = {"R": 5, "P": 5, "C": 4, "U": 4, "S": 3}


def equations(g): return sum(EQUATIONS[kind] for kind in g["kinds"]) + g["motor"]


# ---- sheets and grades -------------------------------------------------------------------------

def key_of(latex):
    """\\dot{\\boldsymbol{s}}_{i}^{\\prime P} is ds_i'P."""
    for long, short in ((r"\boldsymbol", ""), (r"\mathbf", ""), (r"\dot", "d"), (r"\prime", "'"), (r"\omega", "w"), (r"\varphi", "phi"),
                        ("{", ""), ("}", ""), ("^", ""), ("\\", ""), (" ", "")):
        latex = latex.replace(long, short)
    return latex


def number_of(latex):
    return float(re.sub(r" *\\cdot 10\^\{(.*?)\}", r"e\1", latex).replace(" ", ""))


def value_of(latex):
    """A number, a fraction, or a matrix with a common denominator before it."""
    fraction = re.fullmatch(r"(-?) ?\\frac\{(\d+)\}\{(\d+)\}", latex.strip())
    if fraction:
        return float(fraction.group(1) + "1") * int(fraction.group(2)) / int(fraction.group(3))
    inside = re.fullmatch(r"(?:\\frac\{1\}\{(\d+)\} ?)?\\begin\{bmatrix\}(.*)\\end\{bmatrix\}", latex.strip())
    if not inside:
        return number_of(latex)
    by = int(inside.group(1) or 1)
    rows = [[number_of(entry) / by for entry in row.split("&")] for row in inside.group(2).split(r"\\")]
    if len(rows) == 1:
        return rows[0]
    return [row[0] for row in rows] if len(rows[0]) == 1 else rows


def given_on(folder):
    """For each exercise of a sheet in Markdown its given values, and the kinds of the joints of its lesson file."""
    told = {}
    for part in re.split(r"\n## \d+\. ", (folder / "sheet.md").read_text())[1:]:
        name = re.search(r"answer `(.*?)`", part).group(1)
        lines = re.findall(r"^- \$(.*?) = (.*)\$$", part, re.MULTILINE)
        told[name] = {key_of(symbol): value_of(value) for symbol, value in lines}
        # "RSSR" of the lesson file that is asked about
        file = folder / (name + ".toml")
        types = re.findall(r"""^type = ["'](.)""", file.read_text(), re.MULTILINE) if file.exists() else []
        told[name].update(kinds="".join(types).upper(), motor="and a motor" in part)
    return told


def entries_of(value): return [x for part in value for x in entries_of(part)] if isinstance(value, list) else [value]


def changed(value, by):
    """The value with its last entry changed by `by`."""
    return value[:-1] + [changed(value[-1], by)] if isinstance(value, list) else value + by


def written(value):
    return "[" + ", ".join(map(written, value)) + "]" if isinstance(value, list) else f"{value:.5g}"


def run(*arguments):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"answers_test: {' '.join(map(str, arguments))}: {done.stderr}")
    return done.stdout


def grade(place, answers, verdict):
    """Hands in the answers of all students; each answer has to get the verdict."""
    for student, values in answers.items():
        lines = [f'{name} = "{written(value)}"' for name, value in values.items()]
        (place / "in" / student / "answers.toml").write_text(
            f'format = 1\nstudent = "{student}"\n[answers]\n' + "\n".join(lines) + "\n")
    text = run("grade", place / "in", "--key", place / "key.toml", "--format", "text")
    found = re.findall(r"^  \S+  (\S+): (.*)$", text, re.MULTILINE)
    bad = [(name, said) for name, said in found if name in SOLVERS and not said.startswith(verdict)]
    bad = [entry for entry in bad if entry[1] != "not handed in"]
    judged = [name for name, said in found if name in SOLVERS and said.startswith(verdict)]
    if bad or len(judged) != sum(len(values) for values in answers.values()):
        sys.exit(f"answers_test: expected {verdict}: {bad[:10]}\n{text[:3000]}")


def main():
    place = pathlib.Path(tempfile.mkdtemp(prefix="jw-answers-"))
    try:
        students = write_course(place, files, "a secret for tests", count)
        run("sheet", *files, "--class", place / "roster.csv", "--key", place / "key.toml", "--out", place / "in", "--no-figures")
        right = {}
        for student in students:
            told = given_on(place / "in" / student)
            right[student] = {name: solve(told[name]) for name, solve in SOLVERS.items()}
        grade(place, right, "right")
        # for wrong answers half of the students are enough
        for student in students[1::2]:
            shutil.rmtree(place / "in" / student)
            del right[student]
        # the widest tolerance of these exercises is one percent
        wrong = {student: {name: changed(value, 0.012 * max(map(abs, entries_of(value))))
                           for name, value in values.items() if not isinstance(value, int)} for student, values in right.items()}
        grade(place, wrong, "wrong")
        print(f"{len(SOLVERS)} exercises of {count} students solved a second way")
    finally:
        shutil.rmtree(place, ignore_errors=True)


main()
