# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs in pvpython: from a cube to horizons, meshes and a file through the proxies of ParaView. Argument: a folder."""

import pathlib
import sys

# Before any object of these classes comes out of a proxy: Python would take it for one of a base class, for good.
import seismichorizons.vtk  # noqa: F401
from paraview import simple

import mesh_checks


def fetch(proxy):
    proxy.UpdatePipeline()
    return mesh_checks.blocks(proxy.GetClientSideObject().GetOutputDataObject(0))


def values(horizon, name):
    return sorted(mesh_checks.array(horizon, name).tolist())


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    cube = simple.Wavelet(WholeExtent=[0, 40, 5, 40, -20, 20])
    wave = simple.Calculator(Input=cube, Function="RTData - 150", ResultArrayName="centred")
    wave.UpdatePipeline()
    extraction = simple.SeismicReflectionExtraction(Input=wave, SmallestSize=50, Order="Size")
    assert extraction.AmplitudeArray[1] == "centred", extraction.AmplitudeArray
    horizons = fetch(extraction)
    assert list(horizons) == ["Horizon %d" % (n + 1) for n in range(len(horizons))] and len(horizons) >= 2, horizons
    sizes = [horizon.GetNumberOfPoints() for horizon in horizons.values()]
    assert sizes == sorted(sizes, reverse=True) and sizes[-1] >= 50, sizes
    extraction.UpdatePropertyInformation()
    assert extraction.WhatWasFound.startswith("60516 samples, "), extraction.WhatWasFound

    # A script need not update the cube before: where no array is known yet it is the active one.
    fresh = simple.Calculator(Input=cube, Function="RTData - 150", ResultArrayName="centred")
    assert len(fetch(simple.SeismicReflectionExtraction(Input=fresh, SmallestSize=50))) == len(horizons)

    # One of the arrays by its name, and fewer horizons.
    extraction.AmplitudeArray = ["POINTS", "RTData"]
    other = fetch(extraction)
    assert values(other["Horizon 1"], "Amplitude")[0] > 0.0
    extraction.AmplitudeArray = ["POINTS", "centred"]
    extraction.LargestNumber = 2
    assert list(fetch(extraction)) == ["Horizon 1", "Horizon 2"]

    # An older horizon as guide brings that horizon, by its name. By Input=, ParaView takes the array of the active source.
    guided = fetch(simple.SeismicReflectionExtraction(wave, Guides=extraction))
    assert list(guided) == ["Horizon 1", "Horizon 2"], list(guided)
    for name, horizon in guided.items():
        assert horizon.GetNumberOfPoints() >= fetch(extraction)[name].GetNumberOfPoints(), name
        assert set(values(horizon, "Origin")) <= {0.0, 1.0, 2.0} and values(horizon, "Origin")[0] == 0.0

    # A drawn line is a guide, and blocks are limits: of one, and between two of them, and none again.
    places = [horizons["Horizon 1"].GetPoint(n) for n in (0, 20)]
    drawn = simple.PolyLineSource(Points=[number for place in places for number in place])
    assert list(fetch(simple.SeismicReflectionExtraction(wave, Guides=drawn))) == ["Guide 1"]
    extraction.LargestNumber = 100
    blocks = [simple.ExtractBlock(Input=extraction, Assembly="Hierarchy", Selectors=["/Root/Horizon%d" % n])
              for n in (3, 4)]
    limited = simple.SeismicReflectionExtraction(wave, SmallestSize=50, Limits=blocks[:1], LimitSide="Above")
    above = fetch(limited)
    limited.Limits = blocks
    between = fetch(limited)
    limited.Limits = []
    counts = [sum(one.GetNumberOfPoints() for one in found.values()) for found in (above, between, fetch(limited), horizons)]
    assert 0 < counts[0] < counts[2] and 0 < counts[1] < counts[2] == counts[3], counts

    # A file of voxels has them all again; so have the stages.
    path = str(folder / "cube.vsm")
    simple.SaveData(path, extraction)
    again = fetch(simple.OpenDataFile(path))
    for name in ("Horizon 1", "Horizon 2"):
        for array in ("VerticalIndex", "Thickness", "Amplitude", "RealZ"):
            assert values(again[name], array) == values(horizons[name], array), (name, array)
    meshes = fetch(simple.HorizonSurface(Input=extraction))
    assert all(mesh.GetNumberOfPolys() > 0 for mesh in meshes.values())


main()
