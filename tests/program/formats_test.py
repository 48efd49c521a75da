#!/usr/bin/python3
"""Files as versions 0.1 and 1.0 wrote them, read with the program of today: formats_test.py JOINTWISE PROJECT

docs/formats.md is the policy: within a version of a format keys may be added, and no other changes. Newer versions are refused by name.
"""

import copy
import csv
import io
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

program, project = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
kept = project / "tests" / "formats" / "0.1"
kept_by_1 = project / "tests" / "formats" / "1.0"
# outputs that version 1.0 wrote for its lessons, and how
WRITTEN_BY_1 = {
    "cam.csv": ("solve", "cam.toml", "--step", "0.5"),
    "constant-velocity.csv": ("solve", "constant-velocity.toml", "--step", "0.5"),
    "differential.csv": ("solve", "differential.toml", "--step", "0.5"),
    "indexing-table.csv": ("solve", "indexing-table.toml", "--step", "0.5"),
    "rubber-hinge.json": ("rest", "rubber-hinge.toml", "--format", "json"),
    "sled-with-brake.csv": ("simulate", "sled-with-brake.toml", "--samples", "4"),
    "spring-that-hardens.csv": ("simulate", "spring-that-hardens.toml", "--samples", "4"),
}
# tolerance for lengths and angles about 1: solved equations are closed to 1e-10, and machines round differently
TOLERANCE = 1e-8


def run(place, *arguments):
    return subprocess.run([program, *map(str, arguments)], cwd=place, capture_output=True, text=True)


def read_by(place, *arguments):
    """Output of the program; an error status or a warning fails the test."""
    done = run(place, *arguments)
    assert done.returncode == 0, f"{arguments}: {done.returncode} {done.stdout}{done.stderr}"
    assert "warning" not in done.stderr, f"{arguments}: {done.stderr}"
    return done.stdout


def is_refused(place, words, *arguments):
    done = run(place, *arguments)
    text = done.stdout + done.stderr
    assert done.returncode != 0 and words in text, f"{arguments}: {done.returncode}, and not {words!r}: {text}"


def missing(before, now, path=""):
    """Values that are missing now or differ from before: keys may be added, and sentences improved."""
    if isinstance(before, dict):
        if not isinstance(now, dict):
            return [path]
        return [line for key in before for line in missing(before[key], now.get(key), f"{path}.{key}")]
    if isinstance(before, list):
        if not isinstance(now, list) or len(before) != len(now):
            return [path]
        return [line for k, pair in enumerate(zip(before, now)) for line in missing(*pair, f"{path}.{k}")]
    if isinstance(before, str) and " " in before:
        return [] if isinstance(now, str) else [path]
    if isinstance(before, (bool, str, type(None))):
        return [] if type(before) is type(now) and before == now else [path]
    is_number = isinstance(now, (int, float)) and not isinstance(now, bool)
    return [] if is_number and abs(before - now) <= TOLERANCE * max(1.0, abs(before)) else [path]


def columns(text):
    """The numbers of a table, by the names of its columns."""
    rows = list(csv.DictReader(io.StringIO(text)))
    return {name: [float(row[name]) for row in rows] for name in rows[0]}


def change(file, before, after):
    text = file.read_text()
    assert before in text, f"{file} has no {before}"
    file.write_text(text.replace(before, after, 1))


def numbers_are_kept(place):
    step = json.loads((kept / "step.json").read_text())
    found = missing(step, json.loads(read_by(place, "step", "crank.toml", "--format", "json")))
    assert not found, f"the JSON of 'step': {found[:5]}"
    table = columns((kept / "solve.csv").read_text())
    found = missing(table, columns(read_by(place, "solve", "crank.toml")))
    assert not found, f"the table of 'solve': {found[:5]}"
    # the comparison itself notices a word or a number that differs, and a key that is missing
    other = copy.deepcopy(step)
    other["steps"][0]["kind"] = "body"
    assert missing(step, other) == [".steps.0.kind"]
    other = copy.deepcopy(table)
    other["slider.x"][-1] += 1e-6
    assert missing(table, other) == [f".slider.x.{len(table['slider.x']) - 1}"]
    del other["slider.x"]
    assert missing(table, other) == [".slider.x"]


def lesson_and_exercise_are_read(place):
    read_by(place, "check", "crank.toml")
    read_by(place, "check", "hinge.toml")
    grade = json.loads(read_by(place, "grade", "handed", "--key", "key.toml", "--format", "json"))
    assert [(one["student"], one["earned"], one["points"]) for one in grade] == [("ann", 2.0, 2.0)], grade
    # the numbers of a student are drawn as they were: another secret draws others
    change(place / "key.toml", "a secret for tests", "another secret")
    grade = json.loads(read_by(place, "grade", "handed", "--key", "key.toml", "--format", "json"))
    assert grade[0]["earned"] == 0.0, grade


def golden_is_the_same(place):
    out = read_by(place, "snapshot", "compare", "crank.toml", "--golden", "golden")
    # colours do not count where another machine draws them
    assert "different" not in out and "1 lesson, 1 snapshot: 1 " in out, out


def manifest_is_replaced(place):
    frames = place / "frames"
    names = [frame["file"] for frame in json.loads((frames / "manifest.json").read_text())["frames"]]
    assert len(names) == 2, names
    for name in names:
        (frames / name).write_bytes(b"a picture of then")
    read_by(place, "render", "crank.toml", "--frames", "0:0", "--out", "frames")
    assert not (frames / names[1]).exists(), "a picture of the old manifest is left"
    assert (frames / names[0]).read_bytes().startswith(b"\x89PNG")
    assert [frame["file"] for frame in json.loads((frames / "manifest.json").read_text())["frames"]] == names[:1]


def newer_ones_are_refused(place):
    golden = ("snapshot", "compare", "crank.toml", "--golden", "golden")
    change(place / "golden/crank/motion-1.json", '"version": 1', '"version": 2')
    is_refused(place, "its version is 2, this program reads 1", *golden)
    change(place / "golden/crank/snapshots.json", '"version": 1', '"version": 2')
    is_refused(place, "has a version that this program does not know; it reads 1", *golden)
    change(place / "frames/manifest.json", '"version": 1', '"version": 2')
    is_refused(place, "has the version 2; this program reads 1", "render", "crank.toml", "--frames", "0:0", "--out", "frames")
    for name, command in (("crank.toml", "step"), ("hinge.toml", "check")):
        change(place / name, "format = 1", "format = 2")
        is_refused(place, "this is format 2; expected format = 1", command, name)
    change(place / "key.toml", "format = 1", "format = 2")
    is_refused(place, "expected", "grade", "handed", "--key", "key.toml")


def numbers_of_1_are_kept():
    for name, arguments in WRITTEN_BY_1.items():
        read = json.loads if name.endswith(".json") else columns
        found = missing(read((kept_by_1 / name).read_text()), read(read_by(kept_by_1, *arguments)))
        assert not found, f"{name}: {found[:5]}"
        read_by(kept_by_1, "check", arguments[1])


numbers_of_1_are_kept()
for check in (numbers_are_kept, lesson_and_exercise_are_read, golden_is_the_same, manifest_is_replaced, newer_ones_are_refused):
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder) / "0.1"
        shutil.copytree(kept, place)
        check(place)
print("files of versions 0.1 and 1.0 are read, and newer ones are refused")
