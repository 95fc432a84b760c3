# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The Python package: installed by pip into a fresh environment, which takes all processors, and then tried there with numpy
alone and beside the packages of others, which takes one.

Arguments: "install" or "try", the folder of the project, one for files, and that of the classes of this build, with whose
meshes those of the package are compared. Skipped where pip cannot reach its index.
"""

import os
import pathlib
import shutil
import subprocess
import sys
import venv

PROJECT, FOLDER, CLASSES = (pathlib.Path(argument).resolve() for argument in sys.argv[2:])
TESTS = PROJECT / "Testing/Wheel"
BESIDE = ("pandas", "geopandas", "xarray", "xtgeo", "pyvista", "trimesh", "resqpy", "mypy", "segyio", "matplotlib", "nbclient", "ipykernel", "gempy",
          "LoopStructural")
OF_CUBES = ("multidimio", "pyzgy")  # After the notebooks, which have no messages of tqdm.
ENVIRONMENT = {**{name: value for name, value in os.environ.items() if name != "PYTHONPATH"},
               "CMAKE_BUILD_PARALLEL_LEVEL": str(os.cpu_count())}


def run(*words, env=ENVIRONMENT):
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True, env=env)
    if done.returncode:
        sys.exit("%s: exit code %d\n%s%s" % (" ".join(map(str, words)), done.returncode, done.stdout, done.stderr))


def skip(reason):
    print("SKIPPED: THE PYTHON PACKAGE IS NOT TESTED. %s" % reason)
    sys.exit(77)


python = FOLDER / "use/bin/python"
if sys.argv[1] == "install":
    shutil.rmtree(FOLDER, ignore_errors=True)
    try:
        venv.create(FOLDER / "use", with_pip=True)
    except (subprocess.CalledProcessError, SystemExit):  # Debian's venv exits
        skip("This Python has no ensurepip (package python3-venv).")
    words = [python, "-m", "pip", "download", "--quiet", "--no-deps", "--dest", FOLDER / "found", "nanobind"]
    if subprocess.run(words, capture_output=True, env=ENVIRONMENT).returncode:
        skip("pip does not find nanobind.")
    # The methods are tested elsewhere; this tests what the source distribution has, and compiles faster.
    run(python, "-m", "pip", "install", "--quiet", "--config-settings=cmake.define.CMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG", PROJECT)
    sys.exit()
if not (FOLDER / "use/bin/horizon-mesh").exists():
    skip("It is not installed.")
run(sys.executable, TESTS / "core_peer.py", FOLDER / "peer", env={**ENVIRONMENT, "PYTHONPATH": str(CLASSES)})
run(python, TESTS / "core_test.py", PROJECT / "Data", FOLDER / "files", FOLDER / "peer")
run(python, TESTS / "core_stack_test.py", FOLDER / "stack")
run(python, TESTS / "core_cube_test.py", FOLDER / "cubes")
run(python, TESTS / "pages_test.py", PROJECT, FOLDER / "pages")
run(python, TESTS / "core_example.py", FOLDER / "files")
command = [PROJECT / "Data/sample.vsm", "--no-pictures", "--formats", "vtp,ts", "--report", FOLDER / "page.html"]
run(FOLDER / "use/bin/horizon-mesh", *command, "-o", FOLDER / "command")
run(sys.executable, PROJECT / "Utilities/horizon_mesh.py", *command, "-o", FOLDER / "built", env={**ENVIRONMENT, "PYTHONPATH": str(CLASSES)})
for path in (FOLDER / "built").iterdir():
    if path.read_bytes() != (FOLDER / "command" / path.name).read_bytes():
        sys.exit("%s: not the bytes of the command of the build" % path.name)
run(python, "-m", "pip", "install", "--quiet", *BESIDE)
run(python, TESTS / "core_tasks.py", FOLDER / "tasks")
run(python, TESTS / "notebooks_test.py", PROJECT / "Documentation/Notebooks", FOLDER / "notebooks")
run(python, "-m", "mypy", "--strict", "--cache-dir", FOLDER / "mypy", TESTS / "core_example.py")
run(python, "-m", "mypy", "--config-file", PROJECT / "pyproject.toml", "--cache-dir", FOLDER / "mypy", PROJECT / "Python/seismichorizons")
run(python, "-m", "pip", "install", "--quiet", *OF_CUBES)
run(python, TESTS / "pages_test.py", PROJECT, FOLDER / "pages")
shutil.rmtree(FOLDER / "use")
