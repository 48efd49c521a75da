#!/usr/bin/python3
"""Reads films that `jointwise render` writes with other programs, and compares them with its PNG pictures:
films_test.py JOINTWISE CATALOGUE"""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

program, catalogue = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
LESSON = catalogue / "loops/four-bar.toml"
# a joint that is added and closed: few pictures, in which bodies move
PART = ["--from", "B", "--to", "11", "--fps", "10"]
SIZE = (320, 200)
LOOK = ["--no-panel", "--size", f"{SIZE[0]}x{SIZE[1]}"]
failures = []


def expect(condition, what):
    if not condition:
        failures.append(what)


def run(*arguments, status=0, env=None):
    done = subprocess.run([str(a) for a in arguments], capture_output=True, env=env, timeout=300)
    if done.returncode != status:
        failures.append(f"{arguments}: status {done.returncode}\n{done.stderr.decode(errors='replace')}")
    return done


def render(*options, status=0, env=None):
    return run(program, "render", LESSON, *options, status=status, env=env)


def raw(file, pixels="rgb24", *options):
    """All pictures of a film, as ffmpeg decodes them, without repeating any."""
    data = run("ffmpeg", "-v", "error", "-i", file, "-fps_mode", "passthrough", *options, "-f", "rawvideo", "-pix_fmt", pixels, "-").stdout
    size = SIZE[0] * SIZE[1] * {"rgb24": 3, "rgba": 4}[pixels]
    expect(len(data) % size == 0 and len(data) > 0, f"{file}: {len(data)} bytes")
    return [data[k:k + size] for k in range(0, len(data), size)]


def times(file):
    text = run("ffprobe", "-v", "error", "-select_streams", "v", "-show_entries", "packet=pts_time", "-of", "csv=p=0", file).stdout.decode()
    return [float(line.strip(",")) for line in text.split()]


