#!/usr/bin/python3
"""Runs the graders of docs/grading as they stand: courses_test.py JOINTWISE PROJECT"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from formats import check_gradescope, check_junit, check_moodle, check_prairielearn

program, project = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
docs = project / "docs" / "grading"


SUBMISSIONS = {
    "wrong": b'student = "wrong"\n[answers]\nglobal-vector = "[1, 2, 3]"\n',
    "nothing": b'student = "nothing"\n[answers]\n',
    "escape": b'student = "escape"\n[answers]\nglobal-vector = "<b>]]>&amp;\\u001b\\u0085\\uffff\\"\'"\n',
    "bytes": b"\xff\xfe\x00<>",
}
LESSONS = {
    "fails.toml": b'format = 1\ntitle = "F"\n[[body]]\nname = "a"\n[[expect]]\nrank = 3\n',
    "none.toml": b'format = 1\ntitle = "N"\n[[body]]\nname = "a"\n',
    "broken.toml": b'format = 1\ntitle = "B<>&\x01"\n[[body\n',
}


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
    check_gradescope(result)
    for test in result["tests"]:
        assert test["score"] == test["max_score"] or "not handed in" in test["output"], test
    assert result["score"] > 10

    prepare(root / "grade" / "tests", root / "grade" / "student")
    info = json.loads((docs / "prairielearn" / "info.json").read_text())
    assert info["externalGradingOptions"]["entrypoint"].endswith("/grade.sh")
    run(docs / "prairielearn" / "grade.sh", GRADE=str(root / "grade"), JOINTWISE_SOURCE=str(root / "grade" / "tests" / "jointwise"))
    result = json.loads((root / "grade" / "results" / "results.json").read_text())
    check_prairielearn(result)
    assert 0.5 < result["score"] <= 1.0, result["score"]

    # a submission that cannot be read does not count as an attempt
    (root / "grade" / "student" / "answers.toml").write_bytes(b"\xff\xfe\x00<>")
    run(docs / "prairielearn" / "grade.sh", GRADE=str(root / "grade"), JOINTWISE_SOURCE=str(root / "grade" / "tests" / "jointwise"))
    result = json.loads((root / "grade" / "results" / "results.json").read_text())
    check_prairielearn(result)
    assert not result["gradable"], result

    # quizzes of all exercises, with a figure in some of them
    files = sorted((project / "lessons" / "exercises").glob("*.toml"))
    run(program, "sheet", *files, "--variants", "2", "--key", root / "grade" / "tests" / "key.toml", "--out", root / "quiz",
        "--format", "moodle", "--no-figures")
    counts = check_moodle((root / "quiz" / "moodle.xml").read_text())
    assert all(counts[kind] >= 2 for kind in ("cloze", "numerical", "multichoice", "shortanswer")), counts
    drawn = project / "lessons" / "exercises" / "hard.toml"
    run(program, "sheet", drawn, "--student", "ann", "--key", root / "grade" / "tests" / "key.toml", "--out", root / "drawn",
        "--format", "moodle")
    assert "@@PLUGINFILE@@" in (root / "drawn" / "moodle.xml").read_text()
    check_moodle((root / "drawn" / "moodle.xml").read_text())

    # wrong, missing, hostile and unreadable submissions in every format
    key, class_of = root / "grade" / "tests" / "key.toml", root / "class"
    for student, text in SUBMISSIONS.items():
        (class_of / student).mkdir(parents=True)
        (class_of / student / "answers.toml").write_bytes(text)
    names = check_junit(run(program, "grade", class_of, "--key", key, "--format", "junit"))
    assert names.count("global-vector") == len(SUBMISSIONS), names
    for student in SUBMISSIONS:
        check_gradescope(json.loads(run(program, "grade", class_of / student, "--key", key, "--format", "gradescope")))
    catalogue = project / "lessons" / "catalogue" / "vectors"
    assert check_junit(run(program, "check", catalogue, "--format", "junit"))
    (root / "lessons").mkdir()
    for name, text in LESSONS.items():
        (root / "lessons" / name).write_bytes(text)
    said = subprocess.run([program, "check", root / "lessons", "--format", "junit"], capture_output=True)
    assert said.returncode in (1, 2) and len(check_junit(said.stdout)) == 3, said

    workflow = (docs / "github-classroom" / ".github" / "workflows" / "grade.yml").read_text()
    import yaml
    steps = yaml.safe_load(workflow)["jobs"]["grade"]["steps"]
    assert any("grade submission" in step.get("run", "") for step in steps)
print("all three graders grade")
