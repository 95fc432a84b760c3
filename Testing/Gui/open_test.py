# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""File > Open and Apply in the window: files of all formats find their readers, and are shown; a group of numbered files
is a series, one for each time.

Arguments: ParaView, the generator of cubes, the folder of the data, and one for files.
"""

import gzip
import pathlib
import subprocess
import sys

import window



def picks(z):
    return "".join("%.1f %.1f %d\n" % (100.5 + 25 * i, 200.5 + 25 * j, z + i * j) for j in range(6) for i in range(5))


IRAP = "-996 2 25.0 25.0\n0 50 0 25\n3 0.0 0.0 0.0\n0 0 0 0 0 0 0\n1 2 3 4 5 6\n"
TSURF = "GOCAD TSurf 1\nHEADER {\nname:Top\n}\nTFACE\nVRTX 1 0 0 0\nVRTX 2 1 0 0\nVRTX 3 0 1 0\nTRGL 1 2 3\nEND\n"
FAULT = "20.5 -9.0 0\n20.5 900.0 0\n999.0 999.0 999.0\n"

# name: (text, reader, points, whether other readers of ParaView offer themselves)
TEXTS = {
    "picks.xyz": (picks(1000), "HorizonTextReader", 30, True),
    "map.irap": (IRAP, "HorizonGridReader", 6, False),
    "top.ts": (TSURF, "GOCADTSurfReader", 3, False),
    "fault.pol": (FAULT, "FaultLinesReader", 2, False),
    # By what is in them: under names of other files, whose readers are below ours in the list, or under none.
    "picks.csv": (picks(1000).replace(" ", ","), "HorizonTextReader", 30, True),
    "picks.txt": (picks(1000), "HorizonTextReader", 30, True),
    "picks": (picks(1000), "HorizonTextReader", 30, False),
    "map.txt": (IRAP, "HorizonGridReader", 6, True),
    "map.horizon": (IRAP, "HorizonGridReader", 6, False),
    "top.dat": (TSURF, "GOCADTSurfReader", 3, True),
    "fault.txt": (2 * FAULT, "FaultLinesReader", 4, True),
    # A table of others.
    "table.txt": ("day,heat\n1,3\n2,5\n3,4\n", "CSVReader", 0, False),
}
CUBE = (6, 5, 40)  # crosslines, inlines and samples
LAST_FRAME = window.WINDOW + "/VCRToolbar/actionVCRLastFrame"


def open_series(events, folder):
    """A group of files, under the name that the dialog gives to numbered ones."""
    for time in range(3):
        (folder / ("top_%d.xyz" % time)).write_text(picks(1000 + 100 * time), encoding="utf-8")
    events.open(folder / "top_..xyz", several_readers=True)
    events.apply()
    events.macro("Note")
    events.add(LAST_FRAME, "activate")
    events.macro("Note")


def check_series(first, last):
    """Depths are at most 1020 in the first file, and at least 1200 in the last."""
    for note, low, high in ((first, -1020, -1000), (last, -1220, -1200)):
        assert note["name"] == "HorizonTextReader" and note["points"] == 30, note
        assert note["bounds"][4:] == [low, high], note


def main():
    paraview, generator, data, folder = sys.argv[1:5]
    folder = window.new_folder(folder)
    sample = pathlib.Path(data).resolve() / "blobs.vsm"
    compressed = folder / "blobs.vsm.gz"
    compressed.write_bytes(gzip.compress(sample.read_bytes()))
    cube = folder / "cube.sgy"
    subprocess.run([generator, "--size", *map(str, CUBE), "--throw", "0", cube], check=True, stdout=subprocess.PIPE)
    files = [(sample, "VerneySparseMatrixReader", None, False), (compressed, "VerneySparseMatrixReader", None, False),
             (cube, "SEGYCubeReader", CUBE[0] * CUBE[1] * CUBE[2], True)]
    for name, (text, *expected) in TEXTS.items():
        (folder / name).write_text(text, encoding="utf-8")
        files.append((folder / name, *expected))

    events = window.Events()
    for path, _, _, several in files:
        events.open(path, several)
        events.apply()
        events.macro("Note")
    open_series(events, folder)
    notes = window.play(paraview, events, folder)
    check_series(*notes[len(files):])
    for (path, reader, points, _), note in zip(files, notes):
        assert note["name"] == reader, (path.name, note)
        assert note["points"] == points or (points is None and note["points"] > 1000), (path.name, note)
        assert note["shown"], (path.name, note)
        assert points == 0 or any(low < high for low, high in zip(note["bounds"][::2], note["bounds"][1::2])), (path.name, note)
    assert notes[1]["points"] == notes[0]["points"], notes[:2]


main()
