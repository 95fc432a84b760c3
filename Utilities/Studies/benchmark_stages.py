# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The part of benchmark.py that runs in a process of its own; prints JSON.

    benchmark_stages.py stages FILE.vsm THREADS NEEDS     all stages; NEEDS: known bytes per point by stage
    benchmark_stages.py peers FILE.vsm THREADS SLOW       filters of VTK except those named in SLOW
"""

import ctypes
import gc
import json
import pathlib
import sys
import tempfile
import time

import numpy as np
from seismichorizons.vtk import make
from vtkmodules.vtkFiltersCore import vtkDecimatePro, vtkDelaunay2D
from vtkmodules.vtkFiltersGeneral import vtkTableToPolyData
from vtkmodules.vtkIOInfovis import vtkDelimitedTextReader

from thesis import peers, stages
from thesis.worth import arrays_of

CELL_SIZE = 3  # of the rough simplification
LARGE_CELL_SIZE = 8  # of the elaborate simplification
FLATNESS = 0.03
MOST_RUNS = 5
ENOUGH_SECONDS = 1.0
MEMORY_LEFT = 0.8  # fraction of the free memory that a stage may use
WHOLE_CHAIN = "whole chain"
FILE_TO_MESH = "file to mesh"
FROM_FILE = (WHOLE_CHAIN, FILE_TO_MESH)  # last rows of the table


def memory(name, path="/proc/self/status"):
    """Returns a memory figure of Linux in bytes."""
    with open(path, encoding="ascii") as file:
        for line in file:
            if line.startswith(name + ":"):
                return 1024 * int(line.split()[1])
    raise SystemExit("%s has no line %s" % (path, name))


def start_peak():
    """Resets the memory peak, after freed memory is returned to the system, which would otherwise hide new allocations."""
    gc.collect()
    ctypes.CDLL(None).malloc_trim(0)
    pathlib.Path("/proc/self/clear_refs").write_text("5", encoding="ascii")
    return memory("VmRSS")


def measure(work, points):
    """Measures the memory of the first run and the seconds of the fastest run."""
    seconds = []
    before = start_peak()
    while not seconds or (len(seconds) < MOST_RUNS and sum(seconds) < ENOUGH_SECONDS):
        start = time.perf_counter()
        work()
        seconds.append(time.perf_counter() - start)
        if len(seconds) == 1:
            grown = memory("VmHWM") - before
    return {"points": points, "seconds": min(seconds), "points_per_second": points / min(seconds),
            "bytes_per_point": grown / points}


class Chain:
    """Runs filters one after the other and records their time and memory."""

    def __init__(self, needs):
        self.needs = needs
        self.results = []

    def has_memory(self, stage, points):
        return self.needs.get(stage, 0.0) * points <= MEMORY_LEFT * memory("MemAvailable", "/proc/meminfo")

    def run(self, stage, algorithm, points=None, **inputs):
        """Returns the output, or None if there is not enough memory."""
        for port, data in inputs.items():
            algorithm.SetInputDataObject({"data": 0, "mesh": 1}[port], data)
        points = points or inputs["data"].GetNumberOfPoints()
        if not self.has_memory(stage, points):
            return None

        def work():
            algorithm.Modified()
            algorithm.Update()

        self.results.append({"stage": stage, **measure(work, points)})
        return algorithm.GetOutputDataObject(0)


def make_stages():
    """Makes the stages of the whole chain."""
    return [make("vtkHorizonExteriorBoundary"),
            make("vtkHorizonBoundarySimplification", DistanceThreshold=stages.DISTANCE_THRESHOLD),
            make("vtkHorizonRoughSimplification", CellSize=CELL_SIZE),
            make("vtkHorizonTriangulation")]


def measure_stages(path, needs):
    # Chains that begin with the file come first, while nothing else is in memory.
    points = stages.read(path).GetNumberOfPoints()
    chain = Chain(needs)
    measure_chain(chain, path, points)
    measure_surface(chain, path, points)
    horizon = chain.run("read", make("vtkVerneySparseMatrixReader", FileName=path), points).GetPartition(0, 0)
    boundary, straighten, rough, triangulation = make_stages()
    outlined = chain.run("boundary", boundary, data=horizon)
    straight = chain.run("boundary simplification", straighten, data=outlined)
    thinned = chain.run("rough", rough, data=straight)
    chain.run("elaborate", make("vtkHorizonElaborateSimplification", CellSize=LARGE_CELL_SIZE,
                                FlatnessThreshold=FLATNESS), data=straight)
    full = chain.run("triangulation, all points", make("vtkHorizonTriangulation"), data=outlined)
    mesh = chain.run("triangulation, after rough", triangulation, data=thinned)
    chain.run("error", make("vtkHorizonSurfaceDistance"), data=full, mesh=mesh)
    from_file = [r for r in chain.results if r["stage"] in FROM_FILE]
    return [r for r in chain.results if r not in from_file] + from_file


def measure_chain(chain, path, points):
    def work():
        data = stages.read(path)
        for stage in make_stages():
            stage.SetInputDataObject(0, data)
            stage.Update()
            data = stage.GetOutputDataObject(0)

    chain.results.append({"stage": WHOLE_CHAIN, **measure(work, points)})


def measure_surface(chain, path, points):
    def work():
        surface = make("vtkHorizonSurface", MaximumError=0.75)
        surface.SetInputDataObject(0, stages.read(path))
        surface.Update()

    if chain.has_memory(FILE_TO_MESH, points):
        chain.results.append({"stage": FILE_TO_MESH, **measure(work, points)})


def write_text(horizon, path):
    np.savetxt(path, arrays_of(horizon)[0], fmt="%d", delimiter=",", header="i,j,k", comments="")


def read_text(path):
    reader = vtkDelimitedTextReader()
    reader.SetFileName(str(path))
    reader.SetHaveHeaders(True)
    reader.SetDetectNumericColumns(True)
    reader.Update()
    return reader.GetOutput()


def chain_of_paraview(path):
    points = vtkTableToPolyData()
    points.SetInputData(read_text(path))
    points.SetXColumn("i")
    points.SetYColumn("j")
    points.SetZColumn("k")
    surface = vtkDelaunay2D()
    surface.SetInputConnection(points.GetOutputPort())
    surface.SetTolerance(0.0)
    fewer = vtkDecimatePro()
    fewer.SetInputConnection(surface.GetOutputPort())
    fewer.SetTargetReduction(0.9)
    fewer.Update()


def measure_peers(path, slow):
    straight = stages.straighten(stages.outline(stages.start(stages.read(path))))
    full = stages.triangles_only(stages.mesh(stages.outline(stages.start(stages.read(path)))).data)
    target = stages.mesh(stages.rough(straight, CELL_SIZE)).triangles
    with tempfile.TemporaryDirectory() as folder:
        text = pathlib.Path(folder) / "points.csv"
        works = (
            ("read", "vtkDelimitedTextReader", lambda: read_text(text)),
            ("rough", "vtkBinnedDecimation", lambda: peers.binned_decimation(full, CELL_SIZE)),
            ("rough", "vtkQuadricClustering", lambda: peers.quadric_clustering(full, CELL_SIZE)),
            ("elaborate", "vtkQuadricDecimation", lambda: peers.quadric_decimation(full, target)),
            ("triangulation, all points", "vtkDelaunay2D", lambda: peers.delaunay(full)),
            (WHOLE_CHAIN, "ParaView's chain", lambda: chain_of_paraview(text)))
        wanted = [work for work in works if work[1] not in slow]
        if any(stage in ("read", WHOLE_CHAIN) for stage, _, _ in wanted):
            write_text(full, text)
        points = full.GetNumberOfPoints()
        return [{"stage": stage, "peer": name, **measure(work, points)} for stage, name, work in wanted]


def main():
    what, path, threads, given = sys.argv[1:5]
    stages.set_threads(int(threads))
    print(json.dumps({"stages": measure_stages, "peers": measure_peers}[what](path, json.loads(given))))


main()
