# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Files in several processes: the same results, messages and tables as one after the other, and nothing that stays behind.
Needs an X server.

Arguments: program, folder of the data, work folder.
"""

import contextlib
import filecmp
import json
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import time
import unittest
from unittest import mock

from seismichorizons_command import core, jobs, memory

PROGRAM, DATA, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
SAMPLE = DATA / "blobs.vsm"
SECONDS = r"\d+\.\d+"


def files(folder):
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*")) if folder.exists() else []


def without_seconds(value):
    """JSON figures without what is of this run alone."""
    if isinstance(value, dict):
        return {key: without_seconds(item) for key, item in value.items()
                if key not in ("seconds", "started", "command", "seconds_reading")}
    return [without_seconds(item) for item in value] if isinstance(value, list) else value


def grid(z):
    return "X Y Z\n" + "".join("%d %d %.2f\n" % (25 * i, 25 * j, z + 0.1 * i + (i * j) % 3) for j in range(12) for i in range(15))


def children_of(process):
    """The numbers of the processes that a process has started."""
    with contextlib.suppress(OSError):
        return [int(word) for word in pathlib.Path("/proc/%d/task/%d/children" % (process, process)).read_text().split()]
    return []


class JobsTest(unittest.TestCase):
    def setUp(self):
        self.folder = FOLDER / self.id().split(".")[-1]
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)

    def write(self, name, content):
        path = self.folder / name
        path.parent.mkdir(exist_ok=True, parents=True)
        path.write_text(content, encoding="utf-8")
        return path

    def command(self, number, *arguments):
        return [sys.executable, str(PROGRAM), "-j", str(number), "-o", str(self.folder / ("out-%d" % number)), *map(str, arguments)]

    def run_program(self, number, *arguments):
        """The exit code, the lines printed without times, and the messages."""
        done = subprocess.run(self.command(number, *arguments), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                              timeout=200, check=False)
        self.assertNotIn("Traceback", done.stderr)
        printed = re.sub(SECONDS + "( s)?$|(?<=read in )" + SECONDS, "-", done.stdout.replace("out-%d" % number, "out"), flags=re.M)
        return done.returncode, printed, done.stderr.replace("out-%d" % number, "out")

    def same(self, *arguments, numbers=(2, 3, 9)):
        """Runs the program with several numbers of processes and returns what all of them print."""
        first = self.run_program(1, *arguments)
        names = files(self.folder / "out-1")
        for number in numbers:
            self.assertEqual(self.run_program(number, *arguments), first, number)
            self.assertEqual(files(self.folder / ("out-%d" % number)), names)
            for name in filter(lambda name: (self.folder / "out-1" / name).is_file(), names):
                self.assertTrue(filecmp.cmp(self.folder / "out-1" / name, self.folder / ("out-%d" % number) / name, shallow=False), name)
        return first, names

    def inputs(self):
        """Files of all fates: good ones, wrong ones, ones that would replace each other, and folders."""
        (self.folder / "empty").mkdir()
        shutil.copy(SAMPLE, self.folder / "good.vsm")
        return [self.write("wrong.vsm", "1 1\n"), self.folder / "good.vsm", self.folder / "missing.vsm", self.folder / "empty",
                self.write("a.txt", grid(1000.0).replace("X Y Z", "X Y Z Horizon").replace("\n", " B\n").replace("Horizon B", "Horizon")),
                self.write("a_B.txt", grid(1100.0)), self.write("sub/c.xyz", grid(1200.0)), self.write("null.xyz", grid(-900.0))]

    def test_same(self):
        """Whatever becomes of the files; the wrong ones are told in their order."""
        inputs = self.inputs()
        (code, printed, messages), names = self.same("--no-pictures", "--measure-error", *inputs)
        self.assertEqual(code, 1)
        self.assertIn("a.txt and a_B.txt would write the same results, a_B.vtp", messages)
        self.assertEqual([word for word in re.findall(r"error: .*?(empty|wrong|missing|a\.txt)", messages)],
                         ["empty", "wrong", "missing", "a.txt"])
        self.assertRegex(printed.splitlines()[-1], r"^8 files: 4 done, 4 failed, \d+ warnings; 6 meshes in .*/out/$")
        self.assertIn("good_horizon_1.vtp", names)
        random.Random(4).shuffle(inputs)
        shutil.rmtree(self.folder / "out-1")
        self.same("--no-pictures", *inputs, numbers=(4,))

    def test_report(self):
        """JSON and the pictures of a report are the same, but for some points: some drivers draw none twice in the same way."""
        inputs, told, pages = self.inputs()[:5], [], []
        for number in (1, 3):
            report = self.folder / "report.html"
            done = subprocess.run(self.command(number, "--json", "--report", report, *inputs), stdout=subprocess.PIPE,
                                  stderr=subprocess.PIPE, text=True, timeout=200, check=False)
            told.append(without_seconds(json.loads(done.stdout)))
            pages.append(re.findall(r"<img[^>]*alt=\"([^\"]+)\"", report.read_text(encoding="utf-8")))
        self.assertEqual(*told)
        self.assertEqual(*pages)
        self.assertGreater(len(pages[0]), 5)
        self.assertEqual(files(self.folder / "out-1"), files(self.folder / "out-3"))

    def test_layers_between_files(self):
        grids = [self.write(name + ".xyz", grid(z)) for name, z in (("top", 1000.0), ("mid", 1050.0), ("base", 1100.0))]
        (code, printed, _), names = self.same("--no-pictures", "--layers", "--formats", "vtp,msh", *grids, numbers=(2, 3))
        self.assertEqual(code, 0)
        self.assertRegex(printed, "stack of 3 files\n  top to mid: volume")
        self.assertEqual(printed.splitlines()[-1].partition(";")[0], "3 files: 3 done")
        self.assertIn("stack_layers.msh", names)

    def test_folder_in_the_way(self):
        for number in (1, 2):
            (self.folder / ("out-%d" % number) / "good_horizon_2.vtp").mkdir(parents=True)
        shutil.copy(SAMPLE, self.folder / "good.vsm")
        (code, _, messages), names = self.same("--no-pictures", self.folder / "good.vsm", self.write("b.xyz", grid(900.0)), numbers=(2,))
        self.assertEqual((code, names), (1, ["b.vtp", "good_horizon_2.vtp"]))
        self.assertIn("good_horizon_2.vtp cannot be written: it is a folder", messages)

    def large(self, number):
        """Files that take some time."""
        content = "700 700 9\n" + "3 1 1 0.5 4.0\n" * 490000
        return [self.write("large-%d.vsm" % n, content) for n in range(number)]

    def start(self, inputs, number=2):
        """Starts the program and returns it, and its processes once they work."""
        process = subprocess.Popen(self.command(number, "--no-pictures", "--stages", "--skip-rough", *inputs), stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True, start_new_session=True)
        children = []
        while len(children) < number and process.poll() is None:
            time.sleep(0.01)
            children = children_of(process.pid)
        time.sleep(0.3)
        return process, children

    def require_ended(self, children):
        end = time.monotonic() + 10.0
        while any(os.path.exists("/proc/%d" % child) for child in children) and time.monotonic() < end:
            time.sleep(0.02)
        self.assertEqual([child for child in children if os.path.exists("/proc/%d" % child)], [])

    def test_signals(self):
        """One to the program alone, and one to all processes as from a terminal, end all of them without a word."""
        inputs = self.large(3)
        for number, end in ((signal.SIGTERM, os.kill), (signal.SIGINT, os.kill), (signal.SIGINT, os.killpg)):
            with self.subTest(number=number, end=end.__name__):
                process, children = self.start(inputs)
                end(process.pid, number)
                printed, errors = process.communicate(timeout=60)
                self.assertEqual((process.returncode, printed, errors), (128 + number, "", ""))
                self.require_ended(children)
                self.assertEqual(files(self.folder / "out-2"), [])
                self.assertFalse((self.folder / "out-2").exists())

    def test_killed(self):
        """A process that is killed is an error of its file; if the program is killed, its processes end."""
        inputs = self.large(3)
        process, children = self.start(inputs)
        os.kill(children[0], signal.SIGKILL)
        printed, errors = process.communicate(timeout=100)
        self.assertEqual(process.returncode, 1)
        self.assertEqual([line for line in errors.splitlines() if "error: " in line],
                         ["horizon_mesh: error: large-0.vsm: its process ended with signal 9; fewer --jobs leave more memory to each"])
        self.assertTrue(printed.splitlines()[-1].startswith("3 files: 2 done, 1 failed"), printed)
        self.assertEqual(files(self.folder / "out-2"), ["large-1_horizon_1.vtp", "large-2_horizon_1.vtp"])
        process, children = self.start(inputs)
        process.kill()
        process.communicate()
        self.require_ended(children)

    def test_order(self):
        """Of random durations; not more processes than asked for, and none after an exception."""
        def work(task):
            time.sleep(task[1])
            return task[0], os.getpid()

        tasks = [(number, random.Random(number).uniform(0.0, 0.05)) for number in range(20)]
        for number in (1, 2, 7, 30):
            found = list(jobs.run_in_order(work, tasks, number))
            self.assertEqual([place for place, _ in found], list(range(20)))
            self.assertEqual(len({process for _, process in found} | {os.getpid()}), 21)
        with contextlib.closing(jobs.run_in_order(work, [(0, 0.0), (1, 60.0), (2, 60.0)], 2)) as outcomes:
            next(outcomes)
            self.assertEqual(len(children_of(os.getpid())), 1)
        self.assertEqual(children_of(os.getpid()), [])

    def test_shares(self):
        """Of the memory and of the threads."""
        whole, half = (memory.Budget(1 << 30, number) for number in (1, 2))
        self.assertAlmostEqual((whole.left - half.left) / (1 << 29), 1.0, places=2)
        self.assertEqual((whole.limit_text(), half.limit_text()), ("--memory 1G", "--memory 1G for each of 2 jobs"))
        path = self.write("a.xyz", grid(1000.0))
        code, _, messages = self.run_program(2, "--no-pictures", "--memory", "300M", path)
        self.assertEqual((code, messages), (0, ""))  # one file has all of it

        with mock.patch.object(core._core, "set_threads") as set_threads:
            for number in (6, 3, 1, 0):
                core.share_threads(number, 2)
            self.assertEqual([call.args[0] for call in set_threads.call_args_list],
                             [3, 1, 1, max(1, len(os.sched_getaffinity(0)) // 2)])


if __name__ == "__main__":
    unittest.main(argv=["jobs_test"], verbosity=2)
