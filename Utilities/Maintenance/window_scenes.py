# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs in the window of ParaView, by window_pictures.py: one scene of the gallery.

Variables of the environment: SCENE, its name here; SAMPLE, FAULTED and CUBE, the files that are opened.
"""

import os

from paraview import simple

OBLIQUE = (0.35, -0.75, 0.56)  # from the horizon to the eye


def open_file(name):
    return simple.OpenDataFile(os.environ[name])


def show(source, port=0, toward=OBLIQUE, beside=()):
    """What Apply does: the output in the view with its colour legend, and the panel of the filter."""
    view = simple.GetActiveViewOrCreate("RenderView")
    for other in beside:
        simple.Show(other, view)
    display = simple.Show(simple.OutputPort(source, port), view)
    display.SetScalarBarVisibility(view, True)
    source.UpdatePropertyInformation()
    simple.SetActiveSource(source)
    if toward:
        view.CameraFocalPoint = (0.0, 0.0, 0.0)
        view.CameraPosition = toward
        view.CameraViewUp = (0.0, 0.0, 1.0)
    simple.ResetCamera(view)
    view.CameraParallelProjection = 1
    view.CameraParallelScale *= 0.75
    simple.Render(view)
    return display


def outlined(source="SAMPLE"):
    return simple.HorizonExteriorBoundary(Input=open_file(source))


def simplified():
    return simple.HorizonRoughSimplification(Input=simple.HorizonBoundarySimplification(Input=outlined()))


def points():
    show(open_file("SAMPLE"))


def seismic_cube():
    show(open_file("CUBE"), toward=OBLIQUE).SliceMode = "XZ Plane"


def reflections():
    cube = open_file("CUBE")
    cube.UpdatePipeline()
    show(simple.SeismicReflectionExtraction(Input=cube), toward=OBLIQUE)


def despiking():
    show(simple.HorizonDespiking(Input=open_file("SAMPLE"), Action="Flag", Threshold=3, ThreadWidth=2))


def faults():
    horizon = open_file("FAULTED")
    show(simple.HorizonFaults(Input=horizon), 1, OBLIQUE, [horizon])


def hole_filling():
    show(simple.HorizonHoleFilling(Input=open_file("SAMPLE")))


def boundary():
    show(outlined())


def boundary_simplification():
    show(simple.HorizonBoundarySimplification(Input=outlined()))


def rough():
    show(simplified())


def elaborate():
    show(simple.HorizonElaborateSimplification(Input=simple.HorizonBoundarySimplification(Input=outlined())))


def triangulation():
    show(simple.HorizonTriangulation(Input=simplified()), toward=OBLIQUE)


def decimation():
    straight = simple.HorizonBoundarySimplification(Input=outlined())
    show(simple.HorizonDecimation(Input=straight), toward=OBLIQUE).Representation = "Surface With Edges"


def surface():
    show(simple.HorizonSurface(Input=open_file("SAMPLE")), toward=OBLIQUE)


def closed_faults():
    cut = simple.HorizonFaults(Input=open_file("FAULTED"))
    show(simple.HorizonSurface(Input=cut, MaximumError=1.5, CloseFaults=1), toward=OBLIQUE)


def distance():
    horizons = open_file("SAMPLE")
    mesh = simple.HorizonSurface(Input=horizons)
    show(simple.HorizonSurfaceDistance(Reference=horizons, Mesh=mesh), 1)


def exaggeration():
    horizon = open_file("FAULTED")
    horizon.ColumnStep, horizon.RowStep, horizon.VerticalStep = (24.0, 7.0), (-7.0, 24.0), 4.0
    view = simple.GetActiveViewOrCreate("RenderView")
    # What the buttons of the toolbar do first; the rest follows.
    view.AxesGrid.Visibility = 1
    view.AxesGrid.UseModelTransform = 1
    view.AxesGrid.DataScale = (1.0, 1.0, 5.0)
    for button in ("VerticalExaggeration", "SurveyAxes"):
        view.SMProxy.SetAnnotation("SeismicHorizons." + button, "1")
    show(simple.HorizonSurface(Input=simple.HorizonFaults(Input=horizon), MaximumError=1.5), toward=OBLIQUE)


globals()[os.environ["SCENE"]]()
