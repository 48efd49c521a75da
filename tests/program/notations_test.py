#!/usr/bin/python3
"""Right answers in the notations of students: notations_test.py JOINTWISE EXERCISES [STUDENTS [SEED]]

Takes the right answers from the key (`sheet --solution`), writes each in a notation drawn at random (decimals of enough digits, commas,
fractions, roots, powers of ten, units, other brackets and signs), hands them in and asks the grader: all have to be right. Then the answer
of each known mistake that the key lists, written in decimals: none may be right, and each has to be named. There must be enough students for
every way to write and every kind of mistake; 15 make every mistake of every exercise.
"""

import math
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
from fractions import Fraction

from course import write_course

program, exercises = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
count = int(sys.argv[3]) if len(sys.argv) > 3 else 15
seed = int(sys.argv[4]) if len(sys.argv) > 4 else 17
files = [file for file in sorted(exercises.glob("*.toml")) if file.stem not in ("clinic", "building", "experiments")]
draw = random.Random(seed)
never = {}  # for each choice, the ways that have not been drawn yet


def run(*arguments):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"notations_test: {' '.join(map(str, arguments))}: {done.stderr}")
    return done.stdout


def choice(where, ways, write=lambda way: way):
    """Draws one of the ways to write; ways that have not been drawn yet come first. `where` names the choice."""
    unused = sorted(never.setdefault(where, set(range(len(ways)))))
    draw.shuffle(unused)
    while True:
        k = unused.pop() if unused else draw.randrange(len(ways))
        text = write(ways[k])
        if text is not None:
            never[where].discard(k)
            return text


# ---- a number, written -------------------------------------------------------------------------

def decimal(x): return f"{x:.7g}"
def shorter(x): return f"{x:.5g}"


def fraction(x):
    near = Fraction(x).limit_denominator(400)
    return f"{near.numerator}/{near.denominator}" if abs(float(near) - x) < 1e-7 * max(1.0, abs(x)) else None


def root(x):
    near = Fraction(x * x).limit_denominator(400)
    if x == 0 or abs(math.sqrt(near) - abs(x)) > 1e-7 * max(1.0, abs(x)):
        return None
    sign = "-" if x < 0 else ""
    return choice("root", (f"{sign}sqrt({near})", f"{sign}√({near})", f"{sign}({near})^(1/2)", f"{sign}({near})**0.5"))


def power(x):
    if x == 0:
        return None
    of_ten = math.floor(math.log10(abs(x)))
    return f"{x / 10**of_ten:.7g}" + choice("power", (f"e{of_ten}", f"E{of_ten}", f"*10^{of_ten}", f"*10^({of_ten})", f" × 10^{of_ten}"))


def product(x): return f"2*{x / 2:.8g}"
def bracketed(x): return f"({decimal(x)})"
def unicode_minus(x): return decimal(x).replace("-", "−") if "e" not in decimal(x) else None
def full_width(x): return "".join(chr(ord(c) + 0xFEE0) if c in "0123456789-" else c for c in decimal(x)) if "e" not in decimal(x) else None
def with_plus(x): return "+" + decimal(x) if x > 0 else None
def no_zero(x): return decimal(x).replace("0.", ".", 1) if 0 < x < 1 and "e" not in decimal(x) else None


NOTATIONS = (decimal, shorter, fraction, root, power, product, bracketed, unicode_minus, full_width, with_plus, no_zero)


def number(x, where):
    return choice("number in " + where, NOTATIONS, lambda way: way(x))


def comma(x): return decimal(x).replace(".", ",")


# ---- an answer, written ------------------------------------------------------------------------

def in_list(values):
    """Decimals, or each entry in a notation of its own; the places of an order as whole numbers."""
    is_order = sorted(values) == list(range(1, len(values) + 1))
    entries = [number(x, "a list") for x in values] if draw.random() < 0.5 and not is_order else [decimal(x) for x in values]
    brackets = choice("brackets", ("[{}]", "({})", "{}", "[ {} ]"))
    return brackets.format(choice("between", (", ", ",", "; ", "  ")).join(entry.replace(" × ", "×") for entry in entries))


def in_list_with_commas(values):
    return "[" + "; ".join(map(comma, values)) + "]"


def in_rows(rows):
    entries = [[number(x, "rows").replace(" × ", "×") for x in row] for row in rows]
    lines = [", ".join(row) for row in entries]
    return choice("rows", (
        "[" + ", ".join(f"[{line}]" for line in lines) + "]",
        "[" + "; ".join(lines) + "]",
        "; ".join(lines),
        "((" + "), (".join(lines) + "))"))


def with_unit(x, unit):
    """The same angle in the other unit, or the unit written behind the answer."""
    if unit == "deg":
        return choice(unit, (f"{decimal(x)} deg", f"{decimal(x)}°", f"{math.radians(x):.8g} rad", f"{math.radians(x) / math.pi:.8g} pi rad"))
    if unit == "rad":
        return choice(unit, (f"{decimal(x)} rad", f"{math.degrees(x):.8g} deg", f"{x / math.pi:.8g} pi", f"{math.degrees(x):.8g}°"))
    if unit == "m":
        return choice(unit, (f"{decimal(x)} m", f"{1000 * x:.7g} mm", f"{100 * x:.7g} cm"))
    return f"{decimal(x)} {unit}"


