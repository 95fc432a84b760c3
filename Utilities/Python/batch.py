# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of horizons, one after the other: each into a mesh for every horizon, a picture and a table."""

import ctypes
import ctypes.util
import os
import pathlib
import sys
import tempfile

from . import pipeline, tables, writing
from .stage import HorizonError


def run(inputs, output_folder, settings, with_pictures, report):
    """Does all files, and those of folders; returns how many failed. What is wrong with one goes to `report`, and the
    others are done all the same. Raises HorizonError or OSError when none can be done."""
    files = find_files(inputs)
    if with_pictures:
        check_display()
    made_folder = not output_folder.exists()
    output_folder.mkdir(parents=True, exist_ok=True)
    failures = 0
    for path in files:
        try:
            process(path, output_folder, settings, with_pictures)
        except (HorizonError, OSError) as error:
            failures += 1
            report(error)
    if made_folder and not any(output_folder.iterdir()):
        output_folder.rmdir()
    return failures


def find_files(inputs):
    """The files among the inputs, and those of the folders among them. Raises HorizonError."""
    files = []
    for path in inputs:
        if path.is_dir():
            found = sorted(path.glob("*.vsm"))
            if not found:
                raise HorizonError("%s: there is no .vsm file in this folder" % path)
            files.extend(found)
        else:
            files.append(path)
    taken = {}
    for path in files:
        if path.stem in taken:
            raise HorizonError("%s and %s would write the same results" % (taken[path.stem], path))
        taken[path.stem] = path
    return files


def process(path, output_folder, settings, with_pictures):
    """Does one file. Results appear in the output folder all together at the end, or not at all. Raises HorizonError or
    OSError."""
    horizons, read_seconds = pipeline.read(path, settings.horizons, **settings.reader)
    results = [pipeline.run(path.name, horizon_id, points, settings) for horizon_id, points in horizons]
    # In the same folder, so that files can be moved into place.
    with tempfile.TemporaryDirectory(prefix=".horizon_mesh-", dir=output_folder) as folder:
        folder = pathlib.Path(folder)
        _write(results, path.stem, folder, with_pictures)
        for file in sorted(folder.iterdir()):
            os.replace(file, output_folder / file.name)
    print("%s: read in %.2f s" % (path.name, read_seconds))
    for line in tables.table(results):
        print("  " + line)
    sys.stdout.flush()


def _write(results, stem, folder, with_pictures):
    for result in results:
        writing.write_mesh(result.data["mesh"], folder / ("%s_horizon_%d.vtp" % (stem, result.id)))
    if results[0].figures is not None:
        writing.write_figures(results, folder / ("%s_error.csv" % stem))
    if with_pictures:
        # Loads the libraries that draw, which are not needed otherwise.
        from . import overview

        if len(results) > overview.MOST_ROWS:
            print("  the picture shows the first %d of %d horizons" % (overview.MOST_ROWS, len(results)))
        overview.write(results, folder / ("%s.png" % stem))


def check_display():
    """Raises HorizonError where there is no X server: VTK ends the program then, better to say so before any work."""
    library = ctypes.util.find_library("X11") or "libX11.so.6"
    try:
        x11 = ctypes.CDLL(library)
    except OSError:
        return
    x11.XOpenDisplay.restype = ctypes.c_void_p
    display = x11.XOpenDisplay(None)
    if not display:
        raise HorizonError("pictures need an X server; start one with Utilities/with-xvfb.sh, or use --no-pictures")
    x11.XCloseDisplay(ctypes.c_void_p(display))
