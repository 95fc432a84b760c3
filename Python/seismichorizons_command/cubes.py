# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Seismic cubes: the reflections of a SEG-Y file, joined to horizons."""

import pathlib

import numpy as np
from seismichorizons import _core
from seismichorizons._data import SURVEY

from . import core, data
from .core import snake
from .memory import size_text
from .progress import file_work

# Number of surfaces of a cube that become meshes, strongest first.
LARGEST_NUMBER = 20
# Peak memory in bytes per sample, cube included, while reflections are joined (ReflectionBenchmark).
WORKED = 30
WORKED_WITH_PICKS = 45
# Of cubes of more samples, only what is near picks is searched, with so many bytes per trace and horizon.
LARGEST_WHOLE = 100_000_000
WORKED_NEAR_PICKS = 1500


def is_named_so(path):
    """Whether a file has the extension of SEG-Y, whatever it contains."""
    return pathlib.Path(path).suffix.lower() in (".sgy", ".segy")


# Properties of the reader, of the survey and of the extraction.
READER = ("InlineByte", "CrosslineByte", "XByte", "YByte", "InlineRange", "CrosslineRange", "SampleRange", "SampleFormat", "NumberOfSamples",
          "IgnoreIncompleteTrace", "LatticeTolerance", "DuplicatePolicy", "DelayPolicy", "VerticalStep")
FRAME = ("VerticalDirection", *SURVEY)
EXTRACTION = ("Polarity", "Joining", "AmplitudePercentile", "LimitSide", "LargestNumber", "SmallestSize", "PhaseRotation", "Position",
              "AmplitudeThreshold", "Connectivity", "LargestStep", "SmallestCorrelation", "SmallestContact", "Order", "GuideTolerance",
              "GrowthCorrelation", "GrowthReach", "LeastConfidence", "KeepOthers")
# Those that the core has by another name.
RENAMED = {"InlineRange": "inlines", "CrosslineRange": "crosslines", "LatticeTolerance": "tolerance", "DelayPolicy": "delays"}
# Attributes of points: where the traces of a single line are, which may be off the lattice.
LINE_PLACES = ("LineX", "LineY")


class CubeSource:
    """The horizons that are extracted from a cube: those of a file of picks, between those of files of limits, or the
    strongest. Raises core.HorizonError for a property that neither reader nor extraction has."""

    kind = "seismic cube"

    def __init__(self, path, properties):
        self.path, self.lines, self.surfaces, self.number = path, [], {}, None
        self.picks, self.limits = properties.pop("Picks", None), properties.pop("Limits", ())
        for name in properties:
            if name not in (*READER, *FRAME, *EXTRACTION):
                raise core.HorizonError("%s: a seismic cube does not support %s" % (path, name))
        self._given = properties
        self._file = None
        self._budget = None

    def _chosen(self, names):
        return core.options({RENAMED.get(name, name): value for name, value in self._given.items() if name in names})

    def _of_extraction(self):
        chosen = {"largest_number": LARGEST_NUMBER, **self._chosen(EXTRACTION)}
        if "connectivity" in chosen:
            chosen["eight_neighbours"] = chosen.pop("connectivity") == "eight"
        return {"threshold": "amplitude", **chosen} if "amplitude_threshold" in chosen else chosen

    def open(self):
        """Reads the headers. Raises HorizonError."""
        with core.errors("%s: " % self.path):
            self._file = core.run(_core.CubeFile, str(self.path), self._chosen(READER), label="%s: reading headers" % self.path.name)

    def require(self, budget):
        """Raises HorizonError if the cube and its picks do not fit in memory; those of more than one horizon are counted when
        they are read."""
        self.open()
        self._budget = budget
        self._require(1)

    def _require(self, horizons):
        size = WORKED_NEAR_PICKS * horizons * self._file.traces if self.is_read_near_picks() else (
            (WORKED_WITH_PICKS if self.picks else WORKED) * self._file.samples)
        self._budget.require_bytes(size, "%s: a cube that takes %s with its picks" % (self.path, size_text(size)),
                                   "; --inlines and --crosslines read a part")

    def is_read_near_picks(self):
        """Whether samples stay in the file."""
        return bool(self.picks) and not self._given.get("KeepOthers") and self._file.samples > LARGEST_WHOLE

    def read(self, horizons=None):
        """Returns the horizons as a list of (name, data). Raises HorizonError."""
        from . import reading  # which also reads picks, and needs this module

        if self._file is None:
            self.open()
        direction = snake(self._given.get("VerticalDirection", ""))
        survey = tuple(self._given.get(name, "") for name in SURVEY)
        with core.errors("%s: " % self.path):
            is_loaded = not self.is_read_near_picks()
            cube, warnings = core.run(self._file.read, "up" if direction == "up" else "down", survey, is_loaded,
                                      label="%s: reading the cube" % self.path.name, work=file_work(self.path))
        self.lines = cube["description"].splitlines()
        self._warn(warnings)
        image = {"extent": cube["extent"], "to_world": cube["to_world"], "field_data": cube["field_data"]}
        for name, array in cube.pop("point_data").items():
            image["ghosts" if name == "vtkGhostType" else "amplitudes"] = array
        if not is_loaded:
            image["file"] = self._file
        place = lattice_properties(cube)
        others = [[horizon for file in files for horizon in self._read_others(file, place, reading)] or None for files in (
            [self.picks] if self.picks else [], self.limits)]
        if self._budget and others[0]:
            self._require(len(others[0]))
        self._file = None
        with core.errors("%s: " % self.path):
            (found, _, _), warnings = core.run(_core.extract, image, *others, self._of_extraction(), label="%s: reading" % self.path.name)
        self._warn(warnings)
        for _, horizon in found if "line" in cube else ():
            column, row = (horizon["point_data"]["Column"] - cube["extent"][0:4:2]).T
            places = cube["line"][column + row * (cube["extent"][1] - cube["extent"][0] + 1)]
            horizon["point_data"].update(zip(LINE_PLACES, np.ascontiguousarray(places[:, :2].T)))
        self.number = len(found)
        return [found[number] for number in reading.choose([name for name, _ in found], horizons, self.path)]

    def _warn(self, warnings):
        for text in filter(None, warnings):
            core.warn("%s: %s" % (self.path, text))

    @staticmethod
    def _read_others(file, place, reading):
        """Returns the horizons of a file of picks or limits, on the columns of the cube. A few picks do not define a
        lattice."""
        source = reading.open_file(file)
        if isinstance(source, CubeSource):
            raise core.HorizonError("%s: a seismic cube, expected picks of horizons" % file)
        if source.kind == reading.KINDS["text"]:
            source = reading.open_file(file, **place)
        return reading.read_source(source)[0]


def lattice_properties(cube):
    """Returns the properties that make a reader place picks on the columns of a cube; well picks and other surveys lie between
    columns. z has the direction of the cube; if that is downwards, negative z still lies above 0."""
    matrix = np.reshape(data.values(cube, "LatticeToWorld"), (4, 4))
    return {"LineNumbers": data.values(cube, "LineNumbers"), "Origin": matrix[:2, 3].tolist(), "ColumnStep": matrix[:2, 0].tolist(), "RowStep": matrix[:2, 1].tolist(),
            "LatticeTolerance": 0.499, "StrayPicks": "LeaveOut",
            "VerticalDirection": "Up" if data.vertical_direction(cube) > 0 else "Automatic"}
