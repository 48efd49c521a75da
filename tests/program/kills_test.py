#!/usr/bin/python3
"""Kills a render at random moments, again and again, until --resume has completed it; the result must be that of a run
that was not killed: kills_test.py JOINTWISE CATALOGUE KILLS [SEED]"""

import hashlib
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

program, catalogue = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
kills = int(sys.argv[3])
seed = int(sys.argv[4]) if len(sys.argv) > 4 else 18
LESSON = catalogue / "loops/four-bar.toml"
RUNS = [["--out", "folder", "--motion-only", "--fps", "6", "--no-panel", "--size", "320x200", "--jobs", "1"],
        ["--out", "folder", "--motion-only", "--fps", "6", "--no-panel", "--size", "320x200", "--jobs", "2"],
        ["--out", "film.apng", "--from", "B", "--to", "10", "--fps", "10", "--no-panel", "--size", "320x200"]]


def command(run, *more):
    return [str(program), "render", str(LESSON), *run, *more]


def contents():
    """Hash of each file here, of any kind."""
    return {str(path): hashlib.sha256(path.read_bytes()).hexdigest() for path in sorted(pathlib.Path().rglob("*")) if path.is_file()}


def clear():
    for entry in os.listdir():
        shutil.rmtree(entry) if os.path.isdir(entry) else os.remove(entry)


chance = random.Random(seed)
done, finished = 0, 0
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    while done < kills:
        run = RUNS[finished % len(RUNS)]
        clear()
        begin = time.monotonic()
        subprocess.run(command(run), check=True, stderr=subprocess.DEVNULL)
        longest = time.monotonic() - begin
        whole = contents()
        clear()
        # a limit for each run leaves kills for the others
        most = min(kills, done + max(1, kills // len(RUNS)))
        # moments cannot be repeated, since the other work of the machine differs
        while True:
            process = subprocess.Popen(command(run, "--resume"), stderr=subprocess.DEVNULL, start_new_session=True)
            time.sleep(chance.uniform(0.0, 1.1 * longest))
            if process.poll() is None and done < most:
                # all processes of the run, as when a machine is switched off
                os.killpg(process.pid, signal.SIGKILL)
                process.wait()
                done += 1
                continue
            assert process.wait() == 0, f"seed {seed}: --resume after {done} kills: status {process.returncode}"
            break
        assert contents() == whole, f"seed {seed}: after {done} kills files differ: {set(contents().items()) ^ set(whole.items())}"
        finished += 1
print(f"{done} kills (seed {seed}): {finished} runs are as if nobody had killed them")
