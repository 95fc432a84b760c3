# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line of the batch program, the properties that it becomes, and what the documentation says of it.

Argument: the program horizon_mesh.py.
"""

import contextlib
import pathlib
import re
import sys
import unittest
from unittest import mock

from seismichorizons import _core
from seismichorizons import vtk as sh
from seismichorizons_command import settings as command_settings
from seismichorizons_command import core, data, horizon_mesh, options, pipeline, reading, writing
from seismichorizons_command.parser import make_parser as parser_of
from seismichorizons_command.settings import make_settings

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
BINDINGS = PROGRAM.parents[1] / "Python/Core"


def horizon_in(unit):
    """One without points, whose z have a unit."""
    return data.with_fields(data.empty(), {"VerticalUnit": [unit]})


class OptionsTest(unittest.TestCase):
    def settings(self, *arguments):
        return make_settings(horizon_mesh.make_parser().parse_args(["survey.vsm", *arguments]))

    def stages(self, *arguments):
        """The properties of each stage by its name, in their order."""
        return {name: given for name, _, given in self.settings(*arguments).stages()}

    def test_defaults(self):
        """Without options no property is set, and the largest error is automatic."""
        settings = self.settings("--stages", "--elaborate", "--measure-error")
        for name in ("reader", "error", *pipeline.STAGES):
            self.assertEqual(getattr(settings, name), {}, name)
        self.assertIsNone(settings.horizons)
        self.assertEqual(options.FORMATS, (*writing.MESH_FORMATS, *writing.GRID_FORMATS, *writing.POINT_FORMATS, *writing.LAYER_FORMATS))
        self.assertNotIn("MaximumError", self.settings().surface)

    def test_reader(self):
        reader = self.settings("--corners", *map(str, range(12)), "--vertical-unit", "ms", "--stray-picks", "LeaveOut").reader
        self.assertEqual(reader["LatticeSource"], "CornerPoints")
        self.assertEqual([reader[name] for name in ("FirstCorner", "SecondCorner", "ThirdCorner")],
                         [[0, 1, 2, 3], [4, 5, 6, 7], [8, 9, 10, 11]])
        self.assertEqual((reader["VerticalUnit"], reader["StrayPicks"]), ("ms", "LeaveOut"))
        text = sh.make("vtkHorizonTextReader", **{name: value for name, value in reader.items() if name != "StrayPicks"})
        self.assertEqual(text.GetSecondCorner(), (4, 5, 6, 7))
        self.assertLess(reader.keys(), set(reading.PROPERTIES["text"]))
        self.assertEqual(self.settings("--z-from", "RealZ").reader, {"ZFrom": "RealZ"})
        self.assertEqual(self.settings("--stages", "--keep-holes").boundary, {"KeepHoles": True})

    def test_names_of_options(self):
        """Properties come from options that there are; another name would never be given, without a word."""
        known = {action.dest for action in horizon_mesh.make_parser()._actions}
        asked = set()
        given = command_settings.given

        def note(parsed, *same, **renamed):
            asked.update(map(core.snake, same), renamed.values())
            return given(parsed, *same, **renamed)

        with mock.patch.object(command_settings, "given", note):
            self.settings("--stages", "--elaborate", "--measure-error", "--cut-faults", "0")
            self.settings("--layers")
        self.assertGreater(len(asked), 40)
        self.assertLessEqual(asked, known)

    def test_horizons_with_commas(self):
        """A name of the file is not split."""
        known = ["Horizon 1", "Horizon 2", "Top", "Top, upper"]
        for words, names in ((["1,2"], ["1", "2"]), (["Top, upper"], ["Top, upper"]), (["Top,2"], ["Top", "2"]),
                             (["Top, upper", "1, 2"], ["Top, upper", "1", "2"]), (["Top,"], ["Top"]), ([2], ["2"]),
                             (["Base, lower"], ["Base", "lower"])):
            self.assertEqual(reading.names_in(words, known), names)

    def test_values_with_minus(self):
        """A value may begin with a minus, whatever the option, with and without an equals sign."""
        def outcome(*words):
            told = []
            parser = parser_of("horizon-mesh", lambda _, text: told.append(text))
            with contextlib.suppress(SystemExit):
                return vars(parser.parse_args([*words, "survey.vsm"]))
            return told

        actions = [action for action in parser_of()._actions if action.option_strings and action.nargs != 0]
        self.assertGreater(len(actions), 50)
        for action in actions:
            name = action.option_strings[-1]
            for value in ("-,X,Y,Z", "-1e5", "-H"):
                if action.nargs is None:
                    self.assertEqual(outcome(name, value), outcome("%s=%s" % (name, value)), name)
                else:
                    self.assertNotIn("expected %d arguments" % action.nargs, str(outcome(name, *[value] * action.nargs)), name)
        self.assertEqual(self.settings("--columns", "-,X,Y,Z").reader, {"Columns": "-,X,Y,Z"})
        self.assertEqual(self.settings("--origin", "-1e5", "-2", "0").reader, {"Origin": [-1e5, -2.0, 0.0]})
        self.assertEqual(outcome("--columns", "--stages"), ["argument --columns: expected one argument (see --help)"])
        self.assertEqual(outcome("--larges-error=3", "--xyz"), [
            "unrecognized arguments: --larges-error=3 --xyz; did you mean --largest-error? (see --help)"])

    def test_left_out(self):
        settings = self.settings("--stages", "--skip-rough", "--horizons", "3", "1")
        self.assertEqual((settings.rough, settings.elaborate, settings.error), (None, None, None))
        self.assertEqual(settings.horizons, ["3", "1"])
        self.assertIsNotNone(self.settings("--stages").rough)
        self.assertFalse(self.settings().leave_out_invalid)

    def test_given(self):
        settings = self.settings("--stages", "--radius", "2", "--growth-strategy", "Distance", "--elaborate", "--cell-size", "5",
                                 "--elaborate-cell-size", "6", "--representative", "NearestPoint")
        self.assertEqual((settings.boundary["Radius"], settings.boundary["GrowthStrategy"]), (2, "Distance"))
        self.assertTrue(self.settings("--leave-out-invalid").leave_out_invalid)
        self.assertEqual(settings.rough, {"CellSize": 5, "Representative": "NearestPoint"})
        self.assertEqual((settings.elaborate["CellSize"], settings.elaborate["Representative"]), (6, "NearestPoint"))

    def test_fill_holes(self):
        self.assertIsNone(self.settings().filled)
        for target in (("--stages",), ("--largest-error", "1")):
            first = self.settings("--fill-holes", "40", *target).stages()[0]
            self.assertEqual(first, ("filled", _core.fill_holes, {"LargestHoleSize": 40}))

    def test_preparations(self):
        """In their order, whatever that of the options."""
        settings = self.settings("--cut-faults", "3", "--fill-holes", "9", "--despike", "2.5")
        stages = settings.stages()[:3]
        self.assertEqual([name for name, _, _ in stages], ["despiked", "torn", "filled"])
        self.assertEqual((stages[0][2]["Threshold"], stages[1][2]["SmallestThrow"]), (2.5, 3.0))
        self.assertFalse(settings.can_go_by_rows())
        by_noise = self.stages("--cut-faults", "0")["torn"]
        self.assertEqual((by_noise.get("Detect", True), by_noise["SmallestThrow"]), (True, 0.0))

    def test_fault_files(self):
        """Alone nothing is detected, with --cut-faults both are done."""
        line_file = str(pathlib.Path(__file__).resolve().parents[1] / "Fuzz/Corpus/FuzzFaultLines/irap.pol")
        for words, detects, sticks in ((["--fault-lines", line_file], False, False),
                                         (["--fault-sticks", line_file, "--cut-faults", "3"], True, True)):
            settings = self.settings(*words)
            faults = self.stages(*words)["torn"]
            self.assertEqual((faults.get("Detect", True), faults["LineType"] == "Sticks"), (detects, sticks))
            self.assertGreater(data.count_lines(settings.fault_lines), 0)

    def test_height_units(self):
        """Heights without a unit are vertical indices; others come in the unit of the horizon."""
        heights = ("--cut-faults", "30%s", "--despike", "0%s", "--largest-error", "2%s")
        for unit, known, scale in (("", "ms", 1.0), ("ms", "ms", 1.0), ("ms", "s", 0.001), ("s", "ms", 1000.0), ("m", "", 1.0),
                                   ("ft", "m", 0.3048), ("m", "ft", 1.0 / 0.3048)):
            settings = self.settings(*(word % unit if "%" in word else word for word in heights))
            stages = {name: given for name, _, given in settings.in_unit_of(horizon_in(known)).stages()}
            found = (stages["despiked"]["ThresholdUnit"], stages["torn"]["ThrowUnit"], stages["mesh"].get("ErrorUnit", "Steps"))
            self.assertEqual(found, ("World" if unit else "Steps",) * 3)
            self.assertEqual(settings.in_unit(known).surface["MaximumError"], 2.0 * scale)
            self.assertEqual(stages["torn"]["SmallestThrow"], 30.0 * scale)
            self.assertEqual((stages["despiked"]["Threshold"], stages["mesh"]["MaximumError"]), (0.0, 2.0 * scale))
        for unit, expected in (("m", "m or ft"), ("ms", "ms or s"), ("km", "a number without unit")):
            said = "ms" if unit == "m" else "ft"
            with self.assertRaisesRegex(core.HorizonError, "2%s for z in %s, expected %s" % (said, unit, expected)):
                self.settings("--largest-error", "2" + said).in_unit_of(horizon_in(unit))

    def test_close_faults(self):
        """The stage that makes the mesh closes it."""
        for target in (("--stages",), ("--largest-error", "1")):
            for close in (False, True):
                settings = self.settings("--cut-faults", "3", *target, *(["--close-faults"] if close else []))
                name, _, given = settings.stages()[-1]
                self.assertEqual((name, given.get("CloseFaults", False)), ("mesh", close))

    def test_largest_error(self):
        """One stage, whose parameters are chosen unless they are given."""
        settings = self.settings("--largest-error", "1.5")
        self.assertEqual(settings.stages(), [("mesh", _core.surface, {"MaximumError": 1.5})])
        self.assertEqual(settings.surface, {"MaximumError": 1.5})
        own = self.settings("--largest-error", "1.5", "--radius", "1", "--outline-tolerance", "2",
                            "--smallest-hole-size", "40", "--distance-threshold", "0.4", "--minimum-patch-size", "9",
                            "--growth-strategy", "Distance", "--leave-out-invalid")
        (_, _, surface), = own.stages()
        self.assertEqual(surface, {"MaximumError": 1.5, "Radius": 1, "SmallestHoleSize": 40, "OutlineTolerance": 2.0,
                                   "DistanceThreshold": 0.4, "MinimumPatchSize": 9, "GrowthStrategy": "Distance"})
        self.assertTrue(own.leave_out_invalid)
        self.assertIsNone(self.settings("--stages", "--radius", "2").surface)
        even = self.settings("--edge-length", "12", "--smallest-angle", "20", "--layers")
        self.assertEqual(even.surface, {"EdgeLength": 12.0, "SmallestAngle": 20.0})
        self.assertEqual({**even.layers, **even.surface}, even.layers)

    def test_triangles(self):
        settings = self.settings("--triangles", "5000")
        self.assertEqual(settings.stages(), [("mesh", _core.surface, {"MaximumNumberOfTriangles": 5000})])
        self.assertFalse(settings.can_go_by_rows())

    def test_fewest_outline_points(self):
        settings = self.settings("--stages", "--fewest-outline-points", "--outline-tolerance", "0.5")
        self.assertEqual(settings.simplified["Method"], "FewestPoints")
        self.assertEqual(settings.simplified["OutlineTolerance"], 0.5)
        self.assertEqual(core.options(settings.simplified), {"method": "fewest_points", "outline_tolerance": 0.5})

    def test_core_takes_them(self):
        """The core passes over an option that it does not know, so that one with a wrong name would do nothing."""
        known = set(re.findall(r'Take(?:Choice)?\((?:chosen|given), "(\w+)"', "".join(
            path.read_text(encoding="utf-8") for path in BINDINGS.glob("*.cxx"))))
        own = {"line_type", "distance_unit", "order"}  # the command makes others of them
        words = ("--despike", "2", "--cut-faults", "3 ms", "--fill-holes", "9", "--measure-error", "--distance-unit", "World",
                 "--samples-per-point", "3", "--close-faults", "--minimum-patch-size", "9", "--growth-strategy", "Distance",
                 "--radius", "2", "--outline-tolerance", "1", "--distance-threshold", "1", "--smallest-hole-size", "9")
        of_stages = ("--stages", "--keep-holes", "--bound-deviation", "--fewest-outline-points", "--cell-size", "4", "--elaborate",
                     "--elaborate-cell-size", "5", "--flatness-threshold", "1", "--representative", "NearestPoint")
        of_surface = ("--largest-error", "2 ms", "--layers", "--crossings", "Mean", "--order", "AsGiven", "--missing", "Void",
                      "--sublayers", "1,3", "--tetrahedra", "--edge-length", "12", "--smallest-angle", "20")
        self.assertEqual(core.options(self.settings(*of_surface).layers)["sublayers"], "1 3")
        for more in (of_stages, of_surface, ("--triangles", "9")):
            settings = self.settings(*words, *more)
            for given in (*(given for _, _, given in settings.stages()), settings.error, settings.layers or {}):
                self.assertLessEqual(core.options(given).keys(), known | own)

    def test_documentation(self):
        """Names no options but those that there are; what its page tells of names and exit codes, the help does."""
        root = PROGRAM.parents[1]
        help_text = " ".join(horizon_mesh.make_parser().format_help().split())
        page_of_command = (root / "Documentation/Command.md").read_text(encoding="utf-8")
        paths = [root / "README.md", *(root / "Documentation").glob("*.md")]
        pages = [path.read_text(encoding="utf-8") for path in paths]
        lines = [line for page in pages for line in page.splitlines() if "horizon-mesh" in line or "horizon_mesh.py" in line]
        named = set(re.findall(r"--[a-z][a-z-]+", " ".join(lines)))
        self.assertIn("--measure-error", named)
        for word in {*named, "--leave-out-invalid", "--triangles"}:
            self.assertIn(word, help_text)
        for word in ("x_horizon_1.vtp", "x_error.csv", "a_x.png", "b_x.png", "130", "143", "--leave-out-invalid"):
            self.assertTrue(word in help_text and word in page_of_command, word)


if __name__ == "__main__":
    unittest.main(argv=["options_test"], verbosity=2)
