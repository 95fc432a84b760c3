# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The commands on the installed pages do what they say, as they are written, with what is installed alone.

Arguments: the folder of the pages, and a folder for files. Commands of the source tree and of installing are left out.
"""

import pathlib
import re
import shutil
import subprocess
import sys

PAGES, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
PAGES_WITH_EXAMPLES = ("README.md", "Documentation/Command.md")
# What begins a line that is for the source tree, or for installing.
OTHERS = ("Utilities/", "cmake ", "sudo ", "pip ", "export ", "paraview", "python3 Utilities/")


def blocks(page, language):
    text = (PAGES / page).read_text(encoding="utf-8")
    return re.findall(r"^```%s\n(.*?)^```$" % language, text, re.MULTILINE | re.DOTALL)


def run(command, folder, **options):
    done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=300,
                          check=False, **options)
    assert done.returncode == 0 and "ERR|" not in done.stdout, "%s: %d\n%s" % (command, done.returncode, done.stdout)
    return done.stdout


def make_folder(name):
    folder = FOLDER / name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / "Data").symlink_to(PAGES / "Data")
    return folder


def run_tutorial(page, results):
    """All of it, in the order of the page."""
    folder = make_folder(page)
    for block in blocks(page, "sh"):
        run(["sh", "-e", "-c", block], folder)
    for block in blocks(page, "python"):
        (folder / "script.py").write_text(block, encoding="utf-8")
        run(["pvpython", "script.py"], folder)
    for name in results:
        assert list(folder.rglob(name)), "%s: no %s" % (page, name)
    return folder


def run_examples(picks, cube):
    """Each line of the command with files of the names that are in it."""
    folder = make_folder("Command")
    sample = PAGES / "Data" / "sample.vsm"
    (folder / "surveys").mkdir()
    for name in ("survey.vsm", "big.vsm", "surveys/a.vsm", "surveys/b.vsm"):
        shutil.copy(sample, folder / name)
    for name, depth in (("top.xyz", 1000), ("middle.xyz", 1050), ("base.xyz", 1100)):  # a stack
        (folder / name).write_text("X Y Z\n" + "".join("%d %d %.1f\n" % (25 * i, 25 * j, depth + 0.3 * i)
                                                       for i in range(30) for j in range(20)), encoding="utf-8")
    shutil.copy(picks, folder / "picks.dat")
    shutil.copy(cube, folder / "survey.sgy")
    run("horizon-mesh --formats irap --output-folder . -- picks.dat && mv picks.irap top_reek.irap", folder, shell=True)
    run("horizon-mesh --surfaces 1 --formats irap --output-folder . -- survey.sgy && mv survey_horizon_1.irap tops.dat", folder,
        shell=True)
    commands = [line for page in PAGES_WITH_EXAMPLES for block in blocks(page, "sh") for line in block.splitlines()
                if line and not line.startswith(OTHERS)]
    assert len(commands) >= 12, commands
    for command in commands:
        print(command)
        run(command, folder, shell=True)
    for number, block in enumerate(blocks("README.md", "python")):
        (folder / "script.py").write_text(block, encoding="utf-8")
        print("python block %d" % number)
        run([("pvpython" if "paraview" in block else "/usr/bin/python3"), "script.py"], folder)


def main():
    picks = run_tutorial("Documentation/TutorialPicks.md", ["dome.ts", "dome.vtp"])
    cube = run_tutorial("Documentation/TutorialCube.md", ["cube.ts", "faulted_Top.irap", "faulted_Top.ts"])
    run_examples(picks / "dome.dat", cube / "cube.sgy")


main()
