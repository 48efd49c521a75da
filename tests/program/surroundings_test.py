#!/usr/bin/python3
"""Faults of the surroundings: surroundings_test.py JOINTWISE LESSONS [AT-ONCE]

Every command that writes files on a full disk and in a folder that cannot be written, without a home, in a locale with
commas, into a pipe that is closed, with little memory, without fonts, without OSMesa, with widths of registers of Mesa,
and several at once. Each ends with the status and the message of docs/command-line.md, and leaves nothing half-written.
"""

import os
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile

program, lessons = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
at_once = int(sys.argv[3]) if len(sys.argv) > 3 else 10
scene = lessons / "exercises/scenes/gate.toml"
pendulum = lessons / "catalogue/dynamics/simple-pendulum.toml"
BWRAP = ["/usr/bin/bwrap", "--dev-bind", "/", "/"]
failures = []


def check(condition, message):
    if not condition:
        failures.append(message)


def run(*arguments, before=(), **more):
    command = [*before, program, *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=120, stdin=subprocess.DEVNULL, **more)


def commands(out):
    """Every command that writes files, into the folder `out`; the files that it reads are in the folder beside it."""
    beside = out.parent / "in"
    small = ("--size", "960x540")
    return {
        "render": ("render", scene, "--out", out / "frames", "--frames", "0:1", *small),
        "snapshot record": ("snapshot", "record", scene, "--golden", out / "golden", "--only", "hinge"),
        "snapshot report": ("snapshot", "report", scene, "--golden", beside / "golden", "--out", out / "report"),
        "export glTF": ("export", scene, "--gltf", out / "scene.glb"),
        "export SVG": ("export", scene, "--svg", out / "scene.svg", *small),
        "export PDF": ("export", scene, "--pdf", out / "scene.pdf", *small),
        "export LaTeX": ("export", scene, "--latex", out / "scene.tex"),
        "plot": ("plot", pendulum, "--out", out / "plot.png"),
        "plot CSV": ("plot", pendulum, "--out", out / "plot.csv"),
        "open": ("open", scene, "--picture", out / "window.png"),
        "new": ("new", out / "mine"),
        "sheet": ("sheet", lessons / "exercises/hard.toml", "--student", "ann", "--key", beside / "key.toml",
                  "--out", out / "sheets"),
        "grade": ("grade", beside / "handed", "--key", beside / "key.toml", "--out", out / "grades"),
    }


def make_inputs(place):
    beside = place / "in"
    beside.mkdir()
    (beside / "key.toml").write_text(
        f'format = 1\nsecret = "a secret for tests"\nexercises = ["{lessons}/exercises/orientation.toml"]\n')
    (beside / "handed/ann").mkdir(parents=True)
    (beside / "handed/ann/answers.toml").write_text('student = "ann"\n[answers]\nangle-of-p = 1\n')
    made = run("snapshot", "record", scene, "--golden", beside / "golden")
    check(made.returncode == 0, f"the golden folder of the test: {made.stderr}")


def is_told(ran, name, words):
    """Checks for one error in the words of the program, not of a library, and no crash."""
    check(ran.returncode == 2, f"{name}: status {ran.returncode}, not 2: {ran.stderr[-300:]}")
    check(any(word in ran.stderr for word in words), f"{name}: standard error lacks {words}: {ran.stderr[-300:]}")
    for word in ("std::", "filesystem error", "terminate called", "basic_", "bad_alloc"):
        check(word not in ran.stderr, f"{name}: a word of a library: {ran.stderr[-300:]}")


def check_whole(out, name):
    """Checks that there is no draft and no empty file."""
    for path in sorted(out.rglob("*")):
        if path.is_file():
            check(".part" not in path.name and path.stat().st_size > 0, f"{name}: half-written {path.name}")


def full_disk(place):
    """A disk of 12 kB; what is on it is copied away before it vanishes with its sandbox."""
    out = place / "full"
    for name, arguments in commands(out).items():
        out.mkdir(exist_ok=True)
        copy = place / "left" / name.replace(" ", "-")
        copy.mkdir(parents=True)
        script = f'"$@"; status=$?; cp -r "{out}/." "{copy}"; exit $status'
        disk = [*BWRAP, "--size", "12288", "--tmpfs", str(out), "sh", "-c", script, "sh"]
        ran = run(*arguments, before=disk)
        if name in ("new", "export LaTeX", "plot CSV", "snapshot report") and ran.returncode == 0:
            continue  # small enough to fit
        is_told(ran, f"{name} on a full disk", ["No space left on device"])
        check_whole(copy, f"{name} on a full disk")
        check(not list(copy.rglob("manifest.json")), f"{name} on a full disk: a manifest without its pictures")


