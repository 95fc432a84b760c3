# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of horizons, and seismic cubes: recognizes the format of a file and returns its horizons.

    horizons, seconds = read("survey.vsm")
    name, points = horizons[0]
"""

import os
import pathlib
import time

import numpy as np
from seismichorizons import _core, _gdal
from seismichorizons._data import SURVEY, stem

from . import core, cubes, tsurf
from .core import HorizonError, snake
from .progress import file_work

SPARSE = "sparse voxels"
KINDS = {"sparse": SPARSE, "grid": "grid", "cube": "seismic cube", "geotiff": "GeoTIFF", "tsurf": "triangles of GOCAD", "text": "text"}
# Properties by the formats that have them.
FRAMING = ("VerticalStep", "VerticalDirection", *SURVEY)
CORNERS = ("FirstCorner", "SecondCorner", "ThirdCorner")
PLACEMENT = ("DuplicatePolicy", "StrayPicks", "LatticeTolerance", "LatticeSource", "Origin", "ColumnStep", "RowStep", "LineNumbers", *CORNERS,
             "Gridding", "GriddingRadius", "GriddingSmoothing")
PROPERTIES = {
    "sparse": ("DuplicatePolicy", "Origin", "ColumnStep", "RowStep", "VerticalStep", "ZFrom", "VerticalDirection", "VerticalUnit",
               "VerticalDomain"),
    "grid": ("NullValues", *FRAMING), "geotiff": ("NullValues", *PLACEMENT, *FRAMING), "tsurf": (*PLACEMENT, *FRAMING),
    "text": ("Columns", "NullValues", "HeaderLines", "Where", *PLACEMENT, *FRAMING)}

NULLS = _core.DEFAULT_NULLS


def counts_indices(kind, properties):
    """Whether z of a format, read with some properties, is in vertical indices of unknown size."""
    return kind == SPARSE and not {"VerticalStep", "ZFrom"} & set(properties)


def find_format(path):
    """Returns the format of a file, by its content: a key of KINDS; None if it is none of these."""
    if not os.path.isfile(path):  # opening a pipe may block forever
        return None
    beginning = _beginning(path)
    if beginning.startswith(_gdal.BEGINNINGS):
        return "geotiff"
    if beginning.upper().startswith(b"GOCAD PLINE"):
        return None  # it begins like a surface
    return _core.find_format(os.fsencode(path)) or None


def _is_text(path):
    """Whether a file name is UTF-8."""
    try:
        str(path).encode()
    except UnicodeEncodeError:
        return False
    return True


def require_text(path):
    """Raises HorizonError if a file name is not UTF-8."""
    if not _is_text(path):
        raise HorizonError("%s: the name of the file is not in UTF-8" % ascii(str(path)))


class Source:
    """The horizons of a file in one piece. `load` makes a list of (name, data), the description as lines, and warnings;
    `surfaces` are the triangles from which horizons were sampled, by name."""

    def __init__(self, path, form, load, surfaces=None):
        self.path, self.kind = path, KINDS[form]
        self.surfaces = surfaces or {}
        self.number = None  # of horizons in the file, once it was read
        self.lines = []
        self._load = load

    def read(self, horizons=None):
        """Returns the horizons as a list of (name, data). Raises HorizonError."""
        found, self.lines, warnings = self._load()
        for text in filter(None, warnings):
            core.warn("%s: %s" % (self.path, text))
        self.number = len(found)
        chosen = choose([name for name, _ in found], None if self.surfaces else horizons, self.path)
        return [found[place] for place in chosen]


class SparseSource:
    """The horizons of a file of sparse voxels. With an overview it keeps no points, and reads chosen horizons, or rows of
    one that is meshed."""

    def __init__(self, path, with_overview, properties):
        self.path, self.kind, self.lines, self.surfaces = path, SPARSE, [], {}
        if with_overview and properties.get("DuplicatePolicy") == "Sheets":
            raise HorizonError("%s: DuplicatePolicy Sheets for a horizon read in parts, expected another policy or more memory "
                               "(--memory): sheets take the whole horizon" % path)
        self.unit = properties.get("VerticalUnit", "")  # of z
        self._file = _core.SparseFile(str(path), with_overview)
        self._duplicates = {"duplicates": _duplicates(properties)}
        origin = list(properties.get("Origin", (0.0, 0.0, 0.0)))
        self._options = {"origin": [*origin, 0.0][:3], "use_real_z": properties.get("ZFrom") == "RealZ",
                         **core.options({name: properties[name] for name in ("ColumnStep", "RowStep", "VerticalStep") if name in properties})}
        self._direction = snake(properties.get("VerticalDirection", ""))
        self._survey = _survey(properties)

    def list(self, label=""):
        """Lists the horizons. Raises HorizonError."""
        with core.errors("%s: " % self.path):
            core.run(self._file.list, self._duplicates, label=label, work=file_work(self.path))
        self.names, self.sizes = self._file.names, self._file.sizes
        self.number = len(self.names)

    def extent(self, place):
        """Returns the number of columns and rows around a horizon; needs an overview."""
        return self._file.extent(place)

    def surface(self, place, options, most_at_once, progress):
        """Returns the mesh of a horizon whose rows are read as needed, and warnings; needs an overview."""
        return self._file.surface(place, self._options, self._direction, self._survey, options, most_at_once, progress)

    def read(self, places, label=""):
        """Returns the horizons at places in the list as (name, data). Raises HorizonError."""
        with core.errors("%s: " % self.path):
            return core.run(self._file.take, places, self._options, self._direction, self._survey, label=label,
                            work=file_work(self.path))

    def read_all(self, horizons=None):
        self.list()
        return self.read(choose(self.names, horizons, self.path))


def open_file(path, horizons=None, left_out=None, with_overview=False, **properties):
    """Returns the source of the horizons of a file. Surfaces are checked here, only the wanted `horizons`; with a list
    `left_out`, the messages about surfaces that are not horizons are appended to it. Raises HorizonError, also for a property
    that the format does not have."""
    path = pathlib.Path(path)
    require_text(path)
    form = find_format(path) or ("cube" if cubes.is_named_so(path) else "text")
    if form == "cube":
        return cubes.CubeSource(path, properties)
    for name in properties:
        if name not in PROPERTIES[form]:
            raise HorizonError("%s: its format does not support %s" % (path, name))
    if form == "sparse":
        return SparseSource(path, with_overview, properties)
    if form == "tsurf":
        found, surfaces, sense, own = tsurf.sample_file(path, horizons, left_out, properties)
        placed = {**properties, **own}
        return Source(path, form, lambda: _described_around(_place(found, placed, path), KINDS[form], sense.splitlines()), surfaces)
    if form == "geotiff":
        with core.errors():
            arrays, own = _gdal.read_image(path)
        placed = {"Origin": own["origin"], "ColumnStep": own["column_step"], "RowStep": own["row_step"],
                  "VerticalDirection": own["direction"].capitalize(), "CoordinateSystem": own["coordinate_system"], **properties}
        return Source(path, form, lambda: _described_first(_place({path.stem: arrays}, placed, path), KINDS[form]))
    properties = _with_lattice(properties)
    return Source(path, form, lambda: (_read_grid if form == "grid" else _read_text)(path, properties))


def _beginning(path):
    """Returns the first bytes of a file; none if it cannot be read, which its reader reports."""
    try:
        with open(path, "rb") as file:
            return file.read(16)
    except OSError:
        return b""


def _with_lattice(properties):
    """Makes a given lattice replace the one that a reader would find."""
    if "Origin" not in properties:
        return properties
    *place, height = properties["Origin"] if len(properties["Origin"]) == 3 else (*properties["Origin"], 0.0)
    if height != 0.0:
        raise HorizonError("Origin with a z of %g, expected 0 for files that have z themselves" % height)
    return {**properties, "Origin": place}


# ---- Calls of the core ------------------------------------------------------------------------------------------------
def _duplicates(properties):
    policy = snake(properties.get("DuplicatePolicy", "StrongestAmplitude"))
    return "strongest" if policy == "strongest_amplitude" else policy


def _survey(properties):
    return tuple(properties.get(name) or "" for name in SURVEY)


def _framing(properties):
    """Returns vertical step, direction and survey."""
    direction = snake(properties.get("VerticalDirection", ""))
    return float(properties.get("VerticalStep", 0.0)), "" if direction == "automatic" else direction, _survey(properties)


def _placement(properties):
    """Returns the options of placing picks on a lattice."""
    places = {name: [float(value) for value in properties[name]] for name in ("Origin", "ColumnStep", "RowStep", "LineNumbers", *CORNERS) if name in properties}
    corners = {"corners": [places.pop(name) for name in CORNERS]} if CORNERS[0] in places else {}
    lines = {"lines": places.pop("LineNumbers")} if "LineNumbers" in places else {}
    gridding = snake(properties.get("Gridding", ""))
    numbers = {name: float(properties[key]) for name, key in (
        ("tolerance", "LatticeTolerance"), ("gridding_radius", "GriddingRadius"), ("gridding_smoothing", "GriddingSmoothing")) if key in properties}
    return {"duplicates": _duplicates(properties), "leave_out_strays": properties.get("StrayPicks") == "LeaveOut",
            "gridding": "" if gridding == "no_gridding" else gridding, "null_values": properties.get("NullValues", ""), **numbers,
            **core.options(places), **lines, **corners}


def _run(path, function, *arguments):
    with core.errors("%s: " % path):
        return core.run(function, *arguments, label="%s: reading" % path.name, work=file_work(path))


def _named(path, found, form=""):
    """Returns horizons with distinct names, the description as lines, and warnings, of what the core read. The name of the
    file, which some programs write as that of the horizon, is without its extension."""
    horizons, description, warnings = found
    names = _core.make_distinct([stem(path) if name in ("", path.name) else name for name, _ in horizons])
    return ([(name, data) for name, (_, data) in zip(names, horizons)], [*filter(None, form.splitlines()), *description.splitlines()], warnings)


def _read_grid(path, properties):
    form, found = _run(path, _core.read_grid, str(path), properties.get("NullValues", ""), *_framing(properties))
    return _named(path, found, form)


def _read_text(path, properties):
    form, found = _run(path, _core.read_text, str(path), properties.get("Columns", ""), properties.get("NullValues", NULLS),
                       int(properties.get("HeaderLines", 0)), properties.get("Where", ""), _placement(properties), *_framing(properties))
    return _named(path, found, form)


def _place(found, properties, path):
    """Places points, given as x, y and z by the name of their horizon."""
    numbers = [number for number, arrays in enumerate(found.values()) for _ in arrays["z"]]
    arrays = {axis: np.concatenate([own[axis] for own in found.values()]).astype(float) for axis in ("x", "y", "z")}
    placed = _run(path, _core.place_points, {**arrays, "horizon": np.array(numbers, np.int32)}, {}, list(found), _placement(properties),
                  *_framing(properties))
    return _named(path, placed)


def _described_first(made, line):
    return made[0], [line, *made[1]], made[2]


def _described_around(made, first, last):
    """The file, and not its columns, says where z increases to."""
    return made[0], [first, *made[1][:-1], *last], made[2]


# ---- Reading ----------------------------------------------------------------------------------------------------------
def read(path, horizons=None, **properties):
    """Returns the horizons of a file as a list of (name, data), and the time to read them in seconds.

    `horizons` lists the names to read, or the IDs in sparse-matrix files; None for all. Raises HorizonError if there is
    nothing to read.
    """
    path = pathlib.Path(path)
    return read_source(open_file(path, horizons, **properties), horizons)


def describe(source):
    """Returns the description of a file that was read: its format, the findings of the reader as lines, and the number of
    horizons."""
    return {"format": source.kind, "description": list(source.lines), "horizons_in_file": source.number}


def read_source(source, horizons=None):
    """Returns the same as read, for a source from open_file."""
    start = time.monotonic()
    found = source.read_all(horizons) if isinstance(source, SparseSource) else source.read(horizons)
    found = [(name, points) for name, points in found if len(points["places"])]
    if not found:
        raise HorizonError("%s: no points, expected those of a horizon" % source.path)
    return found, time.monotonic() - start


def read_first(path, **properties):
    """Returns the first horizon of a file."""
    return read(path, **properties)[0][0][1]


def name_of(horizon):
    """Returns the name of a horizon given by its ID or name."""
    return "Horizon %s" % horizon if str(horizon).isdecimal() else str(horizon)


def short_name(name):
    """Returns the ID of a horizon without another name, otherwise its name."""
    first, _, rest = name.partition(" ")
    return rest if first == "Horizon" and rest.isdecimal() else name


def names_in(words, known):
    """Returns the names of horizons in words, which are names or comma lists. A word that is the name of a known horizon is
    not split."""
    whole = {*known, *map(short_name, known)}
    return [name for word in map(str, words)
            for name in ([word] if word in whole or "," not in word else filter(None, map(str.strip, word.split(","))))]


def choose(known, horizons, path):
    """Returns the places of the wanted horizons in a list of names, in its order; all for None. Raises HorizonError if one is
    missing."""
    if horizons is None:
        return list(range(len(known)))
    wanted = set()
    for name in map(name_of, names_in(horizons, known)):
        if name not in known and short_name(name) not in known:
            raise HorizonError("%s: there is no horizon %s; the file has %s" % (
                path, short_name(name), ", ".join(short_name(k) for k in known) or "none"))
        wanted.add(name if name in known else short_name(name))
    return [place for place, name in enumerate(known) if name in wanted]
