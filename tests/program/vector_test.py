#!/usr/bin/python3
"""Draws stills that `jointwise export` writes as PDF by another program (poppler) and compares them with the pictures
of `jointwise render`: vector_test.py JOINTWISE CATALOGUE"""

import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import xml.etree.ElementTree
import zlib

program, catalogue = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
# panels of every kind: rows and their choice, matrix and rank, Newton, sphere of directions, dynamics
STEPS = [("loops/four-bar", 1), ("loops/four-bar", 27), ("parallel/which-two-of-three", 40), ("dynamics/governor", 60)]
WIDTH, HEIGHT = 960, 540


def png_of(path):
    """Pixels of a PNG of 8-bit RGB without filters, as the program writes them."""
    data, at, packed = path.read_bytes(), 8, b""
    while at < len(data):
        length, kind = struct.unpack_from(">I4s", data, at)
        if kind == b"IDAT":
            packed += data[at + 8:at + 8 + length]
        at += 12 + length
    raw, stride = zlib.decompress(packed), 3 * WIDTH + 1
    assert len(raw) == stride * HEIGHT and all(raw[k * stride] == 0 for k in range(HEIGHT))
    return b"".join(raw[k * stride + 1:(k + 1) * stride] for k in range(HEIGHT))


def pdf_of(path):
    """Pixels of a PDF, one for each of its points."""
    data = subprocess.run(["pdftoppm", "-r", "72", path], capture_output=True, check=True).stdout
    head = re.match(rb"P6\s(\d+)\s(\d+)\s255\s", data)
    assert (int(head[1]), int(head[2])) == (WIDTH, HEIGHT), head[0]
    return data[head.end():]


def blocks(pixels, side=12):
    """Means of squares of pixels: letters are drawn differently, but their places and darkness are the same."""
    sums = [0] * ((WIDTH // side) * (HEIGHT // side))
    for y in range(HEIGHT // side * side):
        row = pixels[3 * WIDTH * y:3 * WIDTH * (y + 1)]
        base = y // side * (WIDTH // side)
        for column in range(WIDTH // side):
            sums[base + column] += sum(row[3 * side * column:3 * side * (column + 1)])
    return [value / (3 * side * side) for value in sums]


def distance(a, b):
    differences = [abs(x - y) for x, y in zip(a, b)]
    return sum(differences) / len(differences), max(differences)


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    drawn = {}
    for lesson, step in STEPS:
        file = catalogue / f"{lesson}.toml"
        out = [folder / f"still.{ending}" for ending in ("pdf", "svg")]
        size = ["--size", f"{WIDTH}x{HEIGHT}"]
        export = [program, "export", file, "--step", str(step), "--pdf", out[0], "--svg", out[1], *size]
        subprocess.run(export, check=True, capture_output=True)
        first = [path.read_bytes() for path in out]
        if step == 1:
            subprocess.run(export, check=True, capture_output=True)
        assert first == [path.read_bytes() for path in out], "the same still has other bytes"
        xml.etree.ElementTree.fromstring(first[1])
        drawn[lesson, step] = blocks(pdf_of(out[0]))
        text = subprocess.run(["pdftotext", out[0], "-"], capture_output=True, text=True, check=True).stdout
        assert len(text.split()) > 30 and "\N{MATHEMATICAL BOLD CAPITAL PHI}" in text, text

        if lesson == "loops/four-bar":
            frames = folder / f"frames-{step}"
            subprocess.run([program, "render", file, "--out", frames, "--frames", str(step), *size], check=True, capture_output=True)
            picture = blocks(png_of(frames / f"frame_{step:05d}.png"))
            mean, largest = distance(picture, drawn[lesson, step])
            # letters are not hinted here, and lines are smooth: where they are thickest a block changes by 40 of 255
            assert mean < 2.0 and largest < 60.0, (lesson, step, mean, largest)
            print(f"{lesson} {step}: blocks differ by {mean:.2f} in the mean, {largest:.0f} at most, of 255")
    # the measure tells steps apart: a panel that is not drawn would be noticed
    mean, largest = distance(drawn["loops/four-bar", 1], drawn["loops/four-bar", 27])
    assert mean > 4.0 and largest > 100.0, (mean, largest)

    for bad in (["--svg", "-"], ["--pdf", folder / "no" / "a.pdf"], ["--svg", folder / "a.svg", "--size", "9x9"]):
        done = subprocess.run([program, "export", catalogue / "loops/four-bar.toml", *bad], capture_output=True, text=True)
        assert done.returncode == 2 and "error: " in done.stderr, done
        assert not (folder / "a.svg").exists()
print("stills look as their pictures")
