# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of horizons, stage by stage: rows of panels that each show one horizon in one style.

All panels of a row share camera, vertical exaggeration and colours, so that they can be compared. Drawing needs an X
server, but opens no visible window.
"""

from collections import namedtuple
import math

import numpy as np
# Importing these two modules registers the implementations of rendering and text.
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkJPEGWriter, vtkPNGWriter
from vtkmodules.vtkImagingCore import vtkExtractVOI
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer, vtkRenderWindow, vtkTextActor, vtkWindowToImageFilter

from .styles import (  # noqa: F401: styles of panels
    BODIES, CELLS, DISTANCE, FAULTS, LEVELS, MESH, OUTLINE, POINTS, THICKNESS, make_actors, rgb, values)
from .writing import write_file

# A panel shows a title, a line below it, and a horizon (data.py) in one of the styles. `behind` is a horizon whose points are drawn
# in pale grey, or None.
Panel = namedtuple("Panel", "title caption horizon style behind", defaults=[None])

PANEL_SIZE = (480, 400)
HEIGHT_SHARE = 0.22  # displayed height of a horizon as a fraction of its width
VIEW_AZIMUTH = math.radians(-62.0)
VIEW_ELEVATION = math.radians(38.0)
TEXT_COLOR = (0.13, 0.16, 0.20)


def draw(rows, text=True, panel_size=PANEL_SIZE):
    """Draws rows of panels and returns the picture as vtkImageData."""
    columns = max(len(row) for row in rows)
    renderers = []
    for number, row in enumerate(rows):
        frame = _Frame(row, panel_size)
        bottom = 1.0 - (number + 1) / len(rows)
        top = 1.0 - number / len(rows)
        for column, panel in enumerate(row):
            renderer = _renderer(frame, panel, text)
            renderer.SetViewport(column / columns, bottom, (column + 1) / columns, top)
            renderers.append(renderer)
    return render(renderers, (columns * panel_size[0], len(rows) * panel_size[1]))


def draw_each(row, panel_size, studio):
    """Draws the panels of a row without text. Returns a picture of each as vtkImageData, and what they share: the vertical
    exaggeration, and the values of the first and last colours of distances or thickness."""
    frame = _Frame(row, panel_size)
    renderers = [_renderer(frame, panel, text=False) for panel in row]
    for column, renderer in enumerate(renderers):
        renderer.SetViewport(column / len(row), 0.0, (column + 1) / len(row), 1.0)
    image = studio.render(renderers, (len(row) * panel_size[0], panel_size[1]))
    images = []
    for column in range(len(row)):
        cut = vtkExtractVOI()
        cut.SetInputData(image)
        cut.SetVOI(column * panel_size[0], (column + 1) * panel_size[0] - 1, 0, panel_size[1] - 1, 0, 0)
        cut.Update()
        images.append(cut.GetOutput())
    return images, frame.exaggeration, frame.scale_ends


def render(renderers, size):
    """Draws renderers, each in its viewport, and returns the picture as vtkImageData."""
    with Studio() as studio:
        return studio.render(renderers, size)


class Studio:
    """An off-screen window that is reused for many pictures, because opening it takes longer than drawing most of them."""

    def __init__(self):
        self._window = vtkRenderWindow()
        self._window.SetOffScreenRendering(1)
        self._window.SetMultiSamples(0)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._window.Finalize()

    def render(self, renderers, size):
        self._window.SetSize(*size)
        for renderer in renderers:
            self._window.AddRenderer(renderer)
        grabber = vtkWindowToImageFilter()  # makes the window draw
        grabber.SetInput(self._window)
        grabber.ReadFrontBufferOff()
        grabber.Update()
        for renderer in renderers:
            renderer.ReleaseGraphicsResources(self._window)
            self._window.RemoveRenderer(renderer)
        return grabber.GetOutput()


def write(image, path):
    """Writes a picture as PNG. Raises HorizonError."""
    writer = vtkPNGWriter()
    writer.WriteToMemoryOn()
    writer.SetInputData(image)
    writer.Write()
    write_file(vtk_to_numpy(writer.GetResult()).tobytes(), path)


def as_jpeg(image, quality=85):
    """Returns a picture as the bytes of a JPEG file."""
    writer = vtkJPEGWriter()
    writer.WriteToMemoryOn()
    writer.SetQuality(quality)
    writer.SetInputData(image)
    writer.Write()
    return vtk_to_numpy(writer.GetResult()).tobytes()


class _Frame:
    """The settings that the panels of a row share."""

    def __init__(self, row, panel_size):
        points = [panel.horizon["places"] for panel in row]
        points = [p for p in points if len(p)] or [np.zeros((1, 3))]
        self.points = max(points, key=len)
        self.low = np.min([p.min(axis=0) for p in points], axis=0)
        self.high = np.max([p.max(axis=0) for p in points], axis=0)
        self.panel_size = panel_size
        self.count = len(self.points)
        # A few extreme points should not use up the colour scale.
        low, high = np.percentile(self.points[:, 2], (1.0, 99.0))
        self.color_range = (low, max(high, low + 1e-9))
        self.scale_ends = (0.0, max([1e-9] + [np.percentile(values(panel.horizon, "Distance"), 99.0) for panel in row
                                              if panel.style == DISTANCE]))
        self.is_plan = all(panel.style == THICKNESS for panel in row)
        if self.is_plan:
            thickness = np.concatenate([values(panel.horizon, "Thickness") for panel in row])
            self.scale_ends = (thickness.min(), max(thickness.max(), thickness.min() + 1e-9))
        extent = self.high - self.low
        width = max(extent[0], extent[1], 1e-9)
        # The value is rounded because the caption shows it.
        exaggeration = HEIGHT_SHARE * width / extent[2] if extent[2] > 0 else 1.0
        self.exaggeration = float("%.2g" % exaggeration)

    def pixels(self):
        return self.panel_size[0] * self.panel_size[1]

    def scale(self):
        return (1.0, 1.0, self.exaggeration)

    def point_size(self):
        """Returns the size at which the points of a full horizon just touch."""
        return max(1.5, min(6.0, 0.9 * math.sqrt(0.45 * self.pixels() / self.count)))

    def place_camera(self, camera):
        """Places the camera obliquely above the horizon, or vertically above a plan, so that it fills the panel."""
        azimuth, elevation = (-math.pi / 2.0, math.pi / 2.0) if self.is_plan else (VIEW_AZIMUTH, VIEW_ELEVATION)
        toward = np.array([
            math.cos(elevation) * math.cos(azimuth), math.cos(elevation) * math.sin(azimuth), math.sin(elevation)])
        up = [0.0, 1.0, 0.0] if self.is_plan else [0.0, 0.0, 1.0]
        right = np.cross(up, toward)
        right /= np.linalg.norm(right)
        axes = np.column_stack([right, np.cross(toward, right), toward])
        seen = (self.points * self.scale()) @ axes
        low, high = seen.min(axis=0), seen.max(axis=0)
        center = axes @ ((low + high) / 2.0)
        depth = max(np.linalg.norm(high - low), 1e-9)
        width, height = self.panel_size
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(*center)
        camera.SetPosition(*(center + 2.0 * depth * toward))
        camera.SetViewUp(*up)
        # The horizon is slightly below the centre to leave room for the text above.
        camera.SetWindowCenter(0.0, 0.0 if self.is_plan else 0.08)
        camera.SetParallelScale(max((0.53 if self.is_plan else 0.65) * (high - low)[1],
                                    0.53 * (high - low)[0] * height / width, 1e-9))
        camera.SetClippingRange(0.5 * depth, 4.0 * depth)


def _renderer(frame, panel, text):
    renderer = vtkRenderer()
    renderer.SetBackground(0.90, 0.92, 0.95)
    renderer.SetBackground2(0.99, 0.99, 1.0)
    renderer.GradientBackgroundOn()
    _light(renderer)
    for actor in make_actors(frame, panel):
        actor.SetScale(*frame.scale())
        renderer.AddActor(actor)
    if text:
        renderer.AddViewProp(text_actor(panel.title, 17, (14, frame.panel_size[1] - 30), bold=True))
        renderer.AddViewProp(text_actor(panel.caption, 13, (14, frame.panel_size[1] - 50)))
        renderer.AddViewProp(text_actor("heights x %g" % frame.exaggeration, 11, (14, 8)))
    frame.place_camera(renderer.GetActiveCamera())
    return renderer


def _light(renderer):
    """Adds a low light from the side, which brings out the relief, and a weak one from the viewer for the shadows."""
    renderer.AutomaticLightCreationOff()
    side = vtkLight()
    side.SetLightTypeToCameraLight()
    side.SetPosition(-1.2, 0.9, 0.9)
    side.SetIntensity(0.75)
    renderer.AddLight(side)
    eye = vtkLight()
    eye.SetLightTypeToHeadlight()
    eye.SetIntensity(0.55)
    renderer.AddLight(eye)


def text_actor(text, size, place, bold=False):
    """Returns a text with its lower left corner at a position in pixels."""
    actor = vtkTextActor()
    actor.SetInput(text)
    actor.SetPosition(*place)
    style = actor.GetTextProperty()
    style.SetFontSize(size)
    style.SetBold(bold)
    style.SetColor(*TEXT_COLOR)
    return actor
