# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""setup.sh asks for what it needs, says how much that is, and leaves nothing behind, beside commands that only look like
those of Debian; demo.sh says where its results are, with ParaView and without.

Arguments: setup.sh, a folder for files.
"""

import os
import pathlib
import shutil
import subprocess
import sys
import time
import unittest

SETUP, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
SIZES = """3 upgraded, 515 newly installed, 0 to remove and 3 not upgraded.
Need to get 489 MB of archives.
After this operation, 2530 MB of additional disk space will be used."""


# What it leaves of a configured folder is what setup.sh looks at.
CMAKE = """echo "cmake $*" >>"%s/log"
if [ "$1" = -S ]; then
  mkdir -p "$4"
  touch "$4/build.ninja"
  for option in "$@"; do
    case $option in -D*=O*) option=${option#-D}; echo "${option%%=*}:BOOL=${option#*=}" ;; esac
  done >"$4/CMakeCache.txt"
fi"""


# Has no nanobind, which pip puts into a folder.
PYTHON = """[ "$2" = pip ] || exit 1
echo "pip $*" >>"%s/log"
mkdir -p "$6/nanobind" """


class Setup(unittest.TestCase):
    def setUp(self):
        self.project = FOLDER / self.id().split(".")[-1]
        shutil.rmtree(self.project, ignore_errors=True)
        (self.project / "Utilities").mkdir(parents=True)
        self.commands = self.project / "commands"
        self.commands.mkdir()
        shutil.copy(SETUP, self.project / "Utilities")
        self.write("id", "echo 0")
        self.write("dpkg-query", "echo installed")
        self.write("cmake", CMAKE % self.project)
        self.write("python", PYTHON % self.project)

    def write(self, name, *lines):
        path = self.commands / name
        path.write_text("#!/bin/sh\n" + "\n".join(lines) + "\n")
        path.chmod(0o755)

    def run_setup(self, *options):
        """The exit code, what is printed, and the commands that were run."""
        log = self.project / "log"
        log.unlink(missing_ok=True)
        done = subprocess.run(["sh", str(self.project / "Utilities" / "setup.sh"), *options], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, timeout=60, check=False,
                              env={"PATH": "%s:/usr/bin:/bin" % self.commands, "PYTHON": str(self.commands / "python")})
        return done.returncode, done.stdout, log.read_text().splitlines() if log.exists() else []

    def test_builds(self):
        """A demo takes neither ParaView nor tests; these are configured when they are asked for, and stay."""
        built = "cmake --build %s/build/release" % self.project
        fetched = "pip -m pip install --no-deps --target %s/build/nanobind nanobind>=2.4" % self.project
        configured = ("cmake -S %s -B %s/build/release -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON "
                      "-DBUILD_TESTING=%s -DSEISMICHORIZONS_METHODS_ONLY=%s")
        small, large = ["--without-paraview"], ["--without-tests"]
        for number, (options, parts) in enumerate(((small, ("OFF", "ON")), (small, ()), (large, ("OFF", "OFF")), (small, ()), (large, ()),
                                                   ([], ("ON", "OFF")), ([], ()), (large, ()), (small, ()))):
            code, printed, commands = self.run_setup(*options)
            self.assertEqual((code, commands), (0, [fetched] * (number == 0) + (
                [configured % (self.project, self.project, *parts)] if parts else []) + [built]))
            self.assertTrue(printed.endswith("setup: ready\n"), printed)
            told = r", (about [1-8] min \(processors: \d+\)|some minutes)\n" if parts else "\n"
            self.assertRegex(printed, "building in build/release" + told)
        self.assertEqual(self.run_setup("--only-packages"), (0, "", []))

    def test_ends_with_its_pipe(self):
        """Nothing that it has started keeps the pipe open."""
        start = time.monotonic()
        self.assertEqual(self.run_setup()[0], 0)
        self.assertLess(time.monotonic() - start, 15)  # it says every 20 s that it goes on

    def test_packages(self):
        """What is missing, and what that takes, is said before it comes."""
        self.write("dpkg-query", 'case $3 in doxygen|ninja-build|xvfb) echo "" ;; *) echo installed ;; esac')
        self.write("apt-cache", "exit 0")
        self.write("apt-get", 'echo "apt-get $*" >>"%s/log"' % self.project, "cat <<END\n%s\nEND" % SIZES)
        self.assertIn("fetching nanobind", self.run_setup("--only-packages")[1])  # is no package of Debian 12
        for options, names in (([], "ninja-build xvfb doxygen"), (["--without-tests"], "ninja-build xvfb"),
                               (["--without-paraview"], "ninja-build")):
            code, printed, commands = self.run_setup("--only-packages", *options)
            self.assertEqual(code, 0)
            self.assertEqual(printed, "setup: installing %s\nsetup: 515 packages with what they need, 489 MB to download, "
                             "2530 MB on disk; some minutes\n" % names)
            self.assertEqual(commands[-1], "apt-get install -y --no-install-recommends " + names)

    def test_failures(self):
        self.assertEqual(self.run_setup("--all"), (
            1, "setup: unknown option --all, expected --without-tests, --without-paraview or --only-packages\n", []))
        self.write("cmake", "echo no compiler", "exit 1")
        code, printed, _ = self.run_setup()
        self.assertEqual((code, printed.splitlines()[-2:]), (1, ["no compiler", "setup: configuring failed"]))
        shutil.rmtree(self.project / "build")
        self.write("python", "exit 1")
        code, printed, _ = self.run_setup()
        self.assertEqual(code, 1)
        self.assertIn("setup: no nanobind from PyPI, expected it for the Python package: is the network there?", printed)
        self.write("dpkg-query", "exit 1")
        self.write("apt-get", "exit 100")
        self.write("apt-cache", "exit 1")
        code, printed, _ = self.run_setup()
        self.assertEqual(code, 1)
        self.assertIn("setup: no package lists with g++, expected those of Debian 12: is the network there?", printed)

    def test_demo(self):
        """Without Xvfb, and with a build that has no plugin, there are no pictures, and nobody is told of X."""
        utilities = self.project / "Utilities"
        for name in ("demo.sh", "with-xvfb.sh", "horizon_mesh.py"):
            shutil.copy(SETUP.parent / name, utilities)
        (utilities / "setup.sh").write_text("#!/bin/sh\n")
        shutil.copytree(SETUP.parent.parent / "Data", self.project / "Data", ignore=shutil.ignore_patterns("Baseline"))
        for name in ("dirname", "env", "ls", "mkdir", "sh"):
            (self.commands / name).symlink_to(shutil.which(name))
        environment = {"PATH": str(self.commands), "PYTHONPATH": os.environ["PYTHONPATH"]}
        plugins = self.project / "build" / "release" / "lib" / "paraview-5.11" / "plugins"
        for last in ("%s/setup.sh --without-tests, then this command again\n" % utilities,
                     "PV_PLUGIN_PATH=%s paraview %s/Data/sample.vsm\n" % (plugins, self.project)):
            done = subprocess.run([str(utilities / "demo.sh"), "-o", "with space"], cwd=self.project, env=environment, timeout=60,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=True)
            self.assertIn("demo: the report is with space/report.html", done.stdout)
            self.assertIn(last, done.stdout.splitlines(keepends=True)[-1])
            self.assertNotIn("no pictures", done.stdout)
            self.assertEqual({path.name for path in (self.project / "with space").iterdir()} - {"sample.png"},  # of VTK 9.6
                             {"report.html", "sample_horizon_1.vtp", "sample_horizon_2.vtp"})
            (plugins / "SeismicHorizons").mkdir(parents=True, exist_ok=True)
            (plugins / "SeismicHorizons" / "SeismicHorizons.so").touch()


if __name__ == "__main__":
    unittest.main(argv=["setup_test"], verbosity=2)
