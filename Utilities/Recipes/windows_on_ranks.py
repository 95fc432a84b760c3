# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes one mesh of one huge horizon of a .vsm file; each MPI process reads and meshes windows of rows.

    mpirun -np 4 pvbatch --symmetric windows_on_ranks.py survey.vsm mesh.vtp --horizon "Horizon 1" --largest-error 1

The windows depend only on --window-points, and so does the mesh, byte by byte; the number of processes has no effect. The
first process joins the windows and writes the mesh. PYTHONPATH must contain the package seismichorizons.
"""

import argparse
import pathlib
import pickle
import sys

import numpy as np
from seismichorizons import _core
from seismichorizons_command import core, parts, reading
from seismichorizons_command.core import HorizonError
from seismichorizons_command.data import count_points, count_polygons
from seismichorizons_command.writing import write_data
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIntArray, vtkUnsignedCharArray
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

RANKS = vtkMultiProcessController.GetGlobalController()
OWN, SIZE = RANKS.GetLocalProcessId(), RANKS.GetNumberOfProcesses()
MESH = 5012  # MPI tag of messages with meshes


class WindowSize:
    """The largest number of points in a window, used in place of a memory budget."""

    def __init__(self, points):
        self._points = points

    def most_points(self):
        return self._points

    def limit_text(self):
        return "--window-points %d" % self._points


def largest_of_all(value):
    """Returns the largest value of all processes to each of them."""
    own, largest = vtkIntArray(), vtkIntArray()
    for array in (own, largest):
        array.InsertNextValue(value)
    RANKS.AllReduce(own, largest, vtkCommunicator.MAX_OP)
    return largest.GetValue(0)


def together(work):
    """Returns the result of work() on this process. Raises SystemExit on all processes if work() raises HorizonError on
    any."""
    result, problem = None, None
    try:
        result = work()
    except HorizonError as error:
        problem = "windows_on_ranks: %s" % error
    # Only the first process with a problem reports it, because all may have the same problem.
    first = SIZE - largest_of_all(SIZE - OWN if problem else 0)
    if first < SIZE:
        if first == OWN:
            print(problem, file=sys.stderr, flush=True)
        raise SystemExit(1)
    return result


def open_windows(path, name, window_points):
    """Returns the windows of the named horizon, or of the largest one. Raises HorizonError."""
    source = reading.SparseSource(path, True, {})  # the overview lets it read some rows alone
    source.list()
    sizes = dict(zip(source.names, source.sizes))
    name = name or max(sizes, key=sizes.get, default="")
    if name not in sizes:
        raise HorizonError("%s: no horizon %r, expected one of %s" % (path, name, ", ".join(sizes)))
    return parts.Windows(source, source.names.index(name), WindowSize(window_points))


def mesh_own(windows, properties):
    """Returns the meshes of this process: every SIZE-th window, because windows have about the same number of points."""
    return {number: parts.mesh_window(windows, number, properties)
            for number in range(OWN, len(windows.rows), SIZE)}


def send(mesh):
    RANKS.Send(numpy_to_vtk(np.frombuffer(pickle.dumps(mesh), np.uint8)), 0, MESH)


def receive(rank):
    message = vtkUnsignedCharArray()
    RANKS.Receive(message, rank, MESH)
    return pickle.loads(vtk_to_numpy(message))


def gather(meshes, count):
    """Returns the meshes of all windows in order on the first process, and nothing on the others."""
    gathered = []
    for number in range(count):
        rank = number % SIZE
        if OWN == 0:
            gathered.append(meshes[number] if rank == 0 else receive(rank))
        elif OWN == rank:
            send(meshes.pop(number))
    return gathered


def join(meshes, path):
    mesh = meshes[0] if len(meshes) == 1 else core.run(_core.join, meshes, 1)
    write_data(mesh, path, path.stem)
    print("%d windows, %d points, %d triangles" % (len(meshes), count_points(mesh), count_polygons(mesh)))


def make_parser():
    parser = argparse.ArgumentParser(prog="windows_on_ranks", description=__doc__.splitlines()[0])
    parser.add_argument("file", metavar="FILE.vsm", help="the horizons, on a disk that all processes see")
    parser.add_argument("mesh", metavar="MESH.vtp", help="the mesh to write")
    parser.add_argument("--horizon", metavar="NAME", help='such as "Horizon 1" (default: the one with the most points)')
    parser.add_argument("--largest-error", metavar="E", type=float, default=1.0, help="as MaximumError of Horizon Surface")
    parser.add_argument("--window-points", metavar="N", type=int, default=2000000, help="points of a window, at most")
    return parser


def main():
    arguments = make_parser().parse_args()
    windows = together(lambda: open_windows(arguments.file, arguments.horizon, arguments.window_points))
    # The radius of the largest window is used for all windows.
    is_chooser = OWN == windows.largest() % SIZE
    error = {"MaximumError": arguments.largest_error}
    radius = largest_of_all(together(lambda: windows.choose(error)["Radius"] if is_chooser else 0))
    properties = {**error, "Radius": radius}
    meshes = gather(together(lambda: mesh_own(windows, properties)), len(windows.rows))
    together(lambda: join(meshes, pathlib.Path(arguments.mesh)) if OWN == 0 else None)


main()
