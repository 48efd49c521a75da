#!/usr/bin/env bash
# PrairieLearn runs this in its container: what is handed in is in /grade/student, this folder in /grade/tests, with
# key.toml and the files of exercises that it names. The image has the source of Jointwise, built, in /jointwise.
set -euo pipefail
grade=${GRADE:-/grade}
source_of_jointwise=${JOINTWISE_SOURCE:-/jointwise}
mkdir -p "$grade/results"
# status 3: graded, but programs could not be run here, which the results say
{ "$source_of_jointwise/dev" run grade "$grade/student" --key "$grade/tests/key.toml" --format gradescope || [ $? -eq 3 ]; } |
    python3 -c '
import json, sys
graded = json.load(sys.stdin)
points = sum(test["max_score"] for test in graded["tests"])
def test_of(t):
    verdict, _, feedback = t["output"].partition("\n")
    return {"name": t["name"], "points": t["score"], "max_points": t["max_score"], "message": verdict, "output": feedback}
tests = [test_of(t) for t in graded["tests"]]
if "output" in graded:
    # nothing could be read: the attempt does not count
    json.dump({"gradable": False, "format_errors": [graded["output"]]}, sys.stdout)
else:
    json.dump({"gradable": True, "score": graded["score"] / points if points else 0, "tests": tests}, sys.stdout)
' >"$grade/results/results.json.part"
mv "$grade/results/results.json.part" "$grade/results/results.json"
