# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of horizons, and seismic cubes: selects the reader of a file and returns its horizons.

    horizons, seconds = read("survey.vsm")
    name, points = horizons[0]
"""

import os
import pathlib

from . import cubes, geotiff, tsurf
from .progress import file_work
from .stage import HorizonError, configure, make, update, watched

SPARSE = "sparse voxels"
# Readers and their formats, in the order in which they are tried.
READERS = {
    "vtkVerneySparseMatrixReader": SPARSE,
    "vtkHorizonGridReader": "grid",
    cubes.READER: "seismic cube",
    geotiff.SOURCE: "GeoTIFF",
    tsurf.READER: "triangles of GOCAD",
    "vtkHorizonTextReader": "text"}
# This reader reports the error of a file in an unknown format.
LAST_READER = "vtkHorizonTextReader"


def counts_indices(form, properties):
    """Whether z of a format, read with some properties, is in vertical indices of unknown size."""
    return form == SPARSE and not {"VerticalStep", "ZFrom"} & set(properties)


def find_reader(path):
    """Returns the name of the class that reads a file, by its content; None if there is none."""
    if not os.path.isfile(path):  # opening a pipe may block forever
        return None
    beginning = _beginning(path)
    if beginning.startswith(geotiff.BEGINNINGS):
        return geotiff.SOURCE
    if beginning.upper().startswith(b"GOCAD PLINE"):
        return None  # it begins like a surface
    return next((name for name in READERS if name != geotiff.SOURCE and make(name).CanReadFile(os.fsencode(path))), None)


def require_text(path):
    """Raises HorizonError if a file name is not UTF-8, which VTK requires."""
    try:
        str(path).encode()
    except UnicodeEncodeError:
        raise HorizonError("%s: the name of the file is not in UTF-8" % ascii(str(path))) from None


def open_file(path, horizons=None, left_out=None, **properties):
    """Returns the source of the horizons of a file: its reader, or the extraction from a cube. Surfaces are checked here,
    only the wanted `horizons`; with a list `left_out`, the messages about surfaces that are not horizons are appended to
    it. Raises HorizonError for a property that the source does not have."""
    require_text(path)
    name = find_reader(path) or (cubes.READER if cubes.is_named_so(path) else LAST_READER)
    if name == cubes.READER:
        return cubes.open_cube(path, **properties)
    if name == tsurf.READER:
        given = [properties.pop(key, None) for key in ("Origin", "ColumnStep", "RowStep")]
        properties.pop("VerticalDirection", None)  # the file defines it
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
    """Returns the first bytes of a file; none if it cannot be read, which its reader reports."""
    try:
        with open(path, "rb") as file:
            return file.read(16)
    except OSError:
        return b""


def _with_lattice(reader, properties):
    """Makes a given lattice replace the one that a reader would find."""
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
    """Returns the horizons of a file as a list of (name, polydata), and the time to read them in seconds.

    `horizons` lists the names to read, or the IDs in sparse-matrix files; None for all. Raises HorizonError if there is
    nothing to read.
    """
    path = pathlib.Path(path)
    return read_source(open_file(path, horizons, **properties), path, horizons)


def describe(source):
    """Returns the description of a file that was opened: its format, the findings of the reader as lines, and the number of
    horizons."""
    reader = source.GetInputAlgorithm() if cubes.is_extraction(source) else source
    form = getattr(reader, "kind", "") or READERS[reader.GetClassName()]
    lines = reader.GetDescription().splitlines() if hasattr(reader, "GetDescription") else []
    if hasattr(source, "surfaces"):  # whose file, and not their columns, says where z grows to
        lines[-1:] = source.direction.splitlines()
    return {"format": form, "description": [form, *lines] if reader.GetClassName() == geotiff.SOURCE else lines,
            "horizons_in_file": source.GetNumberOfHorizons()}


def read_source(source, path, horizons=None):
    """Returns the same as read, for a source from open_file."""
    seconds = 0.0
    if cubes.is_extraction(source):
        seconds += cubes.read(source, path)
        for port, files in ((1, [source.picks] if source.picks else []), (2, source.limits)):
            seconds += sum(_connect(source, port, pathlib.Path(file)) for file in files)
    elif horizons is not None and not hasattr(source, "surfaces"):  # open_file has already selected surfaces
        select(source, horizons, path)
    seconds += update(source, "%s: reading" % path.name, work=None if cubes.is_extraction(source) else file_work(path))
    if cubes.is_extraction(source) and horizons is not None:
        _switch(source, horizons, path)
    found = [(name, points) for name, points in list_horizons(source.GetOutputDataObject(0))
             if source.GetHorizonStatus(name)]
    if not found:
        raise HorizonError("%s: no points, expected those of a horizon at least" % path)
    if getattr(source, "kind", "") == READERS[geotiff.SOURCE]:  # its horizon is named after the file
        found = [(path.stem, points) for _, points in found]
    return found, seconds


def _connect(extraction, port, path):
    """Connects the horizons of a file to an extraction. Returns the time in seconds."""
    reader = open_file(path)
    if cubes.is_extraction(reader):
        raise HorizonError("%s: a seismic cube, expected picks of horizons" % path)
    if hasattr(reader, "SetLatticeSource"):  # a few picks do not define a lattice
        configure(reader, **_with_lattice(reader, cubes.lattice_properties(extraction)))
    seconds = update(reader, "%s: reading" % path.name, work=file_work(path))
    extraction.AddInputConnection(port, reader.GetOutputPort())
    return seconds


def list_horizons(output):
    """Returns the horizons of a collection that have points, as a list of (name, polydata)."""
    found = []
    for block in range(output.GetNumberOfPartitionedDataSets()):
        horizon = output.GetPartition(block, 0)
        if horizon is not None and horizon.GetNumberOfPoints():
            found.append((output.GetMetaData(block).Get(output.NAME()), horizon))
    return found


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


def selected(reader):
    """Returns the names of the selected horizons."""
    names = [reader.GetHorizonName(number) for number in range(reader.GetNumberOfHorizons())]
    return [name for name in names if reader.GetHorizonStatus(name)]


def select(reader, horizons, path):
    """Selects only the given horizons. Raises HorizonError if the file does not have them."""
    with watched(reader):
        reader.UpdateInformation()
    _switch(reader, horizons, path)


def names_in(words, known):
    """Returns the names of horizons in words, which are names or comma lists. A word that is the name of a known horizon is
    not split."""
    whole = {*known, *map(short_name, known)}
    return [name for word in map(str, words)
            for name in ([word] if word in whole or "," not in word else filter(None, map(str.strip, word.split(","))))]


def _switch(reader, horizons, path):
    """Does the same after the list of horizons has been filled."""
    known = [reader.GetHorizonName(i) for i in range(reader.GetNumberOfHorizons())]
    reader.DisableAllHorizons()
    for name in map(name_of, names_in(horizons, known)):
        if name not in known and short_name(name) not in known:
            raise HorizonError("%s: there is no horizon %s; the file has %s" % (
                path, short_name(name), ", ".join(short_name(k) for k in known) or "none"))
        reader.SetHorizonStatus(name if name in known else short_name(name), 1)
