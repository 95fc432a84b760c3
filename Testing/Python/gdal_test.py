# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""GDAL reads the grids we write, and we read those it writes. Argument: a folder. Exits with 77 where its program
gdal_translate is not installed (package gdal-bin)."""

import pathlib
import shutil
import subprocess
import sys

import numpy as np
import seismichorizons as sh
from seismichorizons_command import core, data, pipeline, reading, writing

FOLDER = pathlib.Path(sys.argv[1])
# Formats of GDAL that we read, with the extension of their files and how exact their numbers are.
FORMATS = {"GSAG": (".grd", 1e-6), "GSBG": (".grd", 1e-4), "GS7BG": (".grd", 1e-9), "AAIGrid": (".asc", 1e-4),
           "ZMap": (".zmap", 1e-3)}


def write_horizon(path):
    """A folded surface with a hole, steps of 25 in x and y."""
    lines = ["%.1f %.1f %.6f" % (459600.0 + 25.0 * i, 5934800.0 + 25.0 * j, 1500.0 + 30.0 * np.sin(i / 5.0) + 1.5 * j)
             for j in range(20) for i in range(30) if not (8 < i < 12 and 5 < j < 9)]
    path.write_text("\n".join(lines) + "\n", encoding="ascii")
    horizons, _ = reading.read(path)
    return horizons[0][1]


def places(horizon):
    """Its points by ascending y, and then x."""
    points = horizon["places"]
    return points[np.lexsort((points[:, 0], points[:, 1]))]


def run_gdal(source, target, gdal_format):
    command = ["gdal_translate", "-q", "-of", gdal_format, "--config", "ZMAP_PIXEL_IS_POINT", "TRUE", str(source),
               str(target)]
    return subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)


def translate(source, target, gdal_format):
    done = run_gdal(source, target, gdal_format)
    assert done.returncode == 0, done.stderr


def can_write(gdal_format):
    """Whether GDAL does it with a grid that is not ours: GS7BG of 3.13 takes as many rows as there are columns."""
    source = FOLDER / "wide.asc"
    source.write_text("ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n4 5 6\n", encoding="ascii")
    return run_gdal(source, FOLDER / "wide", gdal_format).returncode == 0


def main():
    if not shutil.which("gdal_translate"):
        print("gdal_translate is not installed")
        sys.exit(77)
    FOLDER.mkdir(parents=True, exist_ok=True)
    horizon = write_horizon(FOLDER / "picks.xyz")
    assert writing.write_data(horizon, FOLDER / "ours.zmap", "ours") == []
    expected = places(horizon)
    for name, (extension, precision) in FORMATS.items():
        if name == "GS7BG" and not can_write(name):
            print("%s: left out, this GDAL cannot write it" % name)
            continue
        path = FOLDER / (name + extension)
        translate(FOLDER / "ours.zmap", path, name)
        # Grids of this format are elevations, unless we are told that ours are depths.
        horizons, _ = reading.read(path, **({"VerticalDirection": "Down"} if name == "AAIGrid" else {}))
        found = places(horizons[0][1])
        assert found.shape == expected.shape, "%s: %d points, expected %d" % (name, len(found), len(expected))
        difference = abs(found - expected).max(axis=0)
        assert (difference <= [1e-6, 1e-6, precision]).all(), "%s: %s off" % (name, difference)
        print("%s: %d points, at most %g off" % (name, len(found), difference[2]))
    check_ours(horizon, expected)
    check_geotiff()


def check_ours(horizon, expected):
    """GDAL finds what we write of a horizon at its nodes, and nothing else."""
    for name, sign in (("ours.grd", -1.0), ("ours.asc", 1.0)):
        assert writing.write_data(horizon, FOLDER / name, "ours") == []
        done = subprocess.run(["gdal_translate", "-q", "-of", "XYZ", "-ot", "Float64", str(FOLDER / name), "/vsistdout/"],
                              capture_output=True, text=True, timeout=60, check=True)
        nodes = np.array([line.split() for line in done.stdout.splitlines()], float)
        nodes = nodes[(abs(nodes[:, 2]) < 1e38) & (nodes[:, 2] != -9999.0)]
        nodes = nodes[np.lexsort((nodes[:, 0], nodes[:, 1]))]
        assert len(nodes) == len(expected), (name, len(nodes), len(expected))
        assert np.allclose(nodes, expected * (1.0, 1.0, sign), rtol=0.0, atol=1e-3), name  # GDAL has single precision of text.
        print("%s: %d nodes as they were" % (name, len(nodes)))


def check_geotiff():
    """On a turned lattice: GDAL's program finds the values where the picks are, and we read them back there."""
    try:
        from osgeo import gdal  # noqa: F401
    except ImportError:
        print("GeoTIFF: left out, GDAL for Python is not installed")
        return
    turn = np.array([[0.8, -0.6], [0.6, 0.8]])
    columns = [(i, j) for j in range(9) for i in range(12) if (i, j) != (4, 4)]
    picks = np.array([(*turn @ (25.0 * i, 50.0 * j) + (460000.0, 5930000.0), 1500.0 + 3.0 * i + 2.0 * j) for i, j in columns])
    (FOLDER / "turned.xyz").write_text("".join("%.3f %.3f %.3f\n" % tuple(pick) for pick in picks), encoding="ascii")
    (name, horizon), = reading.read(FOLDER / "turned.xyz", CoordinateSystem="EPSG:23031")[0]
    assert writing.write_data(horizon, FOLDER / "turned.tif", name) == []
    there = "".join("%.6f %.6f\n" % tuple(pick[:2]) for pick in picks)
    asked = subprocess.run(["gdallocationinfo", "-valonly", "-geoloc", str(FOLDER / "turned.tif")], input=there,
                           capture_output=True, text=True, timeout=60, check=True)
    assert np.allclose([float(line) for line in asked.stdout.split()], picks[:, 2], atol=1e-9, rtol=0.0), asked.stdout
    ((name, again),), _ = reading.read(FOLDER / "turned.tif")
    assert name == "turned"
    assert data.text(again, "CoordinateSystem") == "EPSG:23031"
    assert np.allclose(places(again), places(horizon), atol=1e-6, rtol=0.0)
    one = sh.read(FOLDER / "turned.tif")["turned"]
    sh.write(one, FOLDER / "again.tif")
    (back,) = sh.read(FOLDER / "again.tif").values()
    assert (back.z == one.z).all() and (back.columns == one.columns).all() and back.direction == "down" and back.coordinate_system == "EPSG:23031"
    print("GeoTIFF: %d points" % data.count_points(again))
    check_elevations()


