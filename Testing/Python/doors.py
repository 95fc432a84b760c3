# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The command within a test, and files for it."""

import contextlib
import importlib.util
import io
import shutil
import unittest
from unittest import mock

from seismichorizons_command import horizon_mesh


def load_program(path):
    specification = importlib.util.spec_from_file_location("horizon_mesh", path)
    program = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(program)
    return program


def picks(name="Top", rows=12, columns=15, z=1500.0):
    return "".join("%s\t%d\t%d\t%.1f\t%.1f\t%.2f\n" % (name, j, i, 459600 + 25 * i, 5934800 + 25 * j, z + i % 3)
                   for j in range(rows) for i in range(columns))


class CommandTest(unittest.TestCase):
    """Each test has a folder, and one for results."""

    program = top_folder = None

    def setUp(self):
        self.folder = self.top_folder / self.id().split(".")[-1]
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        self.output = self.folder / "results"

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def run_command(self, *arguments):
        """The exit code, the lines on the error output, and what was printed."""
        errors, printed = io.StringIO(), io.StringIO()
        code = 1
        # Messages begin with the name by which a process is started.
        with contextlib.redirect_stderr(errors), contextlib.redirect_stdout(printed), contextlib.suppress(SystemExit), \
                mock.patch.object(horizon_mesh, "PROGRAM", "horizon-mesh"):
            code = load_program(self.program).main(["--no-pictures", "--output-folder", str(self.output),
                                                    *map(str, arguments)])
        return code, errors.getvalue().splitlines(), printed.getvalue()