def read_only(place):
    out = place / "read-only"
    out.mkdir()
    for name, arguments in commands(out).items():
        ran = run(*arguments, before=[*BWRAP, "--ro-bind", out, out])
        is_told(ran, f"{name} into a folder that cannot be written", ["Read-only file system"])
    check(not list(out.iterdir()), "something is in the folder that cannot be written")


def no_home(place):
    out = place / "no-home"
    out.mkdir()
    for name in ("render", "open", "grade"):
        ran = run(*commands(out)[name], env={"PATH": "/usr/bin:/bin"})
        check(ran.returncode == 0, f"{name} without HOME: {ran.returncode} {ran.stderr}")
    (out / "frames").rename(out / "frames-1")
    ran = run(*commands(out)["render"], env={"PATH": "/usr/bin:/bin", "HOME": "/nowhere/at/all"})
    check(ran.returncode == 0, f"render with a HOME that is not there: {ran.stderr}")


def comma_locale(place):
    """Numbers have points whatever the locale says."""
    folder = place / "locale"
    folder.mkdir()
    made = subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", folder / "de_DE.UTF-8"], capture_output=True)
    if not (folder / "de_DE.UTF-8").is_dir():
        print(f"surroundings test: no locale with commas, left out: {made.stderr.decode()[-200:]}")
        return
    german = {**os.environ, "LOCPATH": str(folder), "LC_ALL": "de_DE.UTF-8"}
    shown = subprocess.run(["printf", "%.1f", "0,5"], env=german, capture_output=True, text=True).stdout
    check(shown == "0,5", f"the locale has no commas: {shown}")
    for name in ("solve", "simulate", "step", "inspect"):
        asked = {"simulate": (pendulum,), "step": (scene, "--format", "json"), "inspect": (scene,)}
        arguments = (name, *asked.get(name, (scene,)))
        check(run(*arguments, env=german).stdout == run(*arguments).stdout, f"{name} is another one with commas")
    for locale in ("german", "own"):
        out = place / locale
        out.mkdir()
        wanted = commands(out)
        # all of a still in one run
        still = ("export", scene, "--gltf", out / "scene.glb", "--svg", out / "scene.svg", "--pdf", out / "scene.pdf", "--size", "960x540")
        for name, arguments in (("render", wanted["render"]), ("export", still), ("plot", wanted["plot CSV"])):
            ran = run(*arguments, env=german if locale == "german" else None)
            check(ran.returncode == 0, f"{name} in the locale {locale}: {ran.stderr}")
    for path in sorted((place / "own").rglob("*.*")):
        twin = place / "german" / path.relative_to(place / "own")
        check(path.read_bytes() == twin.read_bytes(), f"{path.name} is another one with commas")


def closed_pipe():
    for arguments in (("solve", pendulum), ("step", scene, "--format", "json"), ("list",), ("try", scene)):
        ran = subprocess.run(
            ["bash", "-c", '"$@" | head -c 1 >/dev/null; exit ${PIPESTATUS[0]}', "-", program, *map(str, arguments)],
            capture_output=True, text=True, timeout=120)
        check(ran.returncode in (0, 2, 141), f"{arguments[0]} into a closed pipe: {ran.returncode} {ran.stderr}")
        check("terminate" not in ran.stderr, f"{arguments[0]} into a closed pipe: {ran.stderr}")


def little_memory(place):
    """Memory from too little to load the program to enough: it works, or it says so; a picture is whole or not there."""
    for megabytes in (60, 120, 250, 400, 700):
        limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (megabytes << 20, megabytes << 20))
        for name, arguments in (("step", ("step", scene)), ("plot", commands(place)["plot"])):
            ran = run(*arguments, preexec_fn=limit)
            # 127: the loader finds no memory for the libraries of the program
            check(ran.returncode in (0, 2, 127), f"{name} in {megabytes} MB: {ran.returncode} {ran.stderr[-300:]}")
            check(ran.returncode == 0 or ran.stderr, f"{name} in {megabytes} MB fails without a word")
            check("terminate called" not in ran.stderr, f"{name} in {megabytes} MB: {ran.stderr[-300:]}")
    check_whole(place, "little memory")


