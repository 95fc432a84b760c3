# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures and interactive meshes of the horizons in a report. To limit the size of the page, only the horizons with most
points have pictures of their stages, and only the smaller meshes are interactive if there is no room for all. Everything is
kept as bytes, so that no horizon has to stay in memory."""

from dataclasses import dataclass, field
from typing import Optional

import numpy as np

from . import data, triangles

MOST_PICTURED = 12  # horizons with pictures of their stages
PICTURE_BYTES = 8 << 20  # of all these pictures together
MOST_THUMBNAILS = 500
MESH_BYTES = 16 << 20  # of all interactive meshes together
PICTURE_SIZE = (600, 420)
THUMBNAIL_SIZE = (208, 136)


@dataclass
class Picture:
    """A picture with its title and caption; for a map of errors or thickness, `scale_ends` holds the values of the first
    and last colour."""

    title: str
    caption: str
    jpeg: bytes
    scale_ends: Optional[tuple] = None


@dataclass
class Mesh:
    """An interactive mesh. `content` concatenates the points relative to `center` (3 float32 each), one error for each
    element of `error_on` (float32; "triangles", "points", or None without errors), and three point numbers for each
    triangle (uint16, or uint32 beyond 65536 points): first the `triangles` of the surface, which have the errors, then the
    `fault_triangles` that close faults."""

    center: list
    points: int
    triangles: int
    fault_triangles: int
    error_on: Optional[str]
    farthest: float
    content: bytes


@dataclass
class Entry:
    """Pictures and mesh of one horizon; `exaggeration` is the vertical exaggeration of its pictures."""

    points: int
    thumbnail: Optional[bytes] = None
    pictures: list = field(default_factory=list)
    exaggeration: float = 1.0
    mesh: Optional[Mesh] = None


@dataclass
class LayerEntry:
    """The layers of a file: a picture of all, a map of each, and interactive `bodies` by name."""

    pictures: list = field(default_factory=list)
    bodies: dict = field(default_factory=dict)


class Album:
    """The entries of all horizons in order. Pictures need an X server. With `is_part`, it has the entries of one file for
    another album, which limits their size."""

    def __init__(self, with_pictures, is_part=False):
        self.with_pictures = with_pictures
        self._is_part = is_part
        self.entries = []
        self.layers = []  # one entry for each file with layers
        self._studio = None

    def add(self, result, rank):
        """Adds a horizon; `rank` is its rank by number of points among the horizons of its file, from 0."""
        entry = Entry(result.number_of_points)
        if triangles.count_surface(result.data["mesh"]):
            entry.mesh = encode(result.data["mesh"])
        if self.with_pictures:
            self._draw(entry, result, rank)
        self._keep(entry)

    def take(self, entries, layers):
        """Adds the entries of a part."""
        for entry in entries:
            self._keep(entry)
        for entry in layers:
            self._keep_layers(entry)

    def _keep(self, entry):
        self.entries.append(entry)
        if self._is_part:
            return
        if sum(e.thumbnail is not None for e in self.entries) > MOST_THUMBNAILS:
            entry.thumbnail = None
        _drop(self.entries, "mesh", None, lambda e: -len(e.mesh.content), lambda e: len(e.mesh.content), MESH_BYTES)
        _drop(self.entries, "pictures", [], lambda e: e.points, lambda e: sum(len(p.jpeg) for p in e.pictures),
              PICTURE_BYTES, MOST_PICTURED)

    def add_layers(self, made):
        """Adds the layers of a file (volumes.Layers): a picture of the separated bodies, and interactive bodies if there is
        room for all."""
        entry = LayerEntry(bodies={name: encode(body) for name, body in made.bodies.items()})
        if self.with_pictures and len(self.layers) < MOST_PICTURED and entry.bodies:
            entry.pictures = [self._draw_bodies(list(made.bodies.values())), *(
                self._draw_thickness(name, plan_of(made.cells, number))
                for number, name in enumerate(made.figures) if number < MOST_PICTURED and name in entry.bodies)]
        self._keep_layers(entry)

    def _keep_layers(self, entry):
        self.layers.append(entry)
        if sum(len(mesh.content) for one in self.layers for mesh in one.bodies.values()) > MESH_BYTES // 2 and not self._is_part:
            entry.bodies = {}
        if len(self.layers) > MOST_PICTURED:
            entry.pictures = []

    def _draw_bodies(self, bodies):
        from . import pictures

        self._studio = self._studio or pictures.Studio()
        panel = pictures.Panel("", "", take_apart(bodies), pictures.BODIES)
        (image,), exaggeration, _ = pictures.draw_each([panel], PICTURE_SIZE, self._studio)
        return Picture("Layers", "taken apart, heights \u00d7 %g" % exaggeration, pictures.as_jpeg(image))

    def _draw_thickness(self, name, plan):
        from . import pictures

        (image,), _, ends = pictures.draw_each([pictures.Panel("", "", plan, pictures.THICKNESS)], PICTURE_SIZE, self._studio)
        return Picture(name, "thickness, seen from above", pictures.as_jpeg(image), ends)

    def cut(self, number):
        """Keeps only the first `number` entries."""
        del self.entries[number:]

    def _draw(self, entry, result, rank):
        # The drawing libraries are loaded only if needed.
        from . import overview, pictures

        self._studio = self._studio or pictures.Studio()
        if rank < MOST_PICTURED:
            panels = overview.panels(result)
            measured = result.data.get("measured")
            if measured is not None and data.count_points(measured):
                panels.append(pictures.Panel("Error", "distance of each point from the mesh", measured, pictures.DISTANCE))
            images, entry.exaggeration, ends = pictures.draw_each(panels, PICTURE_SIZE, self._studio)
            # The first panel of a row has the name of the horizon as its title.
            first = "Points" if panels[0].style == pictures.POINTS else "Mesh"
            entry.pictures = [Picture(panel.title if number else first, panel.caption, pictures.as_jpeg(image),
                                      ends if panel.style == pictures.DISTANCE else None)
                              for number, (panel, image) in enumerate(zip(panels, images))]
        if sum(e.thumbnail is not None for e in self.entries) < MOST_THUMBNAILS:
            panel = pictures.Panel(result.name, "", result.data["mesh"], pictures.MESH)
            (image,), exaggeration, _ = pictures.draw_each([panel], THUMBNAIL_SIZE, self._studio)
            entry.thumbnail = pictures.as_jpeg(image, 80)
            entry.exaggeration = entry.exaggeration if entry.pictures else exaggeration


def _drop(entries, name, nothing, worth, size, most_bytes, most=None):
    """Replaces attribute `name` of the least valuable entries by `nothing` until the rest fits."""
    having = sorted((e for e in entries if getattr(e, name)), key=worth, reverse=True)
    while having and (sum(map(size, having)) > most_bytes or len(having) > (most or len(having))):
        setattr(having.pop(), name, nothing)


def plan_of(cells, layer):
    """Returns the triangles of a layer in the plane z = 0, each with its own corners, with the array Thickness."""
    chosen = cells["cell_data"]["Layer"] == layer
    starts, numbers = cells["cells"]
    places = cells["places"]
    corners, thickness = [np.zeros((0, 3))], [np.zeros(0)]
    for size in (6, 5, 4):  # wedges, pyramids, tetrahedra: three columns of one or two points each
        first = starts[:-1][chosen & (np.diff(starts) == size)]
        own = places[numbers[first[:, None] + np.arange(size)]]
        is_above_or_below = np.all(own[:, :, None, :2] == own[:, None, :, :2], axis=3)
        heights = np.where(is_above_or_below, own[:, None, :, 2], np.nan)
        top = np.nanmax(heights, axis=2, initial=-np.inf)
        is_top = own[:, :, 2] == top
        corners.append(own[is_top])
        thickness.append((top - np.nanmin(heights, axis=2, initial=np.inf))[is_top])
    places = np.concatenate(corners) * (1.0, 1.0, 0.0)
    return {**data.empty(), "places": places, "polygons": (np.arange(0, len(places) + 1, 3), np.arange(len(places))),
            "point_data": {"Thickness": np.concatenate(thickness)}}


def take_apart(bodies):
    """Returns the bodies of layers in one dataset, each shifted down from the previous one by a fifth of the total height."""
    heights = np.concatenate([body["places"][:, 2] for body in bodies])
    gap = 0.2 * np.ptp(heights)
    places = [body["places"] - (0.0, 0.0, gap * number) for number, body in enumerate(bodies)]
    firsts = np.cumsum([0, *map(len, places)])
    corners = np.concatenate([body["polygons"][1] + first for body, first in zip(bodies, firsts)])
    layers = np.concatenate([body["cell_data"]["Layer"] for body in bodies])
    return {**data.empty(), "places": np.concatenate(places), "polygons": (np.arange(0, len(corners) + 1, 3), corners),
            "cell_data": {"Layer": layers}}


def encode(mesh):
    """Encodes a mesh for the page."""
    points = mesh["places"]
    surface, closing = triangles.of_surface(mesh), triangles.at_faults(mesh)
    center = (points.min(axis=0) + points.max(axis=0)) / 2.0
    errors, error_on = _errors(mesh)
    index_type = "<u2" if len(points) <= 1 << 16 else "<u4"
    content = b"".join(((points - center).astype("<f4").tobytes(), errors.astype("<f4").tobytes(),
                        np.concatenate((surface, closing)).astype(index_type).tobytes()))
    farthest = float(np.nanmax(errors, initial=0.0))
    return Mesh(center.tolist(), len(points), len(surface), len(closing), error_on, farthest, content)


def _errors(mesh):
    """Returns the errors of the surface triangles if the decimation has stored them, otherwise the measured distances of
    the points, and which of the two they are."""
    values = triangles.values_on_surface(mesh, "Error")
    if values is not None:
        return np.nan_to_num(values), "triangles"
    if "Distance" in mesh["point_data"]:
        return np.nan_to_num(mesh["point_data"]["Distance"]), "points"
    return np.zeros(0), None