def written(value, unit):
    if not isinstance(value, list):
        if unit in ("deg", "rad", "m") and never.get(unit, True):  # few answers have a unit: all its ways first
            return with_unit(value, unit)
        ways = [lambda: number(value, "an answer"), lambda: comma(value)]
        if unit:
            ways += 2 * [lambda: with_unit(value, unit)]
        return choice("answer with a unit" if unit else "answer", ways)()
    if isinstance(value[0], list):
        return in_rows(value)
    return choice("list", (in_list, in_list, in_list, in_list_with_commas))(value)


def plain(value): return "[" + ", ".join(map(plain, value)) + "]" if isinstance(value, list) else f"{value:.9g}"


# ---- keys and grades ---------------------------------------------------------------------------

def right_of(folder):
    """Name, answer and unit of each numerical answer in the key of a student."""
    lines = re.findall(r'^([\w-]+) = "(.*)"(?:  # (.*))?$', (folder / "solution" / "answers.toml").read_text(), re.MULTILINE)
    return {name: (eval(text, {"__builtins__": {}}), unit) for name, text, unit in lines if re.fullmatch(r"[][\d., e+-]+", text)}


def mistakes_of(folder):
    """For each exercise the mistaken answers that its key lists, with what is said about them."""
    html = (folder / "solution" / "sheet.html").read_text()
    found = {}
    for section in html.split("<section>")[1:]:
        name = re.search(r"answer <code>(.*?)</code>", section).group(1)
        listed = section.partition("Known mistakes")[2]
        found[name] = re.findall(r"<li><code>([][\d., e+-]+)</code>(.*?)</li>", listed, re.DOTALL)
    return found


def grades(place, handed):
    """Grades all at once, since a run reads all exercises. @return for each student's submission what is said about each exercise"""
    for k, (student, values) in enumerate(handed):
        lines = [f'{name} = "{text}"' for name, text in values.items()]
        (place / "handed" / f"{k:04d}").mkdir(parents=True)
        (place / "handed" / f"{k:04d}" / "answers.toml").write_text(
            f'format = 1\nstudent = "{student}"\n[answers]\n' + "\n".join(lines) + "\n")
    of, said = [], []
    for line in run("grade", place / "handed", "--key", place / "key.toml", "--format", "text").splitlines():
        if head := re.match(r"(\S+): [\d.]+ of ", line):
            of.append(head.group(1))
            said.append({})
        elif verdict := re.match(r"  \S+  (\S+): (.*)$", line):
            said[-1][verdict.group(1)] = verdict.group(2)
    if of != [student for student, _ in handed]:
        sys.exit(f"notations_test: {len(handed)} submissions, and grades of {of}")
    return said


def kind_of(said): return said.partition(". ")[0]


def mistaken(keys, known, made):
    """For each student and exercise a mistake that nobody has made yet, of a kind that nobody has made if there is one."""
    wrong = {student: {} for student in keys}
    kinds = {kind_of(said) for _, said in made}
    for student, key in keys.items():
        for name in key:
            left = [(text, said) for text, said in known[student].get(name, ()) if (name, said) not in made]
            if left:
                text, said = min(left, key=lambda one: kind_of(one[1]) in kinds)
                kinds.add(kind_of(said))
                made.add((name, said))
                wrong[student][name] = text
    return wrong


def main():
    place = pathlib.Path(tempfile.mkdtemp(prefix="jw-notations-"))
    try:
        students = write_course(place, files, f"a secret for notations {seed}", count)
        run("sheet", *files, "--class", place / "roster.csv", "--key", place / "key.toml", "--out", place / "in", "--solution",
            "--no-figures")
        keys = {student: right_of(place / "in" / student) for student in students}
        right = [(student, {name: written(*answer) for name, answer in key.items()}) for _ in range(2) for student, key in keys.items()]
        unused = sorted(where for where, ways in never.items() if ways)
        if unused:
            sys.exit(f"notations_test: seed {seed}: {count} students are too few for every way to write: {unused}")
        known = {student: mistakes_of(place / "in" / student) for student in students}
        listed = {(name, said) for student, key in keys.items() for name in key for _, said in known[student].get(name, ())}
        made = set()
        wrong = [of for _ in range(2) for of in mistaken(keys, known, made).items()]
        kinds = {kind_of(said) for _, said in made}
        if unseen := {kind_of(said) for _, said in listed} - kinds:
            sys.exit(f"notations_test: seed {seed}: {count} students are too few for every kind of mistake: {unseen}")
        judged, bad = 0, []
        said = grades(place, right + wrong)
        for (student, values), of in zip(right, said):
            for name, text in values.items():
                judged += 1
                if of[name] != "right":
                    bad.append(f"{student} {name}: {text!r} for {plain(keys[student][name][0])}: {of[name]}")
        if bad:
            sys.exit(f"notations_test: seed {seed}: {len(bad)} right answers of {judged} are not right:\n" + "\n".join(bad[:20]))
        for (student, values), of in zip(wrong, said[len(right):]):
            for name, text in values.items():
                if not of[name].startswith("wrong: "):
                    bad.append(f"{student} {name}: {text!r}: {of[name]}")
        if bad:
            sys.exit(f"notations_test: seed {seed}: {len(bad)} mistakes of {len(made)} are not named:\n" + "\n".join(bad[:20]))
        print(f"seed {seed}: {judged} right answers in {len(NOTATIONS)} notations, {len(made)} of {len(listed)} "
              f"known mistakes, of {len(kinds)} kinds, named")
    finally:
        shutil.rmtree(place, ignore_errors=True)


main()
