# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs in pvpython: files are opened by what is in them, whatever their names, and those of others stay theirs.

Arguments: the generator of cubes, and a folder for files.
"""

import gzip
import pathlib
import shutil
import subprocess
import sys

# Before any object of these classes comes out of a proxy: Python would take it for one of a base class, for good.
import seismichorizons.vtk  # noqa: F401

from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

TEXT, GRID, CUBE = "HorizonTextReader", "HorizonGridReader", "SEGYCubeReader"
MESH, LINES, VOXELS = "GOCADTSurfReader", "FaultLinesReader", "VerneySparseMatrixReader"
TABLE = "CSVReader"

PLACES = [(i, j, 100.5 + 25 * i, 200.25 + 25 * j, 500 + i + j * j) for j in range(6) for i in range(5)]


def picks(separator=" ", head="", columns=(2, 3, 4)):
    return head + "".join(separator.join("%g" % place[n] for n in columns) + "\n" for place in PLACES)


OPENDTECT = '# "Inline"\t"Crossline"\t"Z"\n# - - - - - - - - - -\n' + picks("\t", columns=(1, 0, 4))
CHARISMA = "".join("INLINE : %d XLINE : %d %.2f %.2f %.2f\n" % (j + 100, i + 100, x, y, z) for i, j, x, y, z in PLACES)
IRAP = "-996 2 25.0 25.0\n0 50 0 25\n3 0.0 0.0 0.0\n0 0 0 0 0 0 0\n1 2 3 4 5 6\n"
ZMAP = "@top HEADER , GRID, 5\n15, -99999.0, , 4, 1\n3, 2, 0.0, 100.0, 0.0, 200.0\n0.0, 0.0, 0.0\n@\n 1 2 3\n 4 5 6\n"
ESRI = "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2 3\n4 5 6\n"
TSURF = "GOCAD TSurf 1\nHEADER {\nname:Top\n}\nTFACE\nVRTX 1 0 0 0\nVRTX 2 1 0 0\nVRTX 3 0 1 0\nTRGL 1 2 3\nEND\n"
PLINE = "GOCAD PLine 1\nHEADER {\nname:F1\n}\nILINE\nVRTX 1 0 0 0\nVRTX 2 1 0 0\nSEG 1 2\nEND\n"


def sticks(names, line):
    """Two sticks of four points: fault, x, y, z and node."""
    rows = [line.format(stick, 100.5 + 71.3 * stick + 1.7 * node ** 2, 2000.25 + 3.1 * node ** 3, 1500 + 10.3 * node, node) for stick in range(2) for node in range(4)]
    return "\n".join([names] * bool(names) + rows) + "\n"


IRAP_LINES = "20.5 -9.0 0\n20.5 900.0 0\n999.0 999.0 999.0\n1 2 3\n4 5 6\n999.0 999.0 999.0\n"
MATRIX = "3 2 9\n1 1 1 1 1\n2 1 1 2 2\n3 1 1 3 3\n4 1 1 4 4\n\n6 1 1 6 6\n"
SCATTER = "".join("%d.%d %d.%d 3.5\n" % (n * n % 97, n * 7 % 10, n * n * n % 89, n * 3 % 10) for n in range(50))
PARTICLES = "x,y,z,speed\n" + SCATTER.replace(" ", ",").replace("\n", ",1\n")
VOLUME = "x,y,z,density\n" + "".join("%d,%d,%d,1\n" % (i, j, k) for k in range(9) for j in range(9) for i in range(9))
SERIES = "day,temperature,pressure\n" + "".join("%d,%.1f,%.1f\n" % (n, 20 - n % 3, 1000 + n % 7) for n in range(40))
FIELD = picks(",", "x,y,temperature\n")
SIZES = "nrows ncols seconds\n" + "".join("%d %d %.2f\n" % (n, n * n % 7, n / 3) for n in range(20))
NOTE = "Dear all,\nsee you at 10 o'clock\n"
TECPLOT = 'VARIABLES = "X", "Y", "Z"\nZONE I=5, J=6, F=POINT\n' + picks()
MOLECULE = "3\nwater\nO 0.0 0.0 0.0\nH 0.0 1.0 0.0\nH 1.0 0.0 0.0\n"
DOUBT = "".join("%d %.1f %.1f %g\n" % (n + 1, *PLACES[n][2:]) for n in range(len(PLACES)))  # counts its lines

# (name, content, what opens it: None for nothing)
FILES = (
    ("top.dat", OPENDTECT, TEXT), ("top.csv", OPENDTECT, TEXT), ("top", OPENDTECT, TEXT), ("top.v2", CHARISMA, TEXT),
    ("picks.xyz", picks(), TEXT), ("picks.txt", picks(), TEXT), ("picks.csv", picks(","), TEXT), ("picks", picks(), TEXT),
    ("picks.map", picks(), TEXT), ("named.csv", picks(",", "X,Y,Z\n"), TEXT), ("picks.horizon", picks("\t"), TEXT),
    ("lines.csv", picks(",", "Inline,Crossline,TWT\n", (1, 0, 4)), TEXT), ("picks.txt.gz", picks(), TEXT),
    ("irap.txt", IRAP, GRID), ("irap", IRAP, GRID), ("irap.csv", IRAP, GRID), ("irap.map", IRAP, GRID),
    ("zmap.txt", ZMAP, GRID), ("zmap.dat", ZMAP, GRID), ("esri.txt", ESRI, GRID), ("esri.grd", ESRI, GRID),
    ("mesh.txt", TSURF, MESH), ("mesh", TSURF, MESH), ("mesh.dat", TSURF, MESH), ("mesh.ts", TSURF, MESH),
    ("faults.txt", PLINE, LINES), ("faults", PLINE, LINES), ("faults.dat", IRAP_LINES, LINES), ("faults.ts", PLINE, LINES),
    ("faults.csv", IRAP_LINES, LINES), ("sticks.csv", sticks("Fault name,Stick,X,Y,Z", "F{0},{0},{1},{2},{3}"), LINES),
    ("northing.csv", sticks("Northing,Easting,TWT,Fault", "{2},{1},{3},F{0}"), LINES),
    ("sticks.txt", sticks("", "{1}\t{2}\t{3}\t{0}\t{4}"), LINES), ("numbers.txt", sticks("", "{1} {2} {3} {0}"), LINES),
    ("named.txt", sticks("", "{1} {2} {3} F1 {0}"), LINES),
    ("tops.csv", "Well,X,Y,Z,Surface\nW1,1.5,7,900,Top\nW1,1.5,7,950,Base\nW2,40,3.25,910,Top\n", TABLE), ("ended.dat", picks() + "999.0 999.0 999.0\n", TEXT),
    ("ended.txt", picks() + "999.0 999.0 999.0\n", TEXT),
    ("voxels.txt", MATRIX, VOXELS), ("voxels", MATRIX, VOXELS), ("voxels.csv", MATRIX, VOXELS), ("voxels.vsm", MATRIX, VOXELS),
    # What the reader refuses comes to it only where no other reader wants it: it says what to do.
    ("doubt.dat", DOUBT, TEXT), ("doubt", DOUBT, TEXT), ("doubt.txt", DOUBT, TABLE), ("scatter.dat", SCATTER, TEXT),
    ("scatter", SCATTER, TEXT), ("scatter.txt", SCATTER, TABLE), ("utf16.dat", picks().encode("utf-16"), TEXT),
    # Tables of others.
    ("particles.csv", PARTICLES, TABLE), ("volume.csv", VOLUME, TABLE), ("series.csv", SERIES, TABLE),
    ("series.txt", SERIES, TABLE), ("field.csv", FIELD, TABLE), ("sizes.txt", SIZES, TABLE), ("note.txt", NOTE, TABLE),
    ("tecplot.dat", TECPLOT, "TecplotReader"), ("molecule.xyz", MOLECULE, "PLOT3DReader"),
    ("note", NOTE, None), ("nothing", "", None), ("note.horizon", NOTE, None),
)
# What ParaView writes of a plane, whose points are on a lattice, and reads.
WRITTEN = (("ascii.vtk", "LegacyVTKReader", {"FileType": "Ascii"}), ("binary.vtk", "LegacyVTKReader", {"FileType": "Binary"}),
           ("plane.vtp", "XMLPolyDataReader", {}), ("ascii.ply", "PLYReader", {"FileType": "Ascii"}),
           ("plane.csv", TABLE, {}), ("ascii.stl", "STLReader", {"FileType": "Ascii"}), ("binary.stl", "STLReader", {}))


def write(path, content):
    data = content if isinstance(content, bytes) else content.encode()
    path.write_bytes(gzip.compress(data) if path.suffix == ".gz" else data)
    return path


def opened_by(path):
    """The name of what OpenDataFile makes of a file; None where there is none."""
    try:
        reader = simple.OpenDataFile(str(path))
    except RuntimeError:
        return None
    name = type(reader).__name__
    simple.Delete(reader)
    return name


def all_readers(path):
    """The names of all readers that ParaView offers for a file, in their order."""
    factory = servermanager.vtkSMProxyManager.GetProxyManager().GetReaderFactory()
    found = factory.GetReaders(str(path), servermanager.ActiveConnection.Session)
    return [found.GetString(n + 1) for n in range(0, found.GetNumberOfStrings(), 3)]


def binary_files(generator, folder):
    """Cubes, pictures, and what looks like a cube at the bytes that say so."""
    cube = folder / "cube.sgy"
    subprocess.run([generator, "--size", "6", "5", "40", "--throw", "0", str(cube)], check=True, stdout=subprocess.PIPE)
    content = cube.read_bytes()
    noise = bytes((n * n * 7 + n // 3) % 256 for n in range(3200)) + content[3200:]
    picture = folder / "picture.png"
    image = vtkImageData()
    image.SetDimensions(70, 70, 1)
    image.AllocateScalars(VTK_UNSIGNED_CHAR, 1)
    writer = vtkPNGWriter()
    writer.SetFileName(str(picture))
    writer.SetInputDataObject(image)
    writer.Write()
    raw = folder / "samples.raw"
    raw.write_bytes(noise)
    return [(cube, CUBE), *((write(folder / name, content), CUBE) for name in ("cube.dat", "cube", "cube.SEGY", "cube.txt", "cube.bin")),
            (raw, "ImageReader"), (write(folder / "noise", noise), None), (write(folder / "part.dat", content[:-7]), "TecplotReader"),
            (picture, "GDALRasterReader" if simple.GetParaViewVersion().major < 6 else "PNGSeriesReader")]


def check_states():
    """States of earlier versions have proxies of other names, which only ask no file whether they read it."""
    manager = servermanager.ProxyManager()
    for name in ("HorizonTextReader", "HorizonGridReader", "SEGYCubeReader", "GOCADTSurfReader", "FaultLinesReader",
                 "VerneySparseMatrixReader"):
        old, new = (manager.NewProxy("sources", before + name) for before in ("", "ByContent"))
        hints = [[proxy.GetHints().GetNestedElement(n).GetName() for n in range(proxy.GetHints().GetNumberOfNestedElements())]
                 for proxy in (old, new)]
        assert hints[0] == [hint for hint in hints[1] if hint != "ReaderFactory"] != hints[1], (name, hints)
        assert old.GetVTKClassName() == new.GetVTKClassName() == "vtk" + name
        assert old.GetXMLLabel() == new.GetXMLLabel()


def main():
    generator, folder = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    cases = [(write(folder / name, content), expected) for name, content, expected in FILES]
    cases += binary_files(generator, folder)
    check_states()
    plane = simple.Plane(XResolution=9, YResolution=7)
    for name, expected, options in WRITTEN:
        simple.SaveData(str(folder / name), proxy=plane, **options)
        cases.append((folder / name, expected))
    wrong = [(path.name, found, expected) for path, expected in cases for found in [opened_by(path)] if found != expected]
    for name, found, expected in wrong:
        print("%s: opened by %s, expected %s" % (name, found, expected))
    assert not wrong
    # Of ours there is no choice between two, but where surfaces may come behind the lines.
    for path, _ in cases:
        ours = [name for name in all_readers(path) if name.startswith("ByContent")]
        assert len(ours) <= (2 if path.name == "faults.ts" else 1), (path.name, ours)


main()