def check_elevations():
    """GeoTIFF of terrain models, as GDAL writes it, is upright; what we wrote of depths says so, and is, too (above)."""
    translate(FOLDER / "ours.zmap", FOLDER / "terrain.tif", "GTiff")
    for properties, sign in (({}, 1.0), ({"VerticalDirection": "Down"}, -1.0)):
        ((_, terrain),), _ = reading.read(FOLDER / "terrain.tif", **properties)
        lowest, highest = data.bounds(terrain)[4:]
        assert sign * (lowest + highest) > 2000.0, (lowest, highest)
    null = terrain["places"][0, 2]
    ((_, fewer),), _ = reading.read(FOLDER / "terrain.tif", VerticalDirection="Up", NullValues="word %.9g" % -null)
    assert 0 < len(fewer["places"]) == np.count_nonzero(~np.isclose(terrain["places"][:, 2], null, 1e-6)), fewer["places"].shape
    (FOLDER / "sticks.txt").write_text("459650 5934850 900 F 1\n459660 5934900 2100 F 1\n459900 5934850 900 F 2\n"
                                       "459910 5934900 2100 F 2\n", encoding="ascii")
    ((name, terrain),), _ = reading.read(FOLDER / "terrain.tif")
    for direction in (None, "Up"):
        settings = pipeline.Settings(reader={"VerticalDirection": direction} if direction else {})
        settings.torn, settings.fault_lines, _ = pipeline.fault_settings(
            "World", direction, sticks=[FOLDER / "sticks.txt"])
        try:
            pipeline.run("terrain.tif", name, terrain, pipeline.with_faults(settings))
            assert direction == "Up"
        except core.HorizonError as error:
            assert direction is None and "expected --vertical-direction" in str(error), error


main()
