# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Cubes whose samples stay in the file: horizons from picks are those of the same cube in memory. Arguments: generate_cube,
and a folder.
"""

import os
import pathlib
import shutil
import subprocess
import sys
import unittest
import unittest.mock

import numpy as np
import seismichorizons as package
from seismichorizons_command import core, cubes, memory, reading

GENERATOR, FOLDER = (pathlib.Path(argument) for argument in sys.argv[1:3])


class NearPicksTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        FOLDER.mkdir(parents=True, exist_ok=True)
        cls.path, truth = FOLDER / "cube.sgy", FOLDER / "truth.txt"
        subprocess.run([GENERATOR, "--hard", "--seed", "4", "--noise", "0.3", "--dead", "0.02", "--missing", "0.02", "--truth", truth, cls.path],
                       check=True, stdout=subprocess.DEVNULL)
        rows = np.loadtxt(truth, skiprows=1)
        numbers, counts = np.unique(rows[:, 0], return_counts=True)
        cls.truth = {"Reflector %d" % number: rows[rows[:, 0] == number, 3:6] for number in numbers[counts > 2000]}

    def test_samples_stay_in_the_file(self):
        picks = {name: places[::len(places) // 4] for name, places in self.truth.items()}
        for ranges in ({}, {"inlines": (1010, 1050), "sample_range": (5, -1)}):
            loaded, staying = (package.read_cube(self.path, load=load, **ranges) for load in (True, False))
            self.assertEqual((repr(staying), staying.lattice, staying.taken), (repr(loaded), loaded.lattice, loaded.taken))
            found, same = (package.extract(cube, picks) for cube in (loaded, staying))
            self.assertGreater(sum(map(len, found.values())), 10000)
            self.assertEqual(list(found), list(same))
            for name, horizon in found.items():
                np.testing.assert_array_equal(horizon.columns, same[name].columns)
                np.testing.assert_array_equal(horizon.z, same[name].z)
                np.testing.assert_array_equal(horizon["Amplitude"], same[name]["Amplitude"])
        self.assertEqual(staying.values.shape, (0, 0, 0))
        with self.assertRaisesRegex(ValueError, "amplitudes of cube, whose samples are in its file, expected them in memory"):
            package.amplitudes(staying, found[name])

    def test_other_files_are_refused(self):
        own = FOLDER / "own.sgy"
        picks = {name: places[::len(places) // 4] for name, places in self.truth.items()}

        def change():
            with open(own, "r+b") as file:
                file.seek(-4, 2)
                file.write(b"\1\2\3\4")
            os.utime(own, (1e9, 1e9))

        for spoil, words in ((change, "own.sgy: changed since its headers were read, expected the same file"),
                             (lambda: os.truncate(own, 100000), "own.sgy: changed since"), (own.unlink, "own.sgy: no such file")):
            shutil.copy(self.path, own)
            cube = package.read_cube(own, load=False)
            spoil()
            with self.assertRaisesRegex((ValueError, OSError), words):
                package.extract(cube, picks)

    def test_the_folder_may_change(self):
        before = os.getcwd()
        try:
            os.chdir(FOLDER)
            cube = package.read_cube(self.path.name, load=False)
        finally:
            os.chdir(before)
        name, places = next(iter(self.truth.items()))
        self.assertGreater(len(package.extract(cube, {name: places[::500]})[name]), 1000)

    def test_command_reads_near_picks(self):
        text = FOLDER / "near.txt"
        text.write_text("".join("%s %.2f %.2f %.3f\n" % (name.replace(" ", "_"), x, y, z) for name, places in self.truth.items()
                                for x, y, z in places[::len(places) // 4]))
        budget = memory.Budget()
        loaded = reading.open_file(self.path, Picks=text)
        whole = loaded.read()
        with unittest.mock.patch.object(cubes, "LARGEST_WHOLE", 0):
            staying = reading.open_file(self.path, Picks=text)
            staying.require(budget)
            near = staying.read()
            budget.left = 80 * 64 * cubes.WORKED_NEAR_PICKS * (len(whole) - 1)
            staying.require(budget)
            with self.assertRaisesRegex(core.HorizonError, "a cube that takes .* with its picks, expected at most"):
                staying.read()
        self.assertGreater(len(whole), 3)
        for (name, one), (other_name, other) in zip(whole, near):
            self.assertEqual(name, other_name)
            np.testing.assert_array_equal(one["places"], other["places"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
