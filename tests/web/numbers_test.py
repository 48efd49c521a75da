#!/usr/bin/env python3
"""The numbers of every lesson are the same on every machine: compares the documents of the program `numbers` from this
processor, from the same without wide registers and without fused multiply-add, and from WebAssembly where that was
built. numbers_test.py NUMBERS LESSONS [--only] WEB, WEB being where numbers.js would be; --only: nothing but WebAssembly,
since ctest compares the rest."""

import os
import pathlib
import shutil
import subprocess
import sys

NARROW = "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX"


def hashes(command, lessons, **variables):
    """Output of `command` for the lessons, as {(document, lesson): (hash, size)}."""
    run = subprocess.run(command + lessons, capture_output=True, text=True, env=os.environ | variables)
    assert run.returncode == 0, (command, run.stderr)
    found = {}
    for line in run.stdout.splitlines():
        value, size, document, lesson = line.split(" ", 3)
        found[document, lesson] = (value, int(size))
    return found


def main(numbers, folder, *web):
    only = web[:-1] == ("--only",)
    web = web[-1]
    lessons = sorted(str(path) for path in pathlib.Path(folder).rglob("*.toml") if path.name != "course.toml")
    here = hashes([numbers], lessons)
    # a program that finds nothing would agree with itself
    assert len(lessons) > 50 and len(here) > 4 * len(lessons), (len(lessons), len(here))

    others = {} if only else {"narrow registers": hashes([numbers], lessons, GLIBC_TUNABLES=NARROW)}
    node = shutil.which("node")
    if only or (node and os.path.exists(web)):
        others["WebAssembly"] = hashes([node, web], lessons)
    failed = 0
    for name, there in others.items():
        assert there.keys() == here.keys(), (name, there.keys() ^ here.keys())
        for key in [key for key in here if here[key] != there[key]]:
            print(f"{name}: {key[0]} of {key[1]} is another one")
            failed += 1
    print(f"{len(here)} documents here, compared with {', '.join(others)}: {failed} differ")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