def missing_parts(place):
    def without(libraries):
        paths = subprocess.run(["sh", "-c", f"ls {libraries}"], capture_output=True, text=True).stdout.split()
        return [part for path in paths for part in ("--ro-bind", "/dev/null", path)]

    out = place / "missing"
    out.mkdir()
    # EGL draws where there is no OSMesa; without both nothing does
    no_osmesa = without("/usr/lib/*/libOSMesa.so.8")
    picture = out / "by-egl"
    ran = run("render", scene, "--out", picture, "--frames", "0", before=[*BWRAP, *no_osmesa])
    check(ran.returncode == 0 and (picture / "frame_00000.png").exists(), f"EGL does not draw in the place of OSMesa: {ran.stderr}")
    shutil.rmtree(picture, ignore_errors=True)
    hidden = [*no_osmesa, *without("/usr/lib/*/libEGL.so.1*")]
    for name in ("render", "plot", "open", "snapshot record", "export SVG"):
        is_told(run(*commands(out)[name], before=[*BWRAP, *hidden]), f"{name} without OSMesa", ["OSMesa"])
        no_fonts = [*BWRAP, "--tmpfs", "/usr/share/fonts"]
        is_told(run(*commands(out)[name], before=no_fonts), f"{name} without fonts", ["apt-get install", "Debian package"])
    check(not [path for path in out.rglob("*") if path.is_file()], "something was written without OSMesa or fonts")
    ran = run("step", scene, before=[*BWRAP, *hidden, "--tmpfs", "/usr/share/fonts"])
    check(ran.returncode == 0, f"a text needs neither fonts nor OSMesa: {ran.stderr}")


def widths_of_mesa(place):
    """Shaders of one width are in the cache of Mesa when another is wanted."""
    def wide(width):
        return {**os.environ, "MESA_SHADER_CACHE_DIR": str(place / "shaders"), **width}
    ran = run("doctor", env=wide({}))
    check(ran.returncode == 0, f"doctor: {ran.stdout}")
    ran = run("doctor", env=wide({"LP_NATIVE_VECTOR_WIDTH": "128"}))
    check(ran.returncode == 0, f"doctor with registers of 128 bits: {ran.returncode} {ran.stdout}")
    for setting in ({"LP_NATIVE_VECTOR_WIDTH": "512"}, {"DRAW_USE_LLVM": "0"}):
        ran = run("doctor", env=wide(setting))
        check(ran.returncode == 3 and "a surface draws incorrectly" in ran.stdout, f"doctor with {setting}: {ran.returncode}")
    is_told(run(*commands(place)["plot"], env=wide({"LP_NATIVE_VECTOR_WIDTH": "512"})), "a plot", ["set it to 128 or 256"])


def many_at_once(place):
    """The same files by several runs at once: each succeeds, or reports that another run draws, and the files in the end
    are those that one run alone leaves."""
    together, alone = place / "together", place / "alone"
    for out in (together, alone):
        out.mkdir()
    for name in ("snapshot record", "export glTF", "render"):
        arguments = [str(word) for word in (program, *commands(together)[name])]
        running = [subprocess.Popen(arguments, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) for _ in range(at_once)]
        for process in running:
            error = process.communicate()[1]
            is_told = name == "render" and process.returncode == 2 and "is in use by another run" in error
            check(process.returncode == 0 or is_told, f"{name}, {at_once} at once: {process.returncode} {error[-300:]}")
        run(*commands(alone)[name])
    names = {path.relative_to(alone) for path in alone.rglob("*")}
    check({path.relative_to(together) for path in together.rglob("*")} == names, "many at once leave other files than one")
    for name in sorted(names):
        one, many = alone / name, together / name
        check(one.is_dir() or (many.is_file() and one.read_bytes() == many.read_bytes()), f"{name} by many at once is another one")


with tempfile.TemporaryDirectory() as folder:
    place = pathlib.Path(folder)
    os.environ["XDG_STATE_HOME"] = str(place / "state")
    make_inputs(place)
    full_disk(place)
    read_only(place)
    no_home(place)
    comma_locale(place)
    closed_pipe()
    little_memory(place)
    missing_parts(place)
    widths_of_mesa(place)
    many_at_once(place)

if failures:
    sys.exit("surroundings test:\n" + "\n".join(failures))
print("surroundings test: passed")
