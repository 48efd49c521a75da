"""Films: what a notebook shows, what is saved, and what ends it."""

import base64
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import jointwise as jw

PROGRAM = sys.argv.pop(1)
SMALL = {"width": 320, "height": 180, "panels": False, "fps": 5}


def four_bar():
    return jw.read_lesson(jw.lesson_file("loops/four-bar"))


class Films(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_a_film_is_the_one_that_the_program_renders(self):
        film = four_bar().film(from_="t=0.5", to="t=1", loop=True, dark=True, text=1.2, camera=[1, -2, 0.5], **SMALL)
        film.save(self.folder / "module.apng")
        subprocess.run(
            [PROGRAM, "render", jw.lesson_file("loops/four-bar"), "--out", self.folder / "program.apng", "--from",
             "t=0.5", "--to", "t=1", "--loop", "--dark", "--text", "1.2", "--camera", "1,-2,0.5", "--size", "320x180",
             "--no-panel", "--fps", "5", "--jobs", "1"], check=True, capture_output=True)
        self.assertEqual((self.folder / "module.apng").read_bytes(), (self.folder / "program.apng").read_bytes())

    def test_a_notebook_shows_it_with_its_size_and_no_other_file(self):
        film = four_bar().film(from_="t=0.5", to="t=1", **SMALL)
        html = film._repr_html_()
        data = re.search(r'src="data:image/apng;base64,([^"]*)"', html).group(1)
        film.save(self.folder / "film.apng")
        self.assertEqual(base64.b64decode(data), (self.folder / "film.apng").read_bytes())
        self.assertRegex(html, rf"{film.seconds:.1f} s, {film.pictures} pictures of 320 x 180, [0-9.]+ MB")
        self.assertNotIn("http", html)

    def test_every_format_is_saved(self):
        film = four_bar().film(from_="t=0.5", to="t=0.7", **SMALL)
        begins = {".gif": b"GIF89a", ".apng": b"\x89PNG", ".html": b"<!"}
        if shutil.which("ffmpeg"):
            begins |= {".mp4": b"", ".webm": b"\x1aE\xdf\xa3"}
        for ending, first in begins.items():
            with self.subTest(ending=ending):
                file = self.folder / f"film{ending}"
                film.save(file)
                self.assertTrue(file.read_bytes().startswith(first))
        self.assertEqual(list(self.folder.glob("*.unfinished")), [])

    def test_errors_have_the_words_of_the_program(self):
        lesson = four_bar()
        for options, words in (
            ({"from_": "nowhere"}, r"from_ 'nowhere'; expected a step from 1 to \d+, the name of a joint or driver"),
            ({"from_": "5", "to": "2"}, "to '2' is step 2, before step 5 of from_"),
            ({"width": 100}, "expected WIDTHxHEIGHT in pixels from 960x540 to 15360x8640"),
            ({"text": 2.0}, "text above 1.5 leaves the panels no room"),
            ({"transparent": True}, "panels are opaque"),
            ({"camera": [0, 0, 0]}, "the direction in which the eye is"),
            ({"fps": float("nan")}, "fps is out of range"),
        ):
            with self.subTest(options=options):
                self.assertRaisesRegex(ValueError, words, lesson.film, **options)
        film = lesson.film(from_="t=0.5", to="t=0.5", loop=True, **SMALL)
        self.assertRaisesRegex(ValueError, "is not a film; expected .gif, .apng, .mp4", film.save, "film.avi")
        self.assertRaisesRegex(ValueError, "loop is only for .gif and .apng", film.save, self.folder / "film.html")

    def test_a_signal_ends_it_and_leaves_nothing(self):
        class Interrupted(Exception):
            pass

        def interrupt(number, frame):
            raise Interrupted

        film = four_bar().film(panels=False, fps=240)
        before = signal.signal(signal.SIGALRM, interrupt)
        try:
            signal.setitimer(signal.ITIMER_REAL, 0.3)
            with self.assertRaises(Interrupted):
                film.save(self.folder / "film.apng")
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main()
