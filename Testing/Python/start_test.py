# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The batch program starts with an interpreter, does its work, and ends as it should; batch_test.py has all the rest.

Arguments: program, folder of the data, work folder, then the interpreter.
"""

import pathlib
import shutil
import subprocess
import sys

import image_compare
import ledger_check
import mesh_checks

PROGRAM, DATA, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
INTERPRETER = sys.argv[4:]
SAMPLE = DATA / "sample.vsm"


def run(*arguments):
    command = [*INTERPRETER, str(PROGRAM), "--output-folder", str(FOLDER), *map(str, arguments)]
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=100, check=False)


def messages(done):
    """Some versions of OpenMPI remark on the machine they run on."""
    return [line for line in done.stderr.splitlines() if line.startswith(PROGRAM.stem + ": ")
            and not ledger_check.is_warning(line)]


def main():
    shutil.rmtree(FOLDER, ignore_errors=True)
    done = run("--horizons", "1", "--", SAMPLE)
    assert (done.returncode, messages(done)) == (0, []), done.stderr
    assert sorted(path.name for path in FOLDER.iterdir()) == ["sample.png", "sample_horizon_1.vtp"]
    assert mesh_checks.check_mesh(mesh_checks.read(FOLDER / "sample_horizon_1.vtp")) > 0
    assert image_compare.load(FOLDER / "sample.png").shape[1] == 3 * 480
    assert run("--help").stdout.startswith("usage: %s [options]" % PROGRAM.name)
    # The end of the program is that of the interpreter.
    done = run("--no-pictures", SAMPLE, "--horizons", "4711")
    assert done.returncode == 1 and len(messages(done)) == 1 and "4711" in messages(done)[0], done.stderr
    assert "Traceback" not in done.stderr and "ERR|" not in done.stderr, done.stderr


main()
