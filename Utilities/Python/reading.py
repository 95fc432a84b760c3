# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of horizons, and seismic cubes: which reader takes a file, and the horizons it gives.

    horizons, seconds = read("survey.vsm")
    name, points = horizons[0]
"""

import os
import pathlib

from . import cubes, geotiff, tsurf
from .progress import file_work
from .stage import HorizonError, configure, make, update, watched

SPARSE = "sparse voxels"
# With what they read, in the order they are asked.
READERS = {
    "vtkVerneySparseMatrixReader": SPARSE,
    "vtkHorizonGridReader": "grid",
    cubes.READER: "seismic cube",
    geotiff.SOURCE: "GeoTIFF",
    tsurf.READER: "triangles of GOCAD",
    "vtkHorizonTextReader": "text"}
# Says what is wrong with a file that none of them knows.
LAST_READER = "vtkHorizonTextReader"


def counts_indices(form, properties):
    """Whether the z of a format, read with some properties, are vertical indices, of which nothing tells how long one is."""
    return form == SPARSE and not {"VerticalStep", "ZFrom"} & set(properties)


def find_reader(path):
    """The name of the class that reads a file, by what is in it. None when there is none."""
    if not os.path.isfile(path):  # opening a pipe may wait for ever
        return None
    beginning = _beginning(path)
    if beginning.startswith(geotiff.BEGINNINGS):
        return geotiff.SOURCE
    if beginning.upper().startswith(b"GOCAD PLINE"):
        return None  # which begins as surfaces do
    return next((name for name in READERS if name != geotiff.SOURCE and make(name).CanReadFile(os.fsencode(path))), None)


def require_text(path):
    """Raises HorizonError where the name of a file is no text, as one in Latin-1: VTK takes names in UTF-8."""
    try:
        str(path).encode()
    except UnicodeEncodeError:
        raise HorizonError("%s: the name of the file is not in UTF-8" % ascii(str(path))) from None


def open_file(path, horizons=None, left_out=None, **properties):
    """What gives the horizons of a file: its reader, or the extraction from a cube. Surfaces are looked at here: only those of
    the `horizons` that are wanted, and with a list `left_out` the messages on those that are no horizon go there. Raises
    HorizonError when it has no such property."""
    require_text(path)
    name = find_reader(path) or (cubes.READER if cubes.is_named_so(path) else LAST_READER)
    if name == cubes.READER:
        return cubes.open_cube(path, **properties)
    if name == tsurf.READER:
        given = [properties.pop(key, None) for key in ("Origin", "ColumnStep", "RowStep")]
        properties.pop("VerticalDirection", None)  # the file says it
        surfaces = make(name, FileName=str(path))
        if horizons is not None:
            select(surfaces, horizons, path)
        reader = tsurf.open_file(surfaces, pathlib.Path(path), left_out, *given)
    else:
        reader = geotiff.open_file(pathlib.Path(path)) if name == geotiff.SOURCE else make(name, FileName=str(path))
        properties = _with_lattice(reader, properties)
    reader.kind = READERS[name]
    for name in properties:
        if not hasattr(reader, "Set" + name):
            raise HorizonError("%s: its format does not support %s" % (path, name))
    configure(reader, **properties)
    return reader


def _beginning(path):
    """The first bytes of a file; none where it cannot be read, which its reader tells."""
    try:
        with open(path, "rb") as file:
            return file.read(16)
    except OSError:
        return b""


def _with_lattice(reader, properties):
    """Where a reader finds the lattice of its file, what is given of it replaces what it finds."""
    given = [name for name in ("Origin", "ColumnStep", "RowStep") if name in properties]
    if not given or not hasattr(reader, "SetLatticeSource"):
        return properties
    properties = {**properties, "LatticeSource": "OriginAndSteps"}
    if "Origin" in properties:
        *place, height = properties["Origin"] if len(properties["Origin"]) == 3 else (*properties["Origin"], 0.0)
        if height != 0.0:
            raise HorizonError("Origin with a z of %g, expected 0 for files that have z themselves" % height)
        properties["Origin"] = place
    return properties


def read(path, horizons=None, **properties):
    """The horizons of a file as a list of (name, polydata), and the seconds it took to read them.

    `horizons` are those wanted, by name, or by the ID of sparse-matrix files; None for all. Raises HorizonError when
    there is nothing to read.
    """
    path = pathlib.Path(path)
    return read_source(open_file(path, horizons, **properties), path, horizons)


def describe(source):
    """What there is to say of a file that was opened: the kind of its format, what the reader has found as lines, and how
    many horizons it has."""
    reader = source.GetInputAlgorithm() if cubes.is_extraction(source) else source
    form = getattr(reader, "kind", "") or READERS[reader.GetClassName()]
    lines = reader.GetDescription().splitlines() if hasattr(reader, "GetDescription") else []
    return {"format": form, "description": [form, *lines] if reader.GetClassName() == geotiff.SOURCE else lines,
            "horizons_in_file": source.GetNumberOfHorizons()}


def read_source(source, path, horizons=None):
    """The same of what open_file gave."""
    seconds = 0.0
    if cubes.is_extraction(source):
        seconds += cubes.read(source, path)
        for port, files in ((1, [source.picks] if source.picks else []), (2, source.limits)):
            seconds += sum(_connect(source, port, pathlib.Path(file)) for file in files)
    elif horizons is not None and not hasattr(source, "surfaces"):  # of which open_file has chosen
        select(source, horizons, path)
    seconds += update(source, "%s: reading" % path.name, work=None if cubes.is_extraction(source) else file_work(path))
    if cubes.is_extraction(source) and horizons is not None:
        _switch(source, horizons, path)
    found = [(name, points) for name, points in list_horizons(source.GetOutputDataObject(0))
             if source.GetHorizonStatus(name)]
    if not found:
        raise HorizonError("%s: no points, expected those of a horizon at least" % path)
    if getattr(source, "kind", "") == READERS[geotiff.SOURCE]:  # whose horizon has no name but that of its file
        found = [(path.stem, points) for _, points in found]
    return found, seconds


def _connect(extraction, port, path):
    """Gives an extraction the horizons of a file. Returns the seconds it took."""
    reader = open_file(path)
    if cubes.is_extraction(reader):
        raise HorizonError("%s: a seismic cube, expected picks of horizons" % path)
    if hasattr(reader, "SetLatticeSource"):  # a few picks have no lattice of their own
        configure(reader, **_with_lattice(reader, cubes.lattice_properties(extraction)))
    seconds = update(reader, "%s: reading" % path.name, work=file_work(path))
    extraction.AddInputConnection(port, reader.GetOutputPort())
    return seconds


def list_horizons(output):
    """The horizons of a collection that have points, as a list of (name, polydata)."""
    found = []
    for block in range(output.GetNumberOfPartitionedDataSets()):
        horizon = output.GetPartition(block, 0)
        if horizon is not None and horizon.GetNumberOfPoints():
            found.append((output.GetMetaData(block).Get(output.NAME()), horizon))
    return found


def read_first(path, **properties):
    """The first horizon of a file."""
    return read(path, **properties)[0][0][1]


def name_of(horizon):
    """The name of a horizon that is given by its ID, or by its name."""
    return "Horizon %s" % horizon if str(horizon).isdecimal() else str(horizon)


def short_name(name):
    """The ID of a horizon that has no other name, or its name."""
    first, _, rest = name.partition(" ")
    return rest if first == "Horizon" and rest.isdecimal() else name


def selected(reader):
    """The names of the horizons that are switched on."""
    names = [reader.GetHorizonName(number) for number in range(reader.GetNumberOfHorizons())]
    return [name for name in names if reader.GetHorizonStatus(name)]


def select(reader, horizons, path):
    """Leaves only some horizons switched on. Raises HorizonError when the file does not have them."""
    with watched(reader):
        reader.UpdateInformation()
    _switch(reader, horizons, path)


def _switch(reader, horizons, path):
    """The same once the list of horizons is filled."""
    known = [reader.GetHorizonName(i) for i in range(reader.GetNumberOfHorizons())]
    reader.DisableAllHorizons()
    for name in map(name_of, horizons):
        if name not in known and short_name(name) not in known:
            raise HorizonError("%s: there is no horizon %s; the file has %s" % (
                path, short_name(name), ", ".join(short_name(k) for k in known) or "none"))
        reader.SetHorizonStatus(name if name in known else short_name(name), 1)
