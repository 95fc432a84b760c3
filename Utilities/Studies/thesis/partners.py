# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes of the same surface with the same number of vertices by other methods: our decimation, MeshLab's merging of close
vertices, to which the thesis compares, and filters of VTK. All except the decimation and vtkDelaunay2D take the mesh of all
points, whose time is not counted."""

from . import stages
from .meshlab import MeshLab, is_installed
from .peers import Peer, binned_decimation, decimate_pro, delaunay, quadric_clustering, quadric_decimation
from .terrain import Terrain

MOST_SECONDS = 5.0  # a method expected to take longer on a surface skips it
GROWTH = 1.3  # exponent of time by points, from the previous surface
OUTLINE_TOLERANCE = 0.5  # outline tolerance of our decimation
MOST_TRIALS = 4  # trials to match the number of vertices
NEAR_ENOUGH = 0.03

# Initial guesses, found by trial: merging distance per cell size, triangles per triangle of ours, and triangles of a whole
# image per triangle inside the outline.
MERGE_PER_CELL = 0.95
PRO_PER_TRIANGLE = 0.6
TERRAIN_PER_TRIANGLE = 1.5
TERRAIN_POWER = 0.8

MERGE = "MeshLab Merge Close Vertices"
DECIMATION = "our decimation"


def match(work, parameter, correct, target):
    """Returns the run of `work` whose number of vertices is closest to the target. `correct` improves a parameter from the
    resulting number of vertices."""
    best = None
    for _ in range(MOST_TRIALS):
        peer = work(parameter)
        if peer is None or peer.vertices == 0:
            break
        if best is None or abs(peer.vertices - target) < abs(best.vertices - target):
            best = peer
        if abs(peer.vertices - target) <= NEAR_ENOUGH * target:
            break
        parameter = correct(parameter, peer.vertices)
    return best


class Partners:
    """All methods for one surface. `pace` is passed from one surface to the next and records which methods are too slow."""

    def __init__(self, full, outlined, folder, pace):
        self.full = stages.triangles_only(full)
        self.outlined = outlined
        self.terrain = Terrain(self.full)
        self.meshlab = MeshLab(self.full, folder) if is_installed() else None
        self.pace = pace

    def with_vertices(self, ours):
        """Returns meshes with the same number of vertices as ours, by name."""
        target = ours.points
        cell = (self.full.GetNumberOfPoints() / target) ** 0.5
        triangles = ours.triangles

        def by_power(work, first, power):
            return match(work, first, lambda size, vertices: size * (target / vertices) ** power, target)

        def by_difference(work):
            """One more vertex gives two more triangles."""
            return match(work, triangles, lambda number, vertices: number + 2 * (target - vertices), target)

        works = {
            DECIMATION: lambda: self.decimate(target),
            MERGE: lambda: by_power(self.merge, MERGE_PER_CELL * cell, -0.5),
            "vtkQuadricClustering": lambda: by_power(lambda size: quadric_clustering(self.full, size), cell, -0.5),
            "vtkBinnedDecimation": lambda: by_power(lambda size: binned_decimation(self.full, size), cell, -0.5),
            "vtkDecimatePro": lambda: by_power(lambda number: decimate_pro(self.full, number),
                                               PRO_PER_TRIANGLE * triangles, 1.0),
            "vtkQuadricDecimation": lambda: by_difference(lambda number: quadric_decimation(self.full, number)),
            "vtkGreedyTerrainDecimation": lambda: by_power(self.terrain.decimate, TERRAIN_PER_TRIANGLE * triangles,
                                                           TERRAIN_POWER),
            "vtkDelaunay2D of our points": lambda: delaunay(stages.triangles_only(ours.data))}
        found = {}
        for name, work in works.items():
            result = self.pace.allow(name, self.full.GetNumberOfPoints()) and work()
            if result:
                self.pace.note(name, self.full.GetNumberOfPoints(), result.seconds)
                found[name] = result
        return found

    def series(self, ours):
        """Returns meshes with about as many vertices as each of ours, by name."""
        cells = [(self.full.GetNumberOfPoints() / mesh.points) ** 0.5 for mesh in ours]
        triangles = [mesh.triangles for mesh in ours]
        runs = {
            DECIMATION: [self.decimate(mesh.points) for mesh in ours],
            MERGE: [self.merge(MERGE_PER_CELL * cell) for cell in cells],
            "vtkQuadricClustering": [quadric_clustering(self.full, cell) for cell in cells],
            "vtkBinnedDecimation": [binned_decimation(self.full, cell) for cell in cells],
            "vtkDecimatePro": [decimate_pro(self.full, PRO_PER_TRIANGLE * n) for n in triangles],
            "vtkQuadricDecimation": [quadric_decimation(self.full, n) for n in triangles],
            "vtkGreedyTerrainDecimation": [self.terrain.decimate(TERRAIN_PER_TRIANGLE * n) for n in triangles]}
        return {name: results for name, results in runs.items() if all(results)}

    def decimate(self, points):
        """Returns our decimation; it keeps at least the fewest outline points within half a column."""
        straight = stages.fewest_outline_points(self.outlined, OUTLINE_TOLERANCE)
        result = stages.decimate(straight, max(points, stages.outline_points(straight.data)))
        return Peer(stages.triangles_only(result.data), result.seconds)

    def merge(self, distance):
        if not self.meshlab:
            return None
        mesh, seconds = self.meshlab.merge(distance)
        return mesh and Peer(mesh, seconds)


class Pace:
    """Records the time of each method, and decides which surfaces it skips."""

    def __init__(self, most_seconds=MOST_SECONDS):
        self.most_seconds = most_seconds
        self.last = {}
        self.left_out = {}

    def allow(self, name, points):
        before = self.last.get(name)
        fits = before is None or before[1] * (points / before[0]) ** GROWTH <= self.most_seconds
        if not fits:
            self.left_out.setdefault(name, set()).add(points)
        return fits

    def note(self, name, points, seconds):
        self.last[name] = (points, seconds)
