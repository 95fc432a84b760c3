# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The notebooks run from their first to their last cell, without a warning, draw, and print what is stored in them.

Notebooks whose packages are not there are skipped by name. Arguments: their folder, a folder for files.
"""

import ast
import importlib.util
import pathlib
import re
import sys
import unittest

import nbclient
import nbformat

NOTEBOOKS, FOLDER = map(pathlib.Path, sys.argv[1:])
SECONDS = 300
LARGEST_SIZE = 400_000


def code_cells(notebook):
    return [cell for cell in notebook.cells if cell.cell_type == "code"]


def missing_packages(notebook):
    """Packages that the code imports and that are not there."""
    lines = "\n".join(cell.source for cell in code_cells(notebook)).splitlines()
    imports = [node for node in ast.walk(ast.parse("\n".join(line for line in lines if not line.startswith("%"))))
               if isinstance(node, (ast.Import, ast.ImportFrom))]
    names = {name for node in imports for name in ([one.name for one in node.names] if isinstance(node, ast.Import) else [node.module])}
    return sorted(name for name in {name.partition(".")[0] for name in names} if importlib.util.find_spec(name) is None)


def printed(cell):
    """What a cell prints and returns as text, without addresses of objects."""
    text = "".join(output.text if output.output_type == "stream" else output.get("data", {}).get("text/plain", "") + "\n"
                   for output in cell.get("outputs", []) if "image/png" not in output.get("data", {}))
    return re.sub(r"0x[0-9a-f]+", "0x", text)


def pictures(cell):
    return sum("image/png" in output.get("data", {}) for output in cell.get("outputs", []))


class NotebooksTest(unittest.TestCase):
    def check_stored(self, path, notebook):
        self.assertLess(path.stat().st_size, LARGEST_SIZE)
        self.assertTrue(any(map(pictures, code_cells(notebook))), "no stored picture")
        self.assertTrue(any(map(printed, code_cells(notebook))), "no stored text")
        self.assertEqual([cell.execution_count for cell in code_cells(notebook)], list(range(1, len(code_cells(notebook)) + 1)))

    def check_run(self, notebook):
        new = nbformat.from_dict(notebook)
        for cell in code_cells(new):
            cell.outputs, cell.execution_count = [], None
        nbclient.NotebookClient(new, timeout=SECONDS, resources={"metadata": {"path": str(FOLDER)}}).execute()
        for before, after in zip(code_cells(notebook), code_cells(new), strict=True):
            first = before.source.splitlines()[0]
            self.assertFalse([output.text for output in after.outputs if output.get("name") == "stderr"], first)
            self.assertEqual(printed(after), printed(before), first)
            self.assertEqual(pictures(after), pictures(before), first)

    def test_all(self):
        paths = sorted(NOTEBOOKS.glob("*.ipynb"))
        self.assertTrue(paths)
        for path in paths:
            with self.subTest(path=path.name):
                notebook = nbformat.read(path, 4)
                nbformat.validate(notebook)
                self.check_stored(path, notebook)
                missing = missing_packages(notebook)
                if missing:
                    print("%s is skipped: no %s" % (path.name, ", ".join(missing)))
                else:
                    self.check_run(notebook)


if __name__ == "__main__":
    FOLDER.mkdir(parents=True, exist_ok=True)
    unittest.main(argv=sys.argv[:1], verbosity=2)
