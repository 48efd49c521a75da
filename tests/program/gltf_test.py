#!/usr/bin/python3
"""Reads scenes that `jointwise export --gltf` writes by the specification alone, and compares where bodies are with
the JSON of `jointwise step`: gltf_test.py JOINTWISE CATALOGUE"""

import json
import pathlib
import struct
import subprocess
import sys
import tempfile

program, catalogue = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
# every joint type, springs, dynamics, another upward axis, a lesson that cannot be assembled, one in which nothing moves
LESSONS = ["loops/four-bar", "loops/rssr", "screws/screw-jack", "joints/universal", "joints/cylindrical", "joints/prismatic",
           "joints/spherical", "links/revolute-spherical", "dynamics/governor", "dynamics/andrews", "hard/cannot-close",
           "vectors/frames"]
# a float has 24 bits; places are below 4 m
ROUNDING = 4 * 2.0**-24

COMPONENTS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}
FORMATS = {5126: "f", 5125: "I"}


class Scene:
    def __init__(self, data):
        magic, version, length = struct.unpack_from("<4sII", data)
        assert (magic, version, length) == (b"glTF", 2, len(data))
        size, kind = struct.unpack_from("<I4s", data, 12)
        assert kind == b"JSON" and size % 4 == 0
        self.json = json.loads(data[20:20 + size])
        rest, kind = struct.unpack_from("<I4s", data, 20 + size)
        assert kind == b"BIN\0" and 28 + size + rest == len(data)
        self.binary = data[28 + size:]
        assert 0 <= rest - self.json["buffers"][0]["byteLength"] < 4

    def values(self, index):
        accessor = self.json["accessors"][index]
        view = self.json["bufferViews"][accessor["bufferView"]]
        count = COMPONENTS[accessor["type"]]
        assert view["byteLength"] == 4 * count * accessor["count"] and view["byteOffset"] % 4 == 0
        flat = struct.unpack_from(f"<{accessor['count'] * count}{FORMATS[accessor['componentType']]}", self.binary, view["byteOffset"])
        rows = [flat[k:k + count] for k in range(0, len(flat), count)]
        if "min" in accessor:
            for k in range(count):
                column = [row[k] for row in rows]
                near = lambda a, b: abs(a - b) <= 1e-6 * max(1.0, abs(b))
                assert near(accessor["min"][k], min(column)) and near(accessor["max"][k], max(column))
        return rows


def volume(points, indices):
    total = 0.0
    for k in range(0, len(indices), 3):
        a, b, c = (points[i] for i in indices[k:k + 3])
        total += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6.0
    return total


def check_meshes(scene):
    for mesh in scene.json["meshes"]:
        (primitive,) = mesh["primitives"]
        assert "min" in scene.json["accessors"][primitive["attributes"]["POSITION"]]
        points = scene.values(primitive["attributes"]["POSITION"])
        normals = scene.values(primitive["attributes"]["NORMAL"])
        indices = [row[0] for row in scene.values(primitive["indices"])]
        assert len(points) == len(normals) and len(indices) % 3 == 0 and max(indices) < len(points)
        assert all(abs(sum(x * x for x in n) - 1.0) < 1e-5 for n in normals)
        assert volume(points, indices) > 0.0, "a mesh is inside out"
        assert 0 <= primitive["material"] < len(scene.json["materials"])


def check_tree(scene):
    """Checks that every node but the root is the child of one node."""
    children = [child for node in scene.json["nodes"] for child in node.get("children", [])]
    assert sorted(children) == list(range(1, len(scene.json["nodes"])))


def distance(path, value, body):
    if path == "translation":
        return max(abs(a - b) for a, b in zip(value, body["r"]))
    x, y, z, w = value
    assert abs(x * x + y * y + z * z + w * w - 1.0) < 1e-6
    return min(max(abs(sign * a - b) for a, b in zip((w, x, y, z), body["p"])) for sign in (1.0, -1.0))


def check_motion(scene, steps):
    """Checks that every body is where the steps of the motion say, at every time."""
    (animation,) = scene.json["animations"]
    times = [row[0] for row in scene.values(animation["samplers"][0]["input"])]
    assert len(times) == len(steps) and times[0] == 0.0 and all(a < b for a, b in zip(times, times[1:]))
    moved = set()
    for channel in animation["channels"]:
        name, path = scene.json["nodes"][channel["target"]["node"]]["name"], channel["target"]["path"]
        moved.add(name)
        values = scene.values(animation["samplers"][channel["sampler"]]["output"])
        for value, step in zip(values, steps, strict=True):
            body = next(body for body in step["bodies"] if body["name"] == name)
            assert distance(path, value, body) < ROUNDING, (name, path, step["time_s"])
        if path == "rotation":
            assert all(sum(p * q for p, q in zip(a, b)) > 0.0 for a, b in zip(values, values[1:])), "the long way round"
    return moved


with tempfile.TemporaryDirectory() as folder:
    for lesson in LESSONS:
        file, out = catalogue / f"{lesson}.toml", pathlib.Path(folder) / "scene.glb"
        done = subprocess.run([program, "export", file, "--gltf", out], capture_output=True, text=True)
        assert done.returncode == (3 if lesson == "hard/cannot-close" else 0), (lesson, done.stderr)
        scene = Scene(out.read_bytes())
        check_meshes(scene)
        check_tree(scene)
        told = json.loads(subprocess.run([program, "step", file, "--format", "json"], capture_output=True, text=True).stdout)
        steps = [step for step in told["steps"] if step["kind"] == "motion"]
        names = [node["name"] for node in scene.json["nodes"]]
        if steps:
            moved = check_motion(scene, steps)
            assert moved == {body["name"] for body in steps[0]["bodies"] if body["name"] in moved} and moved, lesson
        else:
            assert "animations" not in scene.json, lesson
        for body in (steps or told["steps"])[-1]["bodies"]:
            assert body["name"] in names, (lesson, body["name"])

    # bad usage writes nothing
    out = pathlib.Path(folder) / "none"
    for arguments in (["--step", "1", "--gltf", out], ["--gltf", "-"], [], ["--step", "999", "--latex", out]):
        done = subprocess.run([program, "export", catalogue / "loops/four-bar.toml", *arguments], capture_output=True, text=True)
        assert done.returncode == 2 and done.stderr.startswith("jointwise: error: "), (arguments, done)
        assert not out.exists()

    # what the window copies, on standard output
    latex = subprocess.run([program, "export", catalogue / "loops/four-bar.toml", "--latex", "-"], capture_output=True, text=True).stdout
    assert latex.count("\\begin{equation*}") == latex.count("\\end{equation*}") >= 2 and "\\text{crank}" in latex
    table = subprocess.run([program, "export", catalogue / "loops/four-bar.toml", "--csv", "-"], capture_output=True, text=True).stdout
    assert len({line.count(",") for line in table.splitlines()}) == 1 and len(table.splitlines()) > 20
print(f"{len(LESSONS)} scenes are where their lessons are")
