#!/usr/bin/python3
"""The schema for editors agrees with the reader: schema_test.py JOINTWISE SOURCE_ROOT

It accepts every shipped lesson and exercise, and refuses every wrong lesson whose mistake a schema can see: a value of a
wrong type or with a wrong number of entries, a word that is not allowed, a number out of range, an unknown key.
"""

import json
import pathlib
import re
import subprocess
import sys
import tomllib

import jsonschema

# Mistakes of these codes lie in the table itself; others depend on what else the lesson says.
SEEN = {"JW203", "JW204"}
# Some mistakes of these codes can be seen: where none of the lesson's names or types decides.
SEEN_HERE = {
    "a format of the future",
    "no format",
    "no title, no body",
    "unknown word and key",
    "unknown coordinates",
    "angle without unit",
    "shapes",
    "a colour that is none",
    "claims: nothing, negative, unknown",
    "questions",
}


def wrong_lessons(path):
    """Name, text and codes of the cases of wrong_lessons.txt that are TOML."""
    cases = re.split(r"^=== ", path.read_text(), flags=re.M)[1:]
    base = None
    for case in cases:
        name, rest = case.split("\n", 1)
        head, says = rest.split("--- says\n")
        setting, lesson = head.split("\n", 1)
        base = lesson if base is None else base
        if setting == "--- with masses":
            masses = re.sub(r'(\[\[body\]\]\nname = .*\n)', r"\1mass = 1\ninertia = [1, 1, 1]\n", base)
            lesson = masses + lesson
        elif setting == "--- after the base":
            lesson = base + lesson
        try:
            yield name, tomllib.loads(lesson), set(re.findall(r"error: .*\[(JW\d+)\]", says))
        except tomllib.TOMLDecodeError:
            pass


def right_lessons(root):
    """Path and content of the lessons that come with the program."""
    paths = [root / "app/commands/new_lesson.toml"]
    for folder in ("lessons/catalogue", "lessons/benchmark", "lessons/exercises/scenes"):
        paths += sorted((root / folder).rglob("*.toml"))
    for path in paths:
        if path.name != "course.toml":
            yield path, tomllib.loads(path.read_text())


def main():
    jointwise, root = sys.argv[1], pathlib.Path(sys.argv[2])
    schema = json.loads(subprocess.run([jointwise, "schema"], check=True, capture_output=True).stdout)
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    faults = []
    accepted = 0
    for path, lesson in right_lessons(root):
        accepted += 1
        faults += [f"{path}: {error.json_path}: {error.message}" for error in validator.iter_errors(lesson)]
    exercise = jsonschema.Draft7Validator({"$ref": "#/definitions/exercise", "definitions": schema["definitions"]})
    exercises = 0
    for path in sorted((root / "lessons/exercises").glob("*.toml")):
        for table in tomllib.loads(path.read_text())["exercise"]:
            exercises += 1
            faults += [f"{path}: {table['name']}: {error.json_path}: {error.message}" for error in exercise.iter_errors(table)]
            if exercise.is_valid(table | {"kind": "poem"}) or exercise.is_valid(table | {"hint": "?"}):
                faults.append(f"{path}: the schema takes {table['name']} with a wrong kind or an unknown key")
    refused = set()
    for name, lesson, codes in wrong_lessons(root / "tests/lessons/wrong_lessons.txt"):
        if not validator.is_valid(lesson):
            refused.add(name)
            if not codes:
                faults.append(f"the reader takes '{name}', the schema does not")
        elif codes & SEEN or name in SEEN_HERE:
            faults.append(f"the schema takes '{name}', which has {', '.join(sorted(codes))}")
    print(f"{accepted} lessons and {exercises} exercises accepted, {len(refused)} wrong lessons refused")
    if accepted < 50 or exercises < 50 or len(refused) < 20 or not SEEN_HERE <= refused:
        faults.append(f"too few lessons; not refused: {sorted(SEEN_HERE - refused)}")
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
