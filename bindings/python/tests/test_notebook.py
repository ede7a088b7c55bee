"""Runs the cells of the notebook one after the other, and compares what they print with what it shows. Needs matplotlib."""

import contextlib
import io
import json
import pathlib
import sys
import unittest

FOLDER = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(FOLDER))

try:
    import matplotlib
except ImportError:
    raise unittest.SkipTest("SKIPPED: the notebook, because there is no matplotlib")
matplotlib.use("svg")
import matplotlib.pyplot as plt


class Notebook(unittest.TestCase):
    def test_cells_run(self):
        notebook = json.loads((FOLDER / "wheelset.ipynb").read_text(encoding="utf-8"))
        cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
        scope, figures = {}, 0
        with contextlib.chdir(FOLDER):
            for cell in cells:
                scope["figure"] = None
                with contextlib.redirect_stdout(io.StringIO()) as shown:
                    exec("".join(cell["source"]), scope)
                self.assertEqual(shown.getvalue(), "".join(line for output in cell["outputs"] for line in output["text"]))
                if scope["figure"] is not None:
                    figures += 1
                    scope["figure"].savefig(io.BytesIO(), format="svg")
        plt.close("all")
        self.assertEqual((len(cells), figures), (5, 3))


if __name__ == "__main__":
    unittest.main()
