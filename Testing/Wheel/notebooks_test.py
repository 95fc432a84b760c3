# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The notebooks run from their first to their last cell, without a warning, and draw.

Arguments: their folder, a folder for files.
"""

import pathlib
import sys
import unittest

import nbclient
import nbformat

NOTEBOOKS, FOLDER = map(pathlib.Path, sys.argv[1:])
SECONDS = 120


class NotebooksTest(unittest.TestCase):
    def test_all(self):
        paths = sorted(NOTEBOOKS.glob("*.ipynb"))
        self.assertTrue(paths)
        for path in paths:
            with self.subTest(path=path.name):
                notebook = nbformat.read(path, 4)
                self.assertFalse([cell for cell in notebook.cells if cell.get("outputs")], "outputs that are kept")
                nbclient.NotebookClient(notebook, timeout=SECONDS, resources={"metadata": {"path": FOLDER}}).execute()
                outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
                self.assertFalse([o for o in outputs if o.get("name") == "stderr" and "Warning" in o.text])
                self.assertTrue([o for o in outputs if "image/png" in o.get("data", {})])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
