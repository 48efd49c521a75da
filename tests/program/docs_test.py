#!/usr/bin/python3
"""Does what docs/exercises.md tells a lecturer, in an empty folder: docs_test.py JOINTWISE DOCS-FOLDER

Blocks that name a file are written, the commands of `sh` blocks are run one after the other; between them five students hand in.
"""

import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

program, docs = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()


def hand_in(folder):
    """Five submissions: right, with the first known mistake of the key, with an empty answer, with words, and none."""
    right = re.search(r'^global-vector = "(.*)"', (folder / "solutions/ann/solution/answers.toml").read_text(), re.MULTILINE).group(1)
    mistaken = re.search(r"<li><code>(\[[^<]*\])</code>", (folder / "solutions/bob/solution/sheet.html").read_text()).group(1)
    answers = {"ann": right, "bob": mistaken, "cyd": "", "dan": "no idea"}
    for student, answer in answers.items():
        handed = folder / "submissions" / student
        handed.mkdir(parents=True)
        template = (folder / "sheets" / student / "answers.toml").read_text()
        assert not (folder / "sheets" / student / "solution").exists(), "a sheet brings its solution"
        (handed / "answers.toml").write_text(template.replace('""', f'"{answer}"'))


with tempfile.TemporaryDirectory() as place:
    folder = pathlib.Path(place)
    page = (docs / "exercises.md").read_text()
    section = page.split("## From nothing to a graded class")[1].split("\n## ")[0]
    said = ""
    for kind, name, text in re.findall(r"^```(\w+) ?(\S*)\n(.*?)^```$", section, re.MULTILINE | re.DOTALL):
        if name:
            (folder / name).write_text(text)
            continue
        for line in text.splitlines():
            words = shlex.split(line)
            assert words[0] == "jointwise", line
            if words[1] == "grade":
                hand_in(folder)
            done = subprocess.run([program, *words[1:]], cwd=folder, capture_output=True, text=True)
            assert done.returncode == 0, f"{line}: {done.stdout}{done.stderr}"
            said = done.stdout
    assert (folder / "grades" / "class.html").exists() and (folder / "grades" / "grades.csv").exists()
    assert "ann: 1 of 1 points" in said and "bob: 0 of 1 points" in said, said
    assert "global-vector: wrong: " in said, said
    assert "global-vector: not understood" in said and "global-vector: not handed in" in said, said
print("from nothing to a graded class, as the page tells it")
