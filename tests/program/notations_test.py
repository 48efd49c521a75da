#!/usr/bin/python3
"""Right answers in the notations of students: notations_test.py JOINTWISE EXERCISES [STUDENTS [SEED]]

Takes the right answers from the key (`sheet --solution`), writes each in a notation drawn at random (decimals of enough digits, commas,
fractions, roots, powers of ten, units, other brackets and signs), hands them in and asks the grader: all have to be right. Then the answer
of each known mistake that the key lists, written in decimals: none may be right, and each has to be named.
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


def run(*arguments):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"notations_test: {' '.join(map(str, arguments))}: {done.stderr}")
    return done.stdout


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
    return draw.choice((f"{sign}sqrt({near})", f"{sign}√({near})", f"{sign}({near})^(1/2)", f"{sign}({near})**0.5"))


def power(x):
    if x == 0:
        return None
    of_ten = math.floor(math.log10(abs(x)))
    return f"{x / 10**of_ten:.7g}" + draw.choice((f"e{of_ten}", f"E{of_ten}", f"*10^{of_ten}", f"*10^({of_ten})", f" × 10^{of_ten}"))


def product(x): return f"2*{x / 2:.8g}"
def bracketed(x): return f"({decimal(x)})"
def unicode_minus(x): return decimal(x).replace("-", "−") if "e" not in decimal(x) else None
def full_width(x): return "".join(chr(ord(c) + 0xFEE0) if c in "0123456789-" else c for c in decimal(x)) if "e" not in decimal(x) else None
def with_plus(x): return "+" + decimal(x) if x > 0 else None
def no_zero(x): return decimal(x).replace("0.", ".", 1) if 0 < x < 1 and "e" not in decimal(x) else None


NOTATIONS = (decimal, shorter, fraction, root, power, product, bracketed, unicode_minus, full_width, with_plus, no_zero)


def number(x):
    while True:
        text = draw.choice(NOTATIONS)(x)
        if text is not None:
            return text


def comma(x): return decimal(x).replace(".", ",")


# ---- an answer, written ------------------------------------------------------------------------

def in_list(values):
    """Decimals, or each entry in a notation of its own; the places of an order as whole numbers."""
    is_order = sorted(values) == list(range(1, len(values) + 1))
    entries = [number(x) for x in values] if draw.random() < 0.5 and not is_order else [decimal(x) for x in values]
    return draw.choice(("[{}]", "({})", "{}", "[ {} ]")).format(draw.choice((", ", ",", "; ", "  ")).join(entry.replace(" × ", "×") for entry in entries))


def in_list_with_commas(values):
    return "[" + "; ".join(map(comma, values)) + "]"


def in_rows(rows):
    entries = [[number(x).replace(" × ", "×") for x in row] for row in rows]
    lines = [", ".join(row) for row in entries]
    return draw.choice((
        "[" + ", ".join(f"[{line}]" for line in lines) + "]",
        "[" + "; ".join(lines) + "]",
        "; ".join(lines),
        "((" + "), (".join(lines) + "))"))


def with_unit(x, unit):
    """The same angle in the other unit, or the unit written behind the answer."""
    if unit == "deg":
        return draw.choice((f"{decimal(x)} deg", f"{decimal(x)}°", f"{math.radians(x):.8g} rad", f"{math.radians(x) / math.pi:.8g} pi rad"))
    if unit == "rad":
        return draw.choice((f"{decimal(x)} rad", f"{math.degrees(x):.8g} deg", f"{x / math.pi:.8g} pi", f"{math.degrees(x):.8g}°"))
    if unit == "m":
        return draw.choice((f"{decimal(x)} m", f"{1000 * x:.7g} mm", f"{100 * x:.7g} cm"))
    return f"{decimal(x)} {unit}"


def written(value, unit):
    if not isinstance(value, list):
        ways = [lambda: number(value), lambda: comma(value)]
        if unit:
            ways += 2 * [lambda: with_unit(value, unit)]
        return draw.choice(ways)()
    if isinstance(value[0], list):
        return in_rows(value)
    return draw.choice((in_list, in_list, in_list, in_list_with_commas))(value)


def plain(value): return "[" + ", ".join(map(plain, value)) + "]" if isinstance(value, list) else f"{value:.9g}"


# ---- keys and grades ---------------------------------------------------------------------------

def right_of(folder):
    """Name, answer and unit of each answer of numbers in the key of a student."""
    lines = re.findall(r'^([\w-]+) = "(.*)"(?:  # (.*))?$', (folder / "solution" / "answers.toml").read_text(), re.MULTILINE)
    return {name: (eval(text, {"__builtins__": {}}), unit) for name, text, unit in lines if re.fullmatch(r"[][\d., e+-]+", text)}


def mistakes_of(folder):
    """For each exercise the mistaken answers that its key lists, with their titles."""
    html = (folder / "solution" / "sheet.html").read_text()
    found = {}
    for section in html.split("<section>")[1:]:
        name = re.search(r"answer <code>(.*?)</code>", section).group(1)
        listed = section.partition("Known mistakes")[2]
        found[name] = re.findall(r"<li><code>([][\d., e+-]+)</code>", listed)
    return found


def grades(place, answers):
    """@return for each student and exercise what the grader says"""
    for student, values in answers.items():
        lines = [f'{name} = "{text}"' for name, text in values.items()]
        (place / "in" / student / "answers.toml").write_text(
            f'format = 1\nstudent = "{student}"\n[answers]\n' + "\n".join(lines) + "\n")
    shutil.rmtree(place / "graded", ignore_errors=True)
    said = {}
    student = None
    for line in run("grade", place / "in", "--key", place / "key.toml", "--format", "text").splitlines():
        if head := re.match(r"(\S+): [\d.]+ of ", line):
            student = head.group(1)
        elif verdict := re.match(r"  \S+  (\S+): (.*)$", line):
            said[student, verdict.group(1)] = verdict.group(2)
    return said


def main():
    place = pathlib.Path(tempfile.mkdtemp(prefix="jw-notations-"))
    try:
        students = write_course(place, files, f"a secret for notations {seed}", count)
        run("sheet", *files, "--class", place / "roster.csv", "--key", place / "key.toml", "--out", place / "in", "--solution",
            "--no-figures")
        keys = {student: right_of(place / "in" / student) for student in students}
        judged, bad = 0, []
        for _ in range(2):
            answers = {student: {name: written(*answer) for name, answer in key.items()} for student, key in keys.items()}
            said = grades(place, answers)
            for student, values in answers.items():
                for name, text in values.items():
                    judged += 1
                    if said[student, name] != "right":
                        bad.append(f"{student} {name}: {text!r} for {plain(keys[student][name][0])}: {said[student, name]}")
        if bad:
            sys.exit(f"notations_test: seed {seed}: {len(bad)} right answers of {judged} are not right:\n" + "\n".join(bad[:20]))
        named = 0
        for round_of in range(3):
            wrong = {}
            for student in students[:10]:
                known = mistakes_of(place / "in" / student)
                wrong[student] = {name: draw.choice(known[name]) for name in keys[student] if known.get(name)}
            said = grades(place, wrong)
            for student, values in wrong.items():
                for name, text in values.items():
                    named += 1
                    if not said[student, name].startswith("wrong: "):
                        bad.append(f"{student} {name}: {text!r}: {said[student, name]}")
        if bad:
            sys.exit(f"notations_test: seed {seed}: {len(bad)} mistakes of {named} are not named:\n" + "\n".join(bad[:20]))
        print(f"seed {seed}: {judged} right answers in {len(NOTATIONS)} notations, {named} known mistakes named")
    finally:
        shutil.rmtree(place, ignore_errors=True)


main()
