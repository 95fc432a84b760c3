# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Horizons that follow picks, from the files that a user has: a turned survey, picks in the world, and what comes out
compared with the reflectors that the generator wrote. Arguments: generate_cube, the program horizon_mesh.py, and a folder.
"""

import dataclasses
import pathlib
import re
import random
import subprocess
import sys
import unittest

import numpy as np
import seismichorizons as package
import vtk_inputs
from seismichorizons import vtk as sh
from seismichorizons_command import reading
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkImagingCore import vtkExtractVOI

GENERATOR, PROGRAM, FOLDER = (pathlib.Path(argument) for argument in sys.argv[1:4])
LARGEST_NUMBER = 20  # of horizons
QUARTER = 8.0 * 4.0 / 4.0  # of the period, about, in ms


def points_of(places, names=None):
    data = vtk_inputs.points_of(places)
    if names is not None:
        array = vtkStringArray()
        array.SetName("Horizon")
        for name in names:
            array.InsertNextValue(name)
        data.GetPointData().AddArray(array)
    return data


def dataset_of(given):
    """The dataset of an array, of a dictionary of arrays and datasets, or of a dataset itself."""
    if isinstance(given, dict):
        return vtk_inputs.collect({name: dataset_of(own) for name, own in given.items()})
    return points_of(given) if isinstance(given, np.ndarray) else given


def places_of(horizon):
    return vtk_to_numpy(horizon.GetPoints().GetData())


def array_of(horizon, name):
    return vtk_to_numpy(horizon.GetPointData().GetArray(name))


class GuidesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        FOLDER.mkdir(parents=True, exist_ok=True)
        cls.path, truth = FOLDER / "cube.sgy", FOLDER / "truth.txt"
        subprocess.run([GENERATOR, "--hard", "--seed", "4", "--size", "80", "64", "220", "--noise", "0.3", "--truth", truth, cls.path],
                       check=True, stdout=subprocess.DEVNULL)
        rows = np.loadtxt(truth, skiprows=1)
        cls.truth = {}  # by reflector: places in the world, as in the files; z in ms, downwards
        for number in np.unique(rows[:, 0]):
            own = rows[rows[:, 0] == number]
            if len(own) > 2000:
                cls.truth["Reflector %d" % number] = np.column_stack((own[:, 3], own[:, 4], -own[:, 5]))
        cls.cube = sh.apply(sh.make("vtkSEGYCubeReader", FileName=str(cls.path)))

    def extract(self, picks=None, limits=(), **properties):
        """The horizons of the cube, by name."""
        extraction = sh.make("vtkSeismicReflectionExtraction", **{"LargestNumber": LARGEST_NUMBER, **properties})
        extraction.SetInputDataObject(self.cube)
        if picks is not None:
            extraction.SetInputDataObject(1, dataset_of(picks))
        for own in limits if isinstance(limits, (list, tuple)) else [limits]:
            extraction.AddInputDataObject(2, dataset_of(own))
        sh.update(extraction)
        return sh.horizons_of(extraction.GetOutputDataObject(0))

    def picks(self, count, seed=1):
        draw = random.Random(seed)
        return {name: np.array(draw.sample(places.tolist(), count)) for name, places in self.truth.items()}

    def check(self, found, names, least):
        """Of the places of each reflector so many are found, and of the points there few are elsewhere."""
        self.assertEqual(list(found), names)
        for name in names:
            known = {(round(x, 1), round(y, 1)): z for x, y, z in self.truth[name]}
            places = places_of(found[name])
            there = np.array([(z, known[round(x, 1), round(y, 1)]) for x, y, z in places if (round(x, 1), round(y, 1)) in known])
            off = np.abs(there[:, 0] - there[:, 1])
            self.assertGreater(np.count_nonzero(off <= QUARTER) / len(known), least, name)
            self.assertLess(np.count_nonzero(off > 2.0 * QUARTER) / len(off), 0.06, name)

    def test_found(self):
        picks = self.picks(12)
        self.assertGreater(len(picks), 5)
        self.check(self.extract(picks), list(picks), 0.8)

    def test_arrays(self):
        """Where a pick is the pick is, and distances are those to the nearest pick."""
        picks = self.picks(6)
        name = next(iter(picks))
        top = self.extract({name: picks[name]})[name]
        places, origins, distances = places_of(top), array_of(top, "Origin"), array_of(top, "GuideDistance")
        self.assertEqual(set(origins.tolist()) - {0.0, 1.0, 2.0}, set())
        for x, y, z in picks[name]:
            nearest = np.argmin(np.hypot(places[:, 0] - x, places[:, 1] - y))
            self.assertEqual((origins[nearest], distances[nearest]), (0.0, 0.0))
            self.assertLess(abs(places[nearest, 2] - z), 6.0)
        self.assertEqual(np.count_nonzero(origins == 0.0), np.count_nonzero(distances == 0.0))
        columns = array_of(top, "Column")[:, :2]
        own = columns[origins == 0.0]
        expected = np.abs(columns[:, None, :] - own[None, :, :]).max(axis=2).min(axis=1)
        np.testing.assert_array_equal(distances, expected)
        confidence, seeds, blocks = (array_of(top, array) for array in ("Confidence", "Seed", "Block"))
        self.assertTrue(np.all((confidence > 0.0) & (confidence <= 1.0)) and np.all(confidence[origins == 0] == 1.0))
        self.assertEqual(seeds[origins == 0].tolist(), [np.argmin(np.hypot(*(np.array(picks[name])[:, :2] - place[:2]).T))
                                                        for place in places[origins == 0]])
        sizes = np.bincount(blocks)[1:]
        self.assertTrue(sizes.min() > 0 and np.all(np.diff(sizes) <= 0))
        self.assertEqual(set(blocks[seeds < 0].tolist()) & set(blocks[origins == 0].tolist()), set())

    def test_least_confidence(self):
        picks = dict(list(self.picks(8).items())[:1])
        (name, whole), = self.extract(picks).items()
        sure = self.extract(picks, LeastConfidence=0.9)[name]
        kept = (array_of(whole, "Confidence") >= 0.9) | (array_of(whole, "Origin") == 0)
        np.testing.assert_array_equal(places_of(whole)[kept], places_of(sure))
        self.assertLess(sure.GetNumberOfPoints(), whole.GetNumberOfPoints())

    def test_forms(self):
        """A dict of arrays, datasets, and one dataset with names give the same; without a name it is Guide 1."""
        picks = dict(list(self.picks(5).items())[:2])
        expected = [places_of(top) for top in self.extract(picks).values()]
        names = [name for name, places in picks.items() for _ in places]
        for given in ({name: points_of(places) for name, places in picks.items()},
                      points_of(np.concatenate(list(picks.values())), names)):
            found = self.extract(given)
            self.assertEqual(list(found), list(picks))
            for places, top in zip(expected, found.values()):
                np.testing.assert_array_equal(places, places_of(top))
        self.assertEqual(list(self.extract(next(iter(picks.values())))), ["Guide 1"])

    def test_others(self):
        picks = dict(list(self.picks(5).items())[:1])
        found = self.extract(picks, KeepOthers=True, LargestNumber=5)
        self.assertEqual(list(found), [*picks, *("Horizon %d" % (n + 1) for n in range(5))])
        taken = set(map(tuple, places_of(next(iter(found.values()))).tolist()))
        for top in list(found.values())[1:]:
            self.assertFalse(taken & set(map(tuple, places_of(top).tolist())))
            self.assertIsNone(top.GetPointData().GetArray("Origin"))

    def test_without_growth(self):
        picks = self.picks(8)
        grown, parts = self.extract(picks), self.extract(picks, GrowthReach=0)
        for name, top in parts.items():
            self.assertFalse(np.any(array_of(top, "Origin") == 2.0))
            self.assertLessEqual(top.GetNumberOfPoints(), grown[name].GetNumberOfPoints())

    def by_column(self, places):
        """z by column of the lattice."""
        matrix = vtk_to_numpy(self.cube.GetFieldData().GetArray("LatticeToWorld")).reshape(4, 4)
        columns = np.rint(np.linalg.solve(matrix[:2, :2], (places[:, :2] - matrix[:2, 3]).T)).astype(int)
        return dict(zip(map(tuple, columns.T.tolist()), places[:, 2]))

    def test_limits(self):
        """Every point is on a trace with all limits, and within these."""
        everything = self.extract(LargestNumber=1000, SmallestSize=1)
        names = list(self.truth)
        top, base = self.truth[names[1]], self.truth[names[3]]
        upper, lower = self.by_column(top), self.by_column(base)

        def check(found, is_inside):
            points = [item for horizon in found.values() for item in self.by_column(places_of(horizon)).items()]
            self.assertGreater(len(points), 1000)
            for place, z in points:
                self.assertTrue(is_inside(place, z), (place, z))
        between = self.extract(limits=[top, base], LargestNumber=1000, SmallestSize=1)
        check(between, lambda place, z: min(lower[place], upper[place]) - 1e-6 <= z <= max(lower[place], upper[place]) + 1e-6)
        swapped = self.extract(limits={"a": base, "b": points_of(top)}, LargestNumber=1000, SmallestSize=1)
        for one, other in zip(between.values(), swapped.values()):
            np.testing.assert_array_equal(places_of(one), places_of(other))
        below = self.extract(limits=top, LargestNumber=1000, SmallestSize=1)
        above = self.extract(limits=top, LimitSide="Above", LargestNumber=1000, SmallestSize=1)
        check(below, lambda place, z: z <= upper[place] + 1e-6)
        check(above, lambda place, z: z >= upper[place] - 1e-6)
        self.assertGreater(sum(map(vtkPolyData.GetNumberOfPoints, everything.values())),
                           sum(map(vtkPolyData.GetNumberOfPoints, between.values())))

    def test_guides_within_limits(self):
        names = list(self.truth)
        picks = dict(list(self.picks(12).items())[2:3])
        found = self.extract(picks, limits=[self.truth[names[1]], self.truth[names[3]]])
        self.check(found, list(picks), 0.5)

    def test_zero_crossings(self):
        """A crossing is half way between the peaks beside it, about, and amplitudes have the sign of its direction."""
        peaks = self.extract(Position="Peak", LargestNumber=3)
        crossings = self.extract(Position="ZeroCrossing", LargestNumber=3)
        for top in crossings.values():
            amplitudes = array_of(top, "Amplitude")
            self.assertEqual(len(set(np.sign(amplitudes))), 1)
        self.assertNotEqual([top.GetNumberOfPoints() for top in peaks.values()],
                            [top.GetNumberOfPoints() for top in crossings.values()])
        samples = vtk_to_numpy(self.cube.GetPointData().GetScalars()).reshape(self.cube.GetDimensions()[::-1])
        top = next(iter(crossings.values()))
        columns, indices, amplitudes = (array_of(top, name) for name in ("Column", "VerticalIndex", "Amplitude"))
        for (i, j, *_), k, amplitude in zip(columns, indices, amplitudes):
            # The crossing is that of smoothed traces.
            trace = np.sign(samples[max(0, int(k) - 2):int(k) + 3, int(j), int(i)]) * np.sign(amplitude)
            self.assertTrue(np.any(np.diff(trace) > 0.0), (i, j, k, trace))

    def test_changes(self):
        """A filter that has run before gives what a new one does, whatever has changed since then."""
        draw = random.Random(1)
        small = vtkExtractVOI()
        small.SetVOI(0, 39, 0, 31, 0, 219)
        small.SetInputData(self.cube)
        cubes = [sh.apply(small), sh.apply(small)]
        cubes[1].GetPointData().SetScalars(numpy_to_vtk(-vtk_to_numpy(cubes[0].GetPointData().GetScalars()), deep=True))
        names = list(self.truth)
        guides = [self.picks(count, seed) for count, seed in ((20, 1), (20, 2), (60, 3))]
        limits = [None, dataset_of(self.truth[names[0]]), dataset_of(self.truth[names[1]])]
        choices = {
            "PhaseRotation": (0.0, 90.0), "Polarity": ("Both", "Positive"), "Position": ("Peak", "ZeroCrossing"),
            "ThresholdType": ("Percentile", "Amplitude"), "AmplitudeThreshold": (0.0, 0.3), "Connectivity": ("Four", "Eight"),
            "LargestStep": (0.0, 4.0), "SmallestCorrelation": (0.85, 0.5), "SmallestContact": (0.5, 0.9), "SmallestSize": (0, 60),
            "LargestNumber": (20, 3), "Order": ("Strength", "Size"), "GuideTolerance": (0.0, 3.0), "GrowthCorrelation": (0.6, 0.9),
            "GrowthReach": (1000, 5), "LeastConfidence": (0.0, 0.8), "KeepOthers": (False, True), "LimitSide": ("Below", "Above"),
            0: cubes, 1: guides, 2: limits}
        chosen = {key: values[0] for key, values in choices.items()}
        old = sh.make("vtkSeismicReflectionExtraction")
        for _ in range(3):
            for key in draw.sample(sorted(choices, key=str), len(choices)):
                chosen[key] = draw.choice(choices[key])
                one, other = (self.content(filter_, chosen) for filter_ in (old, sh.make("vtkSeismicReflectionExtraction")))
                self.assertEqual(one, other, key)

    @staticmethod
    def content(extraction, chosen):
        """What a filter gives, or the error."""
        sh.configure(extraction, **{key: value for key, value in chosen.items() if isinstance(key, str)})
        extraction.SetInputDataObject(0, chosen[0])
        extraction.SetInputDataObject(1, dataset_of(chosen[1]))
        extraction.SetInputDataObject(2, chosen[2])
        try:
            sh.update(extraction)
        except ValueError as error:
            return str(error)
        found = {name: [places_of(top)] + [vtk_to_numpy(top.GetPointData().GetArray(n)) for n in range(
            top.GetPointData().GetNumberOfArrays())] for name, top in sh.horizons_of(extraction.GetOutputDataObject(0)).items()}
        return extraction.GetDescription(), {name: [own.tobytes() for own in arrays] for name, arrays in found.items()}

    def test_limits_errors(self):
        place = self.truth[next(iter(self.truth))]
        for limits, message in (([place] * 3, "limits of 3 horizons, expected one or two"),
                                (np.concatenate((place, place[:1])), 'two points on one trace, the second at ('),
                                (points_of(place * [1.0, 1.0, np.nan]), "a point at ("),
                                (place * [1.0, 1.0, -1.0] + [0.0, 0.0, 1e6],
                                 "all of its points are above or below the samples of the cube, expected points from ("),
                                (place + [1e7, 0.0, 0.0], "limits on no trace of the cube, expected horizons with points from (")):
            with self.assertRaises(ValueError, msg=message) as caught:
                self.extract(limits=limits)
            self.assertIn(message, str(caught.exception))

    def test_random_picks(self):
        """Whatever the picks are: each is on its horizon or counted, and their order does not matter."""
        draw = np.random.default_rng(7)
        places = np.concatenate(list(self.truth.values()))
        for run in range(12):
            count = int(draw.integers(1, 60))
            given = places[draw.integers(0, len(places), count)] + draw.normal(0.0, 2.0 ** draw.integers(0, 5), (count, 3))
            given = given[np.unique(np.round(given[:, :2] / 40.0), axis=0, return_index=True)[1]]
            results = []
            for order in (np.arange(len(given)), draw.permutation(len(given))):
                extraction = sh.vtkSeismicReflectionExtraction()
                extraction.SetInputData(self.cube)
                extraction.SetInputDataObject(1, points_of(given[order]))
                try:
                    sh.update(extraction)
                except ValueError as error:
                    results.append(str(error).partition(" at (")[0])
                    continue
                line = next(line for line in extraction.GetDescription().splitlines() if line.startswith("Guide 1: "))
                numbers = re.findall(r"(\d+) (?:points|picks|contradicted|on parts|grown|left out|shared|near no|on the other|on a trace|outside)", line)
                points, on_picks, contradicted, on_parts, grown, left_out, shared, *unused = map(int, numbers)
                self.assertEqual((left_out, shared), (0, 0))
                self.assertEqual(points, on_picks + on_parts + grown)
                self.assertEqual(on_picks + sum(unused), len(given))
                self.assertLessEqual(contradicted, on_picks)
                results.append(places_of(extraction.GetOutput().GetPartition(0, 0)).tolist())
            self.assertEqual(results[0], results[1], run)

    def test_errors(self):
        name, places = next(iter(self.picks(4).items()))
        for given, message in (({name: places + [0.0, 0.0, 5000.0]}, 'guide "%s": none of its 4 points is on the cube' % name),
                               (points_of(np.zeros((0, 3))), "guides without points, expected picks"),
                               (points_of(places * [1.0, np.nan, 1.0]), 'guide "Guide 1": a point at ('),
                               (points_of(places, ["a"] * 3), "array Horizon of 3 tuples"),
                               ({name: np.concatenate((places, places + [0.0, 0.0, -60.0]))}, "two picks in one column")):
            with self.assertRaises(ValueError, msg=message) as caught:
                self.extract(given)
            self.assertIn(message, str(caught.exception))
        vectors = points_of(places)
        vectors.GetPointData().AddArray(numpy_to_vtk(places, deep=True))
        vectors.GetPointData().GetArray(0).SetName("Horizon")
        with self.assertRaises(ValueError) as caught:
            self.extract(vectors)
        self.assertIn("guide array Horizon of 3 components, expected the number or the name", str(caught.exception))
        with self.assertRaises(ValueError) as caught:
            self.extract({name: places}, Joining="Components")
        self.assertIn("expected BestFirst", str(caught.exception))

    def run_program(self, *words):
        done = subprocess.run([sys.executable, PROGRAM, *map(str, words)], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout + done.stderr

    def test_command(self):
        """A text of picks that stand on no lattice of their own, one of them between columns."""
        picks = self.picks(6)
        text = ["Horizon X Y Z"]
        for name, places in picks.items():
            text += ["%s %.2f %.2f %.3f" % (name.replace(" ", "_"), x + 4.0, y - 3.0, -z) for x, y, z in places]
        (FOLDER / "picks.dat").write_text("\n".join(text) + "\n", encoding="utf-8")
        out = FOLDER / "out"
        code, told = self.run_program("--no-pictures", "--output-folder", out, "--formats", "vtp", "--report", FOLDER / "report.html",
                                      "--picks", FOLDER / "picks.dat", self.path)
        self.assertEqual(code, 0, told)
        self.assertEqual({path.name for path in out.glob("*.vtp")}, {"cube_%s.vtp" % name.replace(" ", "_") for name in picks})
        self.assertIn("picks.dat", (FOLDER / "report.html").read_text(encoding="utf-8"))
        for wrong, message in ((FOLDER / "none.dat", "none.dat"), (self.path, "a seismic cube, expected picks of horizons")):
            code, told = self.run_program("--no-pictures", "--output-folder", out, "--picks", wrong, self.path)
            self.assertEqual(code, 1)
            self.assertIn(message, told)
        code, told = self.run_program("--no-pictures", "--output-folder", out, "--picks", self.path, FOLDER / "picks.dat")
        self.assertEqual(code, 1, told)
        self.assertIn("its format does not support --picks", told)

    def test_files(self):
        """By line numbers, places or both, in the window, the command and Python. They begin inside of the cube."""
        cube = package.read_cube(self.path)
        first_inline, inline_step, first_crossline, crossline_step = cube.lattice.lines
        steps = np.column_stack((cube.lattice.column_step, cube.lattice.row_step))
        columns, rows = {}, []
        for name, places in self.truth.items():
            for x, y, z in places:
                i, j = np.rint(np.linalg.solve(steps, np.subtract((x, y), cube.lattice.origin))).astype(int)
                if 20 <= i < 70 and 30 <= j < 60 and i % 9 == 2 and j % 10 == 1:
                    columns.setdefault(name, set()).add((i, j))
                    lines = first_inline + inline_step * j, first_crossline + crossline_step * i
                    rows.append((name.replace(" ", "_"), *lines, x, y, -z))
        self.assertGreater(min(map(len, columns.values())), 5)
        for head, kept in (("Inline Crossline", (1, 2)), ("X Y", (3, 4)), ("Inline Crossline X Y", (1, 2, 3, 4))):
            path = FOLDER / "tops.dat"
            path.write_text("Horizon %s Z\n" % head + "".join(
                "%s %s %.3f\n" % (row[0], " ".join("%.2f" % row[n] for n in kept), row[5]) for row in rows))
            in_python = package.extract(cube, path)
            found = {"python": {name: (one.columns, one.attributes["Origin"]) for name, one in in_python.items()},
                     "command": {name: (data["point_data"]["Column"], data["point_data"]["Origin"])
                                 for name, data in reading.read(self.path, Picks=path)[0]}}
            if kept != (3, 4):
                reader = sh.make("vtkHorizonTextReader", FileName=str(path))
                found["window"] = {name: (array_of(one, "Column"), array_of(one, "Origin")) for name, one in self.extract(sh.apply(reader)).items()}
            for door, horizons in found.items():
                self.assertEqual(len(horizons), len(columns), door)
                for name, own in columns.items():
                    given, origin = horizons[name.replace(" ", "_")]
                    at_picks = set(map(tuple, np.asarray(given)[np.asarray(origin) == 0].tolist()))
                    self.assertLessEqual(at_picks, own, (door, head))
                    self.assertGreaterEqual(len(at_picks), 0.8 * len(own), (door, head))
        cube.lattice = dataclasses.replace(cube.lattice, lines=None)
        self.assertEqual({name: len(one) for name, one in package.extract(cube, path).items()}, {name: len(one) for name, one in in_python.items()})
        path.write_text("Horizon Inline Crossline Z\nA 1001 2001 300\n")
        with self.assertRaisesRegex(ValueError, "tops.dat: only line numbers for a cube that has none, expected x and y"):
            package.extract(cube, path)

    def test_bad_picks_are_named(self):
        picks = list(self.truth.items())
        name, places = picks[2]
        draw = random.Random(3)
        bad = draw.sample(picks[3][1].tolist(), 1)
        given = np.array(draw.sample(places.tolist(), 9) + bad + [[0.0, 0.0, 0.0]])
        extraction = sh.vtkSeismicReflectionExtraction()
        extraction.SetInputData(self.cube)
        extraction.SetInputDataObject(1, points_of(given))
        extraction.Update()
        line = next(line for line in extraction.GetDescription().splitlines() if line.startswith("Guide 1: "))
        self.assertIn("1 outside of the cube", line)
        self.assertNotIn("surfaces of", extraction.GetDescription())
        self.assertTrue(any(word in line for word in ("(1 contradicted)", " 1 near no reflection", " 1 on the other sign")), line)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
