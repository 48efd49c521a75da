"""The programs of docs/python.md run as they stand, one after the other, and the page names everything in the module."""

import contextlib
import io
import os
import re
import tempfile
import unittest
from pathlib import Path

import jointwise as jw

PAGE = Path(__file__).parents[2] / "docs" / "python.md"


class Page(unittest.TestCase):
    def test_programs_of_the_page_run(self):
        blocks = re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
        self.assertGreaterEqual(len(blocks), 2)
        namespace, printed = {}, io.StringIO()
        with tempfile.TemporaryDirectory() as folder:
            before = os.getcwd()
            os.chdir(folder)
            try:
                with contextlib.redirect_stdout(printed):
                    for block in blocks:
                        exec(compile(block, str(PAGE), "exec"), namespace)
                self.assertTrue(Path("four-bar.png").is_file())
            finally:
                os.chdir(before)
        self.assertIn("Rank 18 of 21 x 18", printed.getvalue())

    def test_the_page_names_every_function_and_every_notebook(self):
        text = PAGE.read_text(encoding="utf-8")
        said_by_others = {"Mistake", "Moment", "Reaction", "EquationsTable", "Coordinates", "joint_types", "lessons_folder"}
        for name in set(jw.__all__) - said_by_others:
            self.assertIn(name, text)
        for notebook in (PAGE.parent / "python").glob("*.ipynb"):
            self.assertIn(f"(python/{notebook.name})", text)


if __name__ == "__main__":
    unittest.main()
