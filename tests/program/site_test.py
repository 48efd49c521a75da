#!/usr/bin/python3
"""The site of a course, as files: site_test.py JOINTWISE ROOT.

A small course with hostile titles and names, without the program of the page, of which a few files stand for all.
"""

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ET
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import quote, unquote, urljoin, urlsplit

import yaml

program, root = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2]).resolve()
catalogue = root / "lessons" / "catalogue"
MATH = "{http://www.w3.org/1998/Math/MathML}"
HOSTILE = """<script>alert(1)</script> & "quotes" 'too' </title> $\\\\mathbf{s}_i < 1$ ]]>"""


def run(*arguments, status=0):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode == status, (arguments, done.returncode, done.stderr)
    return done


def start(*arguments):
    return subprocess.Popen([program, "site", *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)


def write_page(folder):
    folder.mkdir()
    for name in ["jointwise.js", "jointwise.wasm", "jointwise.data", "lessons.json"]:
        (folder / name).write_text(f"{name}\n")
    (folder / "index.html").write_text("<meta name=\"generator\" content=\"Jointwise 0123456789abcdef\">\n")
    (folder / "service_worker.js").write_text("const VERSION = \"0123456789abcdef\";\n")
    return folder


def write_course(folder):
    lessons = folder / "my lessons"
    for name in ["loops/four-bar", "parallel/which-two-of-three", "hard/cannot-close", "jacobians/n1-row", "dynamics/spinning-top"]:
        (lessons / name).parent.mkdir(parents=True, exist_ok=True)
        (lessons / f"{name}.toml").write_text((catalogue / f"{name}.toml").read_text())
    strange = (catalogue / "joints/revolute.toml").read_text()
    strange = re.sub(r"^title = .*$", lambda _: f"title = '''{HOSTILE}'''".replace("\\\\", "\\"), strange, count=1, flags=re.M)
    (lessons / "loops" / "100% <b>#1?.toml").write_text(strange)
    (lessons / "course.toml").write_text(
        'format = 1\n[[chapter]]\nname = "parallel"\ntitle = "Parallel <i>vectors</i>"\nabout = "First."\nneeds = []\nlessons = []\n'
        '[[chapter]]\nname = "loops"\ntitle = "Loops"\nabout = "Then."\nneeds = ["parallel"]\nlessons = ["four-bar.toml"]\n'
    )
    exercises = folder / "exercises"
    (exercises / "scenes").mkdir(parents=True)
    source = root / "lessons" / "exercises"
    # of a file the exercises about lessons that are here, and one about none
    head, *tables = (source / "clinic.toml").read_text().split("[[exercise]]\n")
    kept = [t for t in tables if re.search(r'^lesson = "(loops/four-bar|parallel/which.*)"$', t, re.M) and "../catalogue" not in t]
    assert len(kept) > 1, len(kept)
    alone = re.sub(r'^(name = ".*)"$', r'\1-alone"', re.sub(r'^lesson = .*\n', "", kept[0], flags=re.M), count=1, flags=re.M)
    (exercises / "clinic.toml").write_text("[[exercise]]\n".join([head, *kept, alone]))
    for scene in (source / "scenes").glob("*.toml"):
        (exercises / "scenes" / scene.name).write_text(scene.read_text())
    return lessons


def keep_few(lessons):
    """The lesson with the strange names, and another."""
    for name in ["jacobians", "parallel", "hard"]:
        shutil.rmtree(lessons / name)
    (lessons / "loops/four-bar.toml").unlink()
    (lessons / "course.toml").write_text(
        'format = 1\n[[chapter]]\nname = "loops"\ntitle = "Loops"\nabout = "Alone."\nneeds = []\nlessons = []\n')
    exercises = lessons.parent / "exercises/clinic.toml"
    exercises.write_text(re.sub(r"^lesson = .*\n", "", exercises.read_text(), flags=re.M))


class Page(HTMLParser):
    """Links and names of a page, as a reader of HTML sees them, who knows nothing of XML."""

    def __init__(self, text):
        super().__init__()
        self.links, self.ids, self.inline, self.scripts = [], [], [], 0
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("href", "src"):
                self.links.append(value)
            if name == "id":
                self.ids.append(value)
            if name == "style" or name.startswith("on"):
                self.inline.append((tag, name))
        if tag == "script" and "src" not in dict(attributes) or tag == "style":
            self.inline.append((tag, ""))
        self.scripts += tag == "script"


def pages_of(site):
    """Pages by their paths, without the program's and those of a run that was killed."""
    pages = {p.relative_to(site): p for p in sorted(site.rglob("*.html"))}
    return {path.as_posix(): p for path, p in pages.items() if path.parts[0] != "live" and not path.parts[0].startswith(".")}


def check_pages(site):
    """Every page is well-formed, has nothing inline, and every link leads to a file and a name that are there."""
    pages = {name: Page(path.read_text()) for name, path in pages_of(site).items()}
    formulas = live = 0
    for name, path in pages_of(site).items():
        tree = tree_of(path)
        formulas += len(list(tree.iter(f"{MATH}math")))
        page = pages[name]
        assert page.inline == [], (name, page.inline)
        assert page.scripts == 1, (name, page.scripts)
        assert len(page.ids) == len(set(page.ids)), (name, [i for i in page.ids if page.ids.count(i) > 1])
        assert tree.find("head/title").text.strip(), name
        assert len(list(tree.iter("h1"))) == 1, name
        assert all("alt" in image.attrib for image in tree.iter("img")), name
        for link in page.links:
            target = urlsplit(urljoin(f"https://site/{path_in_url(name)}", link))
            assert target.netloc == "site", (name, link)
            file = site / unquote(target.path).lstrip("/")
            assert file.is_file(), (name, link, file)
            assert site in file.resolve().parents, (name, link)
            if target.path.startswith("/live/"):
                live += 1
            elif target.fragment and file.suffix == ".html":
                assert unquote(target.fragment) in pages[file.relative_to(site).as_posix()].ids, (name, link)
    return formulas, live


def path_in_url(name):
    return quote(name)


def tree_of(path):
    return ET.fromstring(re.sub(r"^<!DOCTYPE html>\s*", "", path.read_text()))


def files_in(folder):
    return {p.relative_to(folder).as_posix(): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}


def text_of(path):
    return "".join(tree_of(path).itertext())


with tempfile.TemporaryDirectory() as place:
    place = Path(place).resolve()
    page = write_page(place / "page")
    lessons = write_course(place)
    out = place / "out"
    common = [lessons, "--page", page]
    done = run("site", *common, "--out", out, "--title", f"Course {HOSTILE}".replace("\\\\", "\\"))
    assert "belongs to no lesson; it is left out" in done.stderr, done.stderr
    formulas, live = check_pages(out)
    assert formulas > 40 and live > 30, (formulas, live)
    names = sorted(p.relative_to(lessons).with_suffix("").as_posix() for p in lessons.rglob("*.toml") if p.name != "course.toml")
    assert sorted(n.removeprefix("lessons/").removesuffix(".html") for n in pages_of(out) if n.startswith("lessons/")) == names
    # the check of links notices a link that leads nowhere
    broken = out / "slides.html"
    kept = broken.read_text()
    broken.write_text(kept.replace("lessons/loops/four-bar.html", "lessons/loops/four-bor.html", 1))
    try:
        check_pages(out)
        raise SystemExit("a dead link was not noticed")
    except AssertionError:
        broken.write_text(kept)
    print(f"{len(pages_of(out))} pages, {formulas} formulas, {live} links into the figure")

    # the order of the course, by the links from lesson to lesson
    at, seen = "lessons/parallel/which-two-of-three.html", []
    while at:
        seen.append(at)
        tree = tree_of(out / at)
        following = [a.attrib["href"] for a in tree.iter("a") if a.attrib.get("rel") == "next"]
        at = unquote(urlsplit(urljoin(f"https://site/{path_in_url(at)}", following[0])).path).lstrip("/") if following else ""
    assert len(seen) == len(names) and seen[1] == "lessons/loops/four-bar.html", seen

    # the claims are those that `check` proves
    checked = json.loads(run("check", lessons / "loops/four-bar.toml", "--format", "json").stdout)
    claims = [c for c in checked["lessons"][0]["claims"] if not c["moment"].startswith("try")]
    rows = list(tree_of(out / "lessons/loops/four-bar.html").iter("tr"))[1:]
    assert [["".join(cell.itertext()) for cell in row] for row in rows] == [[c["moment"], c["subject"], c["expected"]] for c in claims]
    # the numbers of each station are those of the step that its link shows
    steps = json.loads(run("step", lessons / "loops/four-bar.toml", "--format", "json").stdout)["steps"]
    compared = 0
    for station in tree_of(out / "lessons/loops/four-bar.html").iter("section"):
        told = [item.text for item in station.findall("dl[@class='numbers']/div/dd")]
        if not told:
            continue
        rank = steps[int(station.attrib["id"].removeprefix("step-")) - 1]["rank"]
        grown = f'{rank["rank_before"]} → {rank["rank"]}' if rank["rank_before"] != rank["rank"] else str(rank["rank"])
        assert told == [str(rank["rows"]), str(rank["columns"]), grown, str(rank["dof"]), str(rank["redundant"])], (told, rank)
        compared += 1
    assert compared == 5, compared
    # exercises, and sentences
    text = text_of(out / "lessons/loops/four-bar.html")
    exercises = re.findall(r'\[\[exercise\]\]\nname = "([^"]+)"(?:(?!\[\[exercise)[\s\S])*?lesson = "loops/four-bar"', (place / "exercises/clinic.toml").read_text())
    ids = Page((out / "lessons/loops/four-bar.html").read_text()).ids
    assert len(exercises) > 1 and all(f"exercise-{name}" in ids for name in exercises), (exercises, ids)
    for words in ["Four hinges with parallel axes", "15 → 17", "Three equations stay redundant", "The y equation is left out"]:
        assert words in text, words
    assert "cannot" in text_of(out / "lessons/hard/cannot-close.html").lower()

    # the page has the lessons of this course, where exercises find their scenes, and a version of its own
    bundle = json.loads((out / "live/lessons.json").read_text())
    assert bundle["lessons"] == "/course/my lessons", bundle["lessons"]
    for path, text in bundle["files"].items():
        below = path.removeprefix("/course/")
        assert (place / below).read_text() == text and (out / "course" / below).read_text() == text, path
    assert "/course/my lessons/course.toml" in bundle["files"] and "/course/exercises/scenes/four-bar.toml" in bundle["files"]
    version = re.search(r'VERSION = "([0-9a-f]{16})"', (out / "live/service_worker.js").read_text())[1]
    assert version != "0123456789abcdef" and version in (out / "live/index.html").read_text()

    # in another language
    run("site", *common, "--out", place / "zh", "--language", "zh-Hant")
    check_pages(place / "zh")
    assert '<html lang="zh-Hant">' in (place / "zh/index.html").read_text()
    assert "投影片" in text_of(place / "zh/index.html")

    # the same again, to the byte, and in place of the one before; what is hidden stays
    (out / ".git").mkdir()
    (out / ".git" / "HEAD").write_text("ref\n")
    before = files_in(out)
    run("site", *common, "--out", out, "--title", f"Course {HOSTILE}".replace("\\\\", "\\"))
    assert files_in(out) == before
    # fewer lessons, which are drawn again and again below, and slides as a file
    keep_few(lessons)
    (place / "slides.pdf").write_bytes(b"%PDF-1.4\n")
    run("site", *common, "--out", out, "--slides", place / "slides.pdf")
    check_pages(out)
    assert {p.name for folder in ("lessons", "pictures") for p in (out / folder).iterdir()} == {"loops", "dynamics"}
    assert not (out / "lessons/loops/four-bar.html").exists() and not (out / "pictures/loops/four-bar").exists() and (out / ".git/HEAD").exists()
    changed = re.search(r'VERSION = "([0-9a-f]{16})"', (out / "live/service_worker.js").read_text())[1]
    assert changed != version, "other lessons, the same version"
    assert 'href="slides.pdf#page=8"' in (out / "slides.html").read_text() and (out / "slides.pdf").exists()

    # the page of a single chapter knows the course around it
    run("site", lessons / "loops", "--page", page, "--out", place / "alone")
    bundle = json.loads((place / "alone/live/lessons.json").read_text())
    assert bundle["lessons"] == "/course/loops" and "/course/course.toml" in bundle["files"], sorted(bundle["files"])
    shutil.rmtree(place / "alone")

    # slides as an address; a file that is named like a lesson but is not one is reported and left out
    os.mkfifo(lessons / "pipe.toml")
    (lessons / "broken.toml").symlink_to("nowhere.toml")
    (lessons / "folder.toml").mkdir()
    # programs keep files beside those of people
    (lessons / "._four-bar.toml").write_bytes(b"\xff\0")
    told = run("site", *common, "--out", out, "--slides", "https://example.org/s.pdf").stderr
    for name in ["pipe.toml", "broken.toml", "folder.toml"]:
        assert f"{lessons / name}: this is not a regular file, and is left out" in told, told
    assert "._four-bar.toml: its name begins with a dot, and is left out" in told, told
    assert 'href="https://example.org/s.pdf#page=8"' in (out / "slides.html").read_text() and not (out / "slides.pdf").exists()
    for name in ["._four-bar.toml", "pipe.toml", "broken.toml"]:
        os.unlink(lessons / name)
    (lessons / "folder.toml").rmdir()

    # a refusal is reported, and the earlier site stays as it was
    before = files_in(out)
    stranger = place / "stranger"
    stranger.mkdir()
    (stranger / "thesis.txt").write_text("mine\n")
    refused = [
        ([*common, "--out", stranger], "is not part of a site"),
        ([*common, "--out", lessons / "out"], "contains the other"),
        ([place / "nowhere", "--page", page, "--out", out], "is not a folder"),
        ([stranger, "--page", page, "--out", out], "no lessons are below"),
        ([lessons, "--page", stranger, "--out", out], "./dev web"),
        ([*common, "--out", out, "--slides", place / "none.pdf"], "--slides: there is no file"),
        ([*common, "--out", out, "--slides", stranger / "thesis.txt"], "is not a PDF"),
        ([*common, "--out", ""], "--out: the name is empty"),
        ([*common, "--out", out, "--exercises", place / "none"], "is not a folder"),
    ]
    for arguments, words in refused:
        assert words in run("site", *arguments, status=2).stderr, (arguments, words)
    twice = place / "twice"
    twice.mkdir()
    for name in ["Row.toml", "row.toml"]:
        shutil.copy(next(file for file in lessons.rglob("*.toml") if file.name != "course.toml"), twice / name)
    assert "differ in capitals alone" in run("site", twice, "--page", page, "--out", out, status=2).stderr
    # from within, by a path that begins with a folder that does not exist
    inside = subprocess.run([program, "site", ".", "--page", page, "--out", "public"], cwd=lessons, capture_output=True, text=True)
    assert inside.returncode == 2 and "contains the other" in inside.stderr and not (lessons / "public").exists(), inside
    # a list of the site that was changed, or that is not a list
    manifest = (out / "site.json").read_text()
    for text, words in [
        ('{"format": "jointwise site"}', "is not the list of a site"),
        ('{"format": 5, "version": 1, "top": []}', "is not the list of a site"),
        ("mine", "is not the list of a site"),
        ('{"format": "jointwise site", "version": 2, "top": []}', "newer Jointwise"),
    ]:
        (out / "site.json").write_text(text)
        assert words in run("site", *common, "--out", out, status=2).stderr, text
    (out / "site.json").write_text(manifest.replace('"top": [', '"top": ["", ".git", "../page", "site.json",'))
    began = time.monotonic()
    run("site", *common, "--out", out)
    seconds = time.monotonic() - began
    assert (out / ".git/HEAD").exists() and page.is_dir()
    check_pages(out)
    # two at once: one writes, the other waits, or says why it does not
    both = [start(*common, "--out", place / "both") for _ in range(2)]
    said = [process.communicate()[1] for process in both]
    codes = [process.returncode for process in both]
    assert 0 in codes and all(code == 0 or "does another run write a site" in words for code, words in zip(codes, said)), (codes, said)
    check_pages(place / "both")
    # where one does not go on, the other gives up
    stopped = start(*common, "--out", place / "both")
    while not (place / "both/.unfinished-site").exists():
        assert stopped.poll() is None, stopped.communicate()
        time.sleep(0.01)
    stopped.send_signal(signal.SIGSTOP)
    assert "does another run write a site" in run("site", *common, "--out", place / "both", status=2).stderr
    stopped.kill()
    stopped.communicate()
    check_pages(place / "both")
    # killed at any moment of the time that one takes, the next run makes it whole
    for part in [0.05, 0.4, 0.7, 0.95]:
        process = start(*common, "--out", place / "both")
        time.sleep(part * seconds)
        process.kill()
        process.communicate()
        check_pages(place / "both")
    # killed between two renames: the next run takes back what the killed one had put aside
    run("site", *common, "--out", place / "both")
    os.rename(place / "both/lessons", place / "both/.lessons")
    (place / "both/.replaced-site").mkdir()
    os.rename(place / "both/.lessons", place / "both/.replaced-site/lessons")
    run("site", *common, "--out", place / "both")
    check_pages(place / "both")
    assert not (place / "both/.replaced-site").exists()
    before = files_in(out)

    (lessons / "loops/bad.toml").write_text('format = 1\ntitle = "t"\ncolor = 3\n')
    assert "bad.toml:3:1: error" in run("site", *common, "--out", out, status=2).stderr
    wrong = (catalogue / "loops/four-bar.toml").read_text().replace("rank = 17", "rank = 16", 1)
    assert "rank = 16" in wrong
    (lessons / "loops/bad.toml").write_text(wrong)
    said = run("site", *common, "--out", out, status=1).stderr
    assert re.search(r"bad\.toml:\d+:\d+: after D, rank: expected 16, found 17", said), said
    assert files_in(out) == before and sorted(p.name for p in stranger.iterdir()) == ["thesis.txt"]
    print("refused what is wrong, and kept what was there")

    # the repository that publishes itself, by the commands of its own workflow
    repository = place / "repository"
    shutil.copytree(root / "docs" / "snapshots" / "template", repository)
    door = repository / "jointwise" / "dev"
    door.parent.mkdir()
    door.write_text(f'#!/bin/sh\n[ "$1" = site ] && shift && exec "{program}" site --page "{page}" "$@"\n')
    door.chmod(0o755)
    workflow = yaml.safe_load((repository / ".github" / "workflows" / "site.yml").read_text())
    steps = workflow["jobs"]["site"]["steps"]
    commands = [step["run"] for step in steps if "run" in step]
    assert len(commands) == 1, commands
    subprocess.run(["sh", "-e", "-c", commands[0]], cwd=repository, check=True, capture_output=True)
    published = [step["with"]["path"] for step in steps if "upload-pages-artifact" in step.get("uses", "")]
    check_pages(repository / published[0])
    assert (repository / published[0] / "lessons/slider-crank.html").is_file()
    print("the repository of docs publishes its site")
