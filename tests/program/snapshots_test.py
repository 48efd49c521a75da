#!/usr/bin/python3
"""Runs the template of docs/snapshots as its workflow does, as it stands and with a fault in each layer:
snapshots_test.py JOINTWISE PROJECT"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

import yaml

program, project = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
template = project / "docs" / "snapshots" / "template"


def commands():
    """What the workflow runs, in its order."""
    workflow = yaml.safe_load((template / ".github" / "workflows" / "lessons.yml").read_text())
    return [step["run"] for step in workflow["jobs"]["lessons"]["steps"] if "run" in step]


def repository(root):
    """A copy of the template beside a door that runs the program under test."""
    place = root / "repository"
    shutil.copytree(template, place)
    door = place / "jointwise" / "dev"
    door.parent.mkdir()
    door.write_text(f'#!/bin/sh\n[ "$1" = run ] && shift && exec "{program}" "$@"\n[ "$1" = setup ]\n')
    door.chmod(0o755)
    return place


def run(place, command):
    return subprocess.run(["sh", "-e", "-c", command], cwd=place, capture_output=True, text=True)


def report(place):
    return told(place, run(place, commands()[-1]))


def told(place, done):
    assert done.returncode in (0, 1), done.stderr
    page = (place / "report" / "index.html").read_text()
    assert "http://" not in page and "https://" not in page, "the page needs something else"
    xml.etree.ElementTree.parse(place / "report" / "junit.xml")
    found = json.loads((place / "report" / "report.json").read_text())
    assert found["fails"] == (done.returncode == 1), done.stdout
    return found, page


def changed(place, lesson, before, after):
    file = place / "lessons" / lesson
    text = file.read_text()
    assert before in text
    file.write_text(text.replace(before, after))


with tempfile.TemporaryDirectory() as folder:
    place = repository(pathlib.Path(folder))
    for command in commands():
        done = run(place, command)
        assert done.returncode == 0, f"{command}: {done.stdout}{done.stderr}"
    found, page = told(place, done)
    assert not found["fails"]
    assert all(control["noticed"] for lesson in found["lessons"] for control in lesson["controls"]), found
    assert sum(len(lesson["controls"]) for lesson in found["lessons"]) >= 6, found

    # one radius is 1 mm larger: one line says so
    changed(place, "gate.toml", "radius = 0.02 ", "radius = 0.021 ")
    # a joint that is left out of the other lesson
    text = (place / "lessons" / "slider-crank.toml").read_text()
    begin, end = text.index('[[joint]]\nname = "wrist"'), text.index("[[driver]]")
    (place / "lessons" / "slider-crank.toml").write_text(
        (text[:begin] + text[end:]).replace('after = "wrist"\nrank = 17', 'after = "pin"\nrank = 15'))
    found, page = report(place)
    gate, slider_crank = found["lessons"]
    why = "radius of gate: 1 mm larger (body.gate.shape.1.rod.radius, 0.02 → 0.021)"
    assert gate["fails"] and gate["why"] == why, gate
    assert why in page and 'type="range"' in page
    verdicts = {snapshot["name"]: snapshot["verdict"] for snapshot in slider_crank["snapshots"]}
    assert verdicts["wrist"] == "gone" and verdicts["motion-0.8"] == "different", verdicts
    assert slider_crank["why"].startswith("joint.wrist: left out"), slider_crank["why"]

    # blessed with a reason, it is as expected again, and only the other lesson fails
    done = run(place, "jointwise/dev run snapshot bless lessons/gate.toml --golden golden --reason 'a stronger handle'")
    assert done.returncode == 0, done.stderr
    assert [lesson["fails"] for lesson in report(place)[0]["lessons"]] == [False, True]
    assert json.loads((place / "golden" / "gate" / "hinge.json").read_text())["blessed"][-1] == "a stronger handle"
print("the template's workflow passes, and notices faults")
