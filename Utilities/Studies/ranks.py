# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the time of several processes for horizons: reading, Horizon Surface and Horizon Surface Distance.

    python3 ranks.py mixed.vsm --ranks 1 2 4 --pvbatch pvbatch

For each number of processes, each piece runs alone, one after the other, and its processor time is measured, because
processes that wait in MPI also use the processor. Then all pieces run at once by mpirun, and wall-clock time is measured.
Prints a table for a page.
"""

import argparse
import json
import resource
import subprocess
import sys
import time

import seismichorizons.vtk as sh
from vtkmodules.vtkParallelCore import vtkMultiProcessController


def processor_time():
    usage = resource.getrusage(resource.RUSAGE_SELF)
    return usage.ru_utime + usage.ru_stime


def run(path, piece, pieces, clock):
    """Returns the seconds of each step for a piece, and the number of points of each of its horizons."""
    reader, surface, distance = (getattr(sh, "vtk" + name)() for name in (
        "VerneySparseMatrixReader", "HorizonSurface", "HorizonSurfaceDistance"))
    reader.SetFileName(path)
    surface.SetInputConnection(reader.GetOutputPort())
    surface.SetMaximumError(1.0)
    distance.SetInputConnection(0, reader.GetOutputPort())
    distance.SetInputConnection(1, surface.GetOutputPort())
    seconds = []
    for stage in (reader, surface, distance):
        start = clock()
        stage.UpdatePiece(piece, pieces, 0)
        seconds.append(clock() - start)
    horizons = reader.GetOutputDataObject(0)
    sizes = [horizons.GetPartition(n, 0).GetNumberOfPoints() for n in range(horizons.GetNumberOfPartitionedDataSets())
             if horizons.GetNumberOfPartitions(n)]
    if not horizons.GetNumberOfPartitionedDataSets():
        sys.exit("ranks: %s cannot be read" % path)
    return {"seconds": seconds, "sizes": sizes}


def call(command):
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]


def measure(path, ranks, pvbatch):
    """Returns the results of the pieces, and the wall-clock seconds of all pieces at once."""
    pieces = [call([sys.executable, __file__, path, "--piece", str(piece), str(ranks)])[0] for piece in range(ranks)]
    together = call(["mpirun", "-np", str(ranks), pvbatch, "--symmetric", __file__, path, "--together"])
    return pieces, max(sum(result["seconds"]) for result in together)


def row(ranks, pieces, wall, first_wall):
    points = [sum(piece["sizes"]) for piece in pieces]
    most = max(points)
    work = [sum(piece["seconds"][1:]) for piece in pieces]
    reading = [piece["seconds"][0] for piece in pieces]
    return "| %d | %d | %d (%.1f %%) | %.1f | %.1f | %.1f | %.1f | %.2f |" % (
        ranks, max(len(piece["sizes"]) for piece in pieces), most, 100.0 * most / sum(points), max(reading), max(work),
        sum(reading) + sum(work), wall, first_wall / wall)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file", metavar="FILE.vsm")
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2, 4])
    parser.add_argument("--pvbatch", default="pvbatch")
    parser.add_argument("--piece", type=int, nargs=2, help=argparse.SUPPRESS)
    parser.add_argument("--together", action="store_true", help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.piece:
        print(json.dumps(run(arguments.file, *arguments.piece, processor_time)))
        return
    if arguments.together:
        controller = vtkMultiProcessController.GetGlobalController()
        own, size = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
        controller.Barrier()
        # A single write per process keeps their lines apart.
        sys.stdout.write(json.dumps(run(arguments.file, own, size, time.monotonic)) + "\n")
        sys.stdout.flush()
        return
    print("| processes | horizons, at most | points, at most | CPU s to read, at most | CPU s to mesh and measure, at most "
          "| CPU s in all | s on the clock | speed-up |")
    print("|" + " --- |" * 8)
    first_wall = None
    for ranks in arguments.ranks:
        pieces, wall = measure(arguments.file, ranks, arguments.pvbatch)
        first_wall = first_wall or wall
        print(row(ranks, pieces, wall, first_wall), flush=True)
        if ranks == 1:
            sizes = pieces[0]["sizes"]
            print("%d horizons, %d points, the largest has %d (%.1f %%)" % (
                len(sizes), sum(sizes), max(sizes), 100.0 * max(sizes) / sum(sizes)), file=sys.stderr, flush=True)


main()
