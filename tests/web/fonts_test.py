#!/usr/bin/env python3
"""The fonts of the page have all that lessons and program show: fonts_test.py JOINTWISE FONTS LESSONS.

The program itself draws with the fonts of the page: its pictures are the same.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

program, fonts, lessons = sys.argv[1], sys.argv[2], Path(sys.argv[3])
# levels of 255: the texture holds other letters, so their places in it, and roundings there, differ
ROUNDING = 2


def pixels_of(picture):
    command = ["ffmpeg", "-v", "error", "-i", str(picture), "-f", "rawvideo", "-pix_fmt", "rgb24", "-"]
    return subprocess.run(command, capture_output=True, check=True).stdout


def largest_difference(a, b):
    assert len(a) == len(b)
    return max(abs(x - y) for x, y in zip(a, b)) if a != b else 0


def run(with_those_of_the_page, *arguments):
    environment = dict(os.environ)
    environment.pop("JOINTWISE_FONTS", None)
    if with_those_of_the_page:
        environment["JOINTWISE_FONTS"] = fonts
    return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, env=environment, check=True)


with tempfile.TemporaryDirectory() as place:
    place = Path(place)
    # a letter that the page lacks is reported: a check that never reports would prove nothing
    strange = place / "strange.toml"
    strange.write_text((lessons / "catalogue/joints/revolute.toml").read_text().replace("title = \"", "title = \"ա ", 1))
    assert "[JW" not in run(False, "check", strange).stderr and "ա" in run(True, "check", strange).stderr, run(True, "check", strange).stderr
    told = run(True, "check", lessons / "catalogue", lessons / "exercises", "--quiet").stderr
    own = run(False, "check", lessons / "catalogue", lessons / "exercises", "--quiet").stderr
    assert told == own, told
    count = 0
    for name in ["joints/universal", "jacobians/table-modified", "hard/cosine-row", "dynamics/andrews", "orientation/angular-velocity"]:
        for tab in ["step", "try", "plots", "exercises"]:
            pictures = []
            for ours in [False, True]:
                run(ours, "open", lessons / f"catalogue/{name}.toml", "--at", "5", "--tab", tab, "--picture", place / "picture.png")
                pictures.append(pixels_of(place / "picture.png"))
            assert largest_difference(*pictures) <= ROUNDING, (name, tab, largest_difference(*pictures))
            count += 1
    print(f"fonts of the page: {count} pictures are the same")