def mean_difference(a, b):
    """Largest mean difference of a channel in a square of 8 x 8 pixels: the difference that is seen from a distance."""
    worst = 0.0
    for top in range(0, SIZE[1], 8):
        for left in range(0, SIZE[0], 8):
            for c in range(3):
                sums = [0, 0]
                for y in range(top, top + 8):
                    begin = 3 * (y * SIZE[0] + left) + c
                    for k, picture in enumerate((a, b)):
                        sums[k] += sum(picture[begin:begin + 24:3])
                worst = max(worst, abs(sums[0] - sums[1]) / 64)
    return worst


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    # the pictures themselves: steps, without ways
    render(*PART, *LOOK, "--jobs", "1", "--out", "frames")
    manifest = json.load(open("frames/manifest.json"))
    stills = [raw(f"frames/{frame['file']}")[0] for frame in manifest["frames"]]
    seconds = [frame["seconds"] for frame in manifest["frames"]]
    distinct = [s for k, s in enumerate(stills) if k == 0 or s != stills[k - 1]]

    # APNG: to the bit
    render(*PART, *LOOK, "--no-tween", "--out", "plain.apng")
    shown = raw("plain.apng")
    expect(shown == distinct, f"APNG: {len(shown)} pictures that are not the {len(distinct)} of the folder")
    # the check notices a fault
    damaged = [bytes([shown[0][0] ^ 1]) + shown[0][1:]] + shown[1:]
    expect(damaged != distinct, "a changed bit is not noticed")

    # GIF: colours from a distance; four levels of 255 are less than a step of the palette between two shades
    render(*PART, *LOOK, "--no-tween", "--loop", "--out", "plain.gif")
    shown = raw("plain.gif")
    expect(len(shown) == len(distinct), f"GIF: {len(shown)} pictures, not {len(distinct)}")
    for gif, still in zip(shown[::3], distinct[::3]):
        worst = mean_difference(gif, still)
        expect(worst < 4.0, f"GIF: a square is off by {worst} levels")
    expect(b"NETSCAPE2.0" in open("plain.gif", "rb").read(), "GIF: does not loop")

    # with ways there are more pictures, and the steps are among them
    render(*PART, *LOOK, "--out", "ways.apng")
    shown = raw("ways.apng")
    expect(len(shown) > len(distinct) + 5, "APNG: no ways")
    expect(all(still in shown for still in distinct), "APNG: a step is not among the pictures")

    # MP4 and WebM: as long as the steps, words and chapters in them
    for ending in ["mp4", "webm"]:
        film = f"film.{ending}"
        render(*PART, *LOOK, "--out", film)
        about = json.loads(run("ffprobe", "-v", "error", "-show_streams", "-show_chapters", "-show_format", "-of", "json", film).stdout)
        kinds = [stream["codec_type"] for stream in about["streams"]]
        expect("video" in kinds and "subtitle" in kinds, f"{film}: {kinds}")
        duration = len(times(film)) / 10.0
        expect(abs(duration - sum(seconds)) < 0.11, f"{film}: {duration} s, not {sum(seconds)}")
        expect([chapter["tags"]["title"] for chapter in about["chapters"]] == ["B"], f"{film}: {about['chapters']}")
        expect(about["format"]["tags"].get("title", about["format"]["tags"].get("TITLE")) == "A four-bar of four revolutes", f"{film}: title")
        expect("Joint B" in open("film.vtt").read(), f"{film}: captions")
        first = raw(film, "rgb24", "-vf", "scale=in_color_matrix=bt709", "-frames:v", "1")[0]
        worst = mean_difference(first, stills[0])
        # half as many colours as pixels: at the edge of a body the colours of a square lose some
        expect(worst < 12.0, f"{film}: a square of the first picture is off by {worst} levels")
        expect(not pathlib.Path(film + ".unfinished").exists(), f"{film}: something is left")
    render("--from", "B", "--to", "10", "--fps", "5", *LOOK, "--transparent", "--out", "clear.webm")
    run("ffmpeg", "-v", "error", "-c:v", "libvpx-vp9", "-i", "clear.webm", "-frames:v", "1", "-f", "rawvideo", "-pix_fmt", "rgba", "clear.raw")
    clear = open("clear.raw", "rb").read()
    expect(clear[3] == 0 and max(clear[3::4]) == 255, "WebM: nothing shines through")

    # one page: its data are pictures
    render(*PART[:4], "--fps", "5", *LOOK, "--out", "film.html")
    page = open("film.html", encoding="utf-8").read()
    expect(not re.search(r"(src|href)=[\"']?(https?:|//)|url\(|import ", page), "the page needs something else")
    data = json.loads(re.search(r'id="film">(.*?)</script>', page, re.S).group(1))
    expect(abs(sum(picture["seconds"] for picture in data["pictures"]) - sum(seconds)) < 1e-6, "the page: its length")
    expect(data["pictures"][0]["whole"] and data["captions"], "the page: its pictures")

    # several processes draw the same film
    render(*PART, *LOOK, "--jobs", "3", "--out", "three")
    for file in sorted(os.listdir("frames")):
        expect(open(f"frames/{file}", "rb").read() == open(f"three/{file}", "rb").read(), f"--jobs 3: {file} differs")
    expect(sorted(os.listdir("frames")) == sorted(os.listdir("three")), "--jobs 3: other files")

    # without ffmpeg, and with one that fails: nothing is left
    empty = {"PATH": folder, "HOME": folder}
    said = render(*PART, "--out", "none.mp4", status=2, env=empty).stderr.decode()
    expect("install it (Debian: apt install ffmpeg)" in said, said)
    pathlib.Path("ffmpeg").write_text("#!/bin/sh\necho half > none.mp4.unfinished/film.mp4\necho 'no such codec' >&2\nexit 1\n")
    pathlib.Path("ffmpeg").chmod(0o755)
    said = render(*PART, *LOOK, "--out", "none.mp4", status=2, env={"PATH": folder + ":/usr/bin:/bin", "HOME": folder}).stderr.decode()
    expect("ffmpeg could not make the film: no such codec" in said, said)
    expect(not [name for name in os.listdir() if name.startswith("none.")], "something is left of a film that failed")

if failures:
    print("\n".join(failures))
    sys.exit(1)
print("films show what their pictures show")
