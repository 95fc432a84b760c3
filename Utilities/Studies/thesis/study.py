# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""All measurements: one object for each surface, and one for each row of table 5.1."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from . import partners, peers, reported, stages, surfaces
from .meshlab import is_installed
from .worth import Worth

RADII = range(1, 9)
GROWTH_RULES = ("Clockwise", "Distance")
THRESHOLDS = (0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0)
CURVE_CELLS = (12, 8, 6, 4, 3)
CURVE_FLATNESS = (0.03, 0.01, 0.003)
CURVE_GROWTH = 1.5
MOST_SECONDS_TO_MESH = 15.0  # limit for other programs that mesh all points

OURS = "ours"


class Measured:
    """Points left by a simplification, its seconds, and the quality of a mesh of them."""

    def __init__(self, points, seconds, worth):
        self.points = points
        self.seconds = seconds
        self.worth = worth


class Surface:
    """All results for one surface of table 4.1."""

    def __init__(self, generator, size, folder, pace):
        self.size = size
        horizon, self.noise = surfaces.make(generator, size, folder)
        self.points = horizon.GetNumberOfPoints()
        self.box = surfaces.size_of_box(horizon)
        self._measured = []
        self.outlined = stages.outline(stages.start(horizon))
        self.full = stages.mesh(self.outlined)
        self.straight = stages.straighten(self.outlined)
        self.outline = stages.outline_points(self.outlined.data)
        self.boundary = stages.outline_points(self.straight.data)
        self.partners = partners.Partners(self.full.data, self.outlined, folder, pace)
        self._boundary_curves(horizon)
        self._our_tables()
        self._cluster_method()
        self.equal = {name: self._with_vertices(ours) for name, ours in (
            ("rough, s = 6", stages.rough(self.straight, 6)),
            ("elaborate, s = 8, flatness 0.03", stages.elaborate(self.straight, 8, 0.03)))}

    def forget(self):
        """Releases all large data."""
        del self.outlined, self.full, self.straight, self.partners, self._measured

    def _boundary_curves(self, horizon):
        self.boundary_seconds = {
            rule: [(k, stages.outline(stages.start(horizon), Radius=k, GrowthStrategy=rule).seconds) for k in RADII]
            for rule in GROWTH_RULES}
        self.boundary_rates = [
            (t, 100.0 * (1.0 - stages.outline_points(stages.straighten(self.outlined, t).data) / self.outline))
            for t in THRESHOLDS]

    def _our_tables(self):
        start = stages.Result(self.straight.data, 0.0)  # times in the tables cover the simplification alone
        rough = {size: stages.rough(start, size) for size in (3, 6, 8)}
        self.rough = {size: self._measure(result) for size, result in rough.items()}
        self.alone = [self._measure(stages.elaborate(start, 8, flatness)) for flatness in reported.FLATNESS]
        self.after = [self._measure(stages.elaborate(rough[3], 8, flatness)) for flatness in reported.FLATNESS]
        self.both = {size: [self._measure(stages.elaborate(rough[size], 10, flatness))
                            for flatness in reported.FLATNESS] for size in (3, 6, 8)}

    def _cluster_method(self):
        self.cluster = {}
        for distance in (6, 8):
            peer = self.partners.merge(distance)
            if peer:
                self.cluster[distance] = self._measure_peer(peer)

    def _measure(self, simplified):
        return Measured(simplified.points, simplified.seconds, self._worth(stages.mesh(simplified).data))

    def _worth(self, mesh):
        """Different flatness values may give the same mesh, which is then measured once."""
        places = vtk_to_numpy(mesh.GetPoints().GetData())
        for known, worth in self._measured:
            if np.array_equal(known, places):
                return worth
        worth = Worth(self.full.data, mesh)
        self._measured.append((places, worth))
        return worth

    def _measure_peer(self, peer):
        return Measured(peer.vertices, peer.seconds, Worth(self.full.data, peer.mesh))

    def _with_vertices(self, simplified):
        """Returns the meshes of all methods with the same number of vertices, by name, without methods that are too slow.
        Our seconds cover the time from points to mesh."""
        mesh = stages.mesh(simplified)
        found = {OURS: Measured(simplified.points, mesh.seconds, self._worth(mesh.data))}
        for name, peer in self.partners.with_vertices(mesh).items():
            found[name] = self._measure_peer(peer)
        return found

    def curves(self):
        """Returns results of several sizes for each method, by name."""
        rough = {size: stages.rough(self.straight, size) for size in CURVE_CELLS}
        ours = {
            "rough": rough.values(),
            "elaborate": [stages.elaborate(self.straight, 8, flatness) for flatness in CURVE_FLATNESS],
            "elaborate, growing %g" % CURVE_GROWTH: [
                stages.elaborate(self.straight, 8, flatness, CURVE_GROWTH) for flatness in CURVE_FLATNESS],
            "rough and elaborate": [stages.elaborate(rough[size], 10, 0.03) for size in (8, 6, 3)]}
        found = {name: [Worth(self.full.data, stages.mesh(r).data) for r in results] for name, results in ours.items()}
        for name, results in self.partners.series([stages.mesh(r) for r in rough.values()]).items():
            found[name] = [Worth(self.full.data, peer.mesh) for peer in results]
        return found


class Meshing:
    """A row of table 5.1: all points of a surface meshed. Our time includes the exterior boundary."""

    def __init__(self, generator, size, folder, pace):
        self.size = size
        horizon, _ = surfaces.make(generator, size, folder)
        self.points = horizon.GetNumberOfPoints()
        outlined = stages.outline(stages.start(horizon))
        stages.mesh(outlined)  # warms up memory, which only the first strategy would pay for
        self.seconds = {}
        self.faces = {}
        for name, strategy in (("VTS", "VoxelTraversal"), ("CTC", "Compactness")):
            result = stages.mesh(outlined, strategy)
            self._note(name, result.triangles, result.seconds)
        self._others(result.data, folder, pace)

    def _others(self, mesh, folder, pace):
        bare = stages.triangles_only(mesh)
        works = {"vtkDelaunay2D": lambda: peers.delaunay(bare)}
        if is_installed():
            works["BP"] = lambda: peers.ball_pivoting(bare, folder)
        for name, work in works.items():
            peer = pace.allow(name, self.points) and work()
            if peer:
                pace.note(name, self.points, peer.seconds)
                self._note(name, peer.mesh.GetNumberOfPolys(), peer.seconds)

    def _note(self, name, faces, seconds):
        self.faces[name] = faces
        self.seconds[name] = seconds


def meshing_pace():
    return partners.Pace(MOST_SECONDS_TO_MESH)
