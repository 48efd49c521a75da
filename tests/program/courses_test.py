#!/usr/bin/python3
"""Runs the graders of docs/grading as they stand: courses_test.py JOINTWISE PROJECT"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

program, project = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
docs = project / "docs" / "grading"


def run(*arguments, **environment):
    done = subprocess.run([str(a) for a in arguments], capture_output=True, text=True, env={**os.environ, **environment})
    if done.returncode != 0:
        sys.exit(f"courses_test: {arguments[0]} ends with {done.returncode}: {done.stderr}")
    return done.stdout


def prepare(place, submission):
    """A grader's folder with key and program, and a right submission."""
    place.mkdir(parents=True)
    exercises = project / "lessons" / "exercises" / "vectors.toml"
    (place / "key.toml").write_text(f'format = 1\nsecret = "a secret for tests"\nexercises = ["{exercises}"]\n')
    run(program, "sheet", exercises, "--student", "ann", "--key", place / "key.toml", "--out", place / "made", "--solution",
        "--no-figures")
    submission.mkdir(parents=True)
    shutil.copy(place / "made" / "ann" / "solution" / "answers.toml", submission / "answers.toml")
    (place / "jointwise").mkdir()
    door = place / "jointwise" / "dev"
    door.write_text(f'#!/bin/sh\n[ "$1" = run ] && shift && exec "{program}" "$@"\n[ "$1" = setup ]\n')
    door.chmod(0o755)


with tempfile.TemporaryDirectory() as folder:
    root = pathlib.Path(folder)
    prepare(root / "gradescope" / "source", root / "gradescope" / "submission")
    run(docs / "gradescope" / "setup.sh", AUTOGRADER=str(root / "gradescope"))
    run(docs / "gradescope" / "run_autograder", AUTOGRADER=str(root / "gradescope"))
    result = json.loads((root / "gradescope" / "results" / "results.json").read_text())
    assert {"score", "tests"} <= result.keys()
    for test in result["tests"]:
        assert {"name", "score", "max_score", "output"} <= test.keys(), test
        assert test["score"] == test["max_score"] or "not handed in" in test["output"], test
    assert result["score"] > 10

    prepare(root / "grade" / "tests", root / "grade" / "student")
    info = json.loads((docs / "prairielearn" / "info.json").read_text())
    assert info["externalGradingOptions"]["entrypoint"].endswith("/grade.sh")
    run(docs / "prairielearn" / "grade.sh", GRADE=str(root / "grade"), JOINTWISE_SOURCE=str(root / "grade" / "tests" / "jointwise"))
    result = json.loads((root / "grade" / "results" / "results.json").read_text())
    assert result["gradable"] and 0.5 < result["score"] <= 1.0, result["score"]
    assert all(test["points"] <= test["max_points"] for test in result["tests"])

    workflow = (docs / "github-classroom" / ".github" / "workflows" / "grade.yml").read_text()
    import yaml
    steps = yaml.safe_load(workflow)["jobs"]["grade"]["steps"]
    assert any("grade submission" in step.get("run", "") for step in steps)
print("all three graders grade")
