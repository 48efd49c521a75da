#!/usr/bin/python3
"""Runs the code cells of a notebook, one after the other in one namespace, as a notebook does: run_notebook.py FILE.

The value of the last expression of a cell is shown, a picture or a film by its bytes and all else as text. IPython is not needed: its
packages would be 23 MB on the machine that tests, and a process with sockets for each notebook.
"""

import ast
import json
import linecache
import sys
import traceback
from pathlib import Path


def run_cell(source, place, namespace):
    """Value of the last expression, None if the cell ends with a statement."""
    tree = ast.parse(source, place)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, place, "exec"), namespace)
    return None if last is None else eval(compile(ast.Expression(last.value), place, "eval"), namespace)


def shown(value):
    if value is None:
        return ""
    page = getattr(value, "_repr_html_", None)
    if page is not None:
        html = page()
        assert "base64," in html and len(html) < 1_000_000, f"{len(html)} bytes: too much for a notebook, or no film"
        return f"film, {len(html)} bytes"
    picture = getattr(value, "_repr_png_", None)
    if picture is None:
        return repr(value)
    data = picture()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "what a notebook would show is no picture"
    return f"picture, {len(data)} bytes"


def main():
    file = Path(sys.argv[1])
    notebook = json.loads(file.read_text(encoding="utf-8"))
    # output that is written into a notebook when it is run does not belong to its version
    outputs = [k for k, c in enumerate(notebook["cells"]) if c.get("outputs") or c.get("execution_count")]
    assert not outputs, f"cells {outputs} have outputs; clear them before you commit"
    sys.path.insert(0, str(file.parent))  # as a notebook does
    namespace = {"__name__": "__main__"}
    cells = [(k, "".join(c["source"])) for k, c in enumerate(notebook["cells"]) if c["cell_type"] == "code"]
    checks = 0
    for k, source in cells:
        # lines of an error are those of the cell
        linecache.cache[f"cell {k}"] = (len(source), None, source.splitlines(True), f"cell {k}")
        try:
            print(shown(run_cell(source, f"cell {k}", namespace)) or f"cell {k}")
        except Exception:
            traceback.print_exc()
            sys.exit(f"{file.name}: cell {k} fails")
        checks += sum(isinstance(node, ast.Assert) for node in ast.walk(ast.parse(source)))
    assert checks >= 5, f"only {checks} checks"
    print(f"{file.name}: {len(cells)} cells, {checks} checks")


if __name__ == "__main__":
    main()
