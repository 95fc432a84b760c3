# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs in pvpython: wrong input through the proxies gives one clear message and no data. Argument: a folder."""

import contextlib
import os
import pathlib
import re
import sys
import tempfile

from paraview import simple

import wrong_files


@contextlib.contextmanager
def captured():
    """Collects what is written to the error output, by C++ as well. Gives a function that returns it."""
    kept = os.dup(2)
    with tempfile.TemporaryFile() as file:
        os.dup2(file.fileno(), 2)
        try:
            yield lambda: _text(file)
        finally:
            os.dup2(kept, 2)
            os.close(kept)


def _text(file):
    sys.stderr.flush()
    file.seek(0)
    return file.read().decode()


def messages(text):
    """The different errors in a log."""
    plain = re.sub(r"\x1b\[[0-9;]*m", "", text)
    found = re.findall(r"ERR\| (\w+) \(0x[0-9a-f]+\): (.*)", plain)
    return {message for _, message in found}


def check(name, parts, make, **properties):
    """Makes a proxy and runs it. ParaView asks for information and data in turn, and may be told the same twice."""
    with captured() as log:
        proxy = make(**properties)
        proxy.UpdatePipeline()
        text = log()
    found = sorted(messages(text))
    assert len(found) == 1, "%s: %d messages, expected 1:\n%s" % (name, len(found), text)
    for part in parts:
        assert part in found[0], "%s: %r lacks %r" % (name, found[0], part)
    count = proxy.GetDataInformation().GetNumberOfPoints()
    assert count == 0, "%s: %d points in spite of the error" % (name, count)
    print("%s: %s" % (name, found[0]))


def distance_errors(sphere):
    """Pairs that have no distance, as (name, parts of the message, reference, mesh)."""
    points = simple.PointSource(NumberOfPoints=10)
    plane = simple.Plane()
    return (("reference without lattice", ["reference: ", "LatticeDimensions"], points, sphere),
            ("mesh first", ["reference: ", "LatticeDimensions"], sphere, points),
            ("mesh of squares", ["mesh: ", "4 corners"], sphere, plane),
            ("two against one", ["no mesh for"], simple.GroupDatasets(Input=[sphere, sphere]), sphere))


def main():
    folder = pathlib.Path(sys.argv[1]).resolve()
    for path, parts in wrong_files.write(folder):
        check(path.name, parts, simple.VerneySparseMatrixReader, FileName=str(path))
    # File > Open finds the reader by the name of the file, so that it is the reader that says what is wrong.
    header = ["line 1", "expected three positive integers"]
    cut = ["byte 4: end of file, expected the rest of the compressed data"]
    for name, content, parts in (("empty.vsm", b"", header), ("CAPITALS.VSM", b"2 2\n", header),
                                 ("cut.vsm", b"\x1f\x8b\x08\x00", cut), ("cut.vsm.gz", b"\x1f\x8b\x08\x00", cut)):
        (folder / name).write_bytes(content)
        check("open " + name, parts, lambda path=folder / name: simple.OpenDataFile(str(path)))
    # A sphere is no horizon: it has neither a lattice nor an outline.
    sphere = simple.Sphere()
    for stage in ("HorizonExteriorBoundary", "HorizonBoundarySimplification", "HorizonRoughSimplification",
                  "HorizonElaborateSimplification", "HorizonTriangulation"):
        check(stage, ["expected"], getattr(simple, stage), Input=sphere)
    for name, parts, reference, mesh in distance_errors(sphere):
        check(name, ["expected", *parts], simple.HorizonSurfaceDistance, Reference=reference, Mesh=mesh)


if __name__ == "__main__":
    main()
