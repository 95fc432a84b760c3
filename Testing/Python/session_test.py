# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs in pvpython: what outlives a session gives the same again. State files, Python state, traces, saved data, extracts,
and an animation over a parameter. Arguments: the folder of the data and one for files.
"""

import pathlib
import re
import shutil
import sys

# Before any object of these classes comes out of a proxy: Python would take it for one of a base class, for good.
import seismichorizons.vtk  # noqa: F401
from paraview import servermanager, simple, smstate, smtrace

import mesh_checks
import pipelines

ERRORS = (0.5, 1.5, 3.0)  # of the frames of the animation, in lattice units


def fetch(proxy):
    """The data of a proxy; the server is this process itself, so they are at hand."""
    proxy.UpdatePipeline()
    return mesh_checks.blocks(proxy.GetClientSideObject().GetOutputDataObject(0))


def settings(proxy):
    """The values of the properties that a user sets."""
    found = {}
    for name in proxy.ListProperties():
        prop = proxy.SMProxy.GetProperty(name)
        if hasattr(prop, "GetElement") and not prop.GetInformationOnly():
            found[name] = [str(prop.GetElement(n)) for n in range(prop.GetNumberOfElements())]
    # Names and whether they are chosen, in no certain order: ParaView 6 puts those first that are not.
    status = found.get("HorizonStatus", [])
    found["HorizonStatus"] = sorted(zip(status[::2], status[1::2]))
    return found


def snapshot(proxies):
    """Settings and data of each proxy. The data are copied, for proxies to go away."""
    found = {}
    for name, proxy in proxies.items():
        copies = {}
        data = fetch(proxy) if name != "lines" else {}
        for block, horizon in data.items():
            copies[block] = horizon.NewInstance()
            copies[block].DeepCopy(horizon)
        found[name] = settings(proxy), copies
    return found


def assert_session(expected):
    """The pipeline that is there now is the one of the snapshot."""
    there = {key[0]: proxy for key, proxy in simple.GetSources().items()}
    assert sorted(there) == sorted(expected), sorted(there)
    found = snapshot(there)
    for name, (values, data) in expected.items():
        for key, value in values.items():
            assert found[name][0][key] == value, (name, key, value, found[name][0][key])
        assert list(found[name][1]) == list(data), (name, list(found[name][1]))
        for block, horizon in data.items():
            pipelines.assert_same(found[name][1][block], horizon)


def check_states(expected, folder, trace):
    """State file, Python state and trace, each in a new session."""
    state = folder / "state.pvsm"
    simple.SaveState(str(state))
    script = smstate.get_state()
    simple.ResetSession()
    assert not simple.GetSources()
    simple.LoadState(str(state))
    assert_session(expected)
    for text in (script, trace):
        simple.ResetSession()
        exec(compile(text, "script", "exec"), {})
        assert_session(expected)


def check_renamed(state, name, old, new, values):
    """A state of version 0.2 with the old name of a property sets the new one; a value of the new name is preferred."""
    text = state.read_text(encoding="utf-8")
    now = re.search(r' *<Property name="%s" id="(\d+)\.%s".*?</Property>\n' % (new, new), text, re.S)[0]
    now = re.sub(r'<Element index="0" value="[^"]*"/>', '<Element index="0" value="%s"/>' % values[0], now)
    before = now.replace(new, old).replace('value="%s"' % values[0], 'value="%s"' % values[1])
    for number, (properties, value) in enumerate(((before, values[1]), (before + now, values[0]), (now, values[0]))):
        path = state.with_name("renamed_%d.pvsm" % number)
        changed = re.sub(r' *<Property name="%s" id=.*?</Property>\n' % new, lambda _: properties, text, flags=re.S)
        path.write_text(changed, encoding="utf-8")
        simple.ResetSession()
        simple.LoadState(str(path))
        proxy = simple.FindSource(name)
        proxy.UpdatePipeline()
        found = proxy.SMProxy.GetProperty(new).GetElement(0), getattr(proxy.GetClientSideObject(), "Get" + new)()
        assert found == (value, value), (new, number, found)
        again = state.with_name("again.pvsm")  # what is set then is saved by the new name alone
        proxy.SMProxy.GetProperty(new).SetElement(0, values[2])
        simple.SaveState(str(again))
        assert '"%s"' % old not in again.read_text(encoding="utf-8")
        simple.ResetSession()
        simple.LoadState(str(again))
        assert simple.FindSource(name).SMProxy.GetProperty(new).GetElement(0) == values[2]


def check_opened(path, expected, reader):
    """The points of horizons are in the file under their names."""
    opened = simple.OpenDataFile(str(path))
    assert type(opened).__name__ == reader, opened
    found = fetch(opened)
    assert sorted(found) == sorted(expected), (path.name, sorted(found))
    for name, horizon in expected.items():
        assert found[name].GetNumberOfPoints() == horizon.GetNumberOfPoints(), (path.name, name)
    simple.Delete(opened)


def check_saved_data(points, surface, folder):
    """Each writer keeps names. Writers of one horizon a file name it after the horizon."""
    horizons, meshes = fetch(points), fetch(surface)
    for extension, proxy, expected, reader in (
            ("vsm", points, horizons, "VerneySparseMatrixReader"), ("dat", points, horizons, "HorizonTextReader"),
            ("vtpc", points, horizons, "XMLPartitionedDatasetCollectionReader"),
            ("vtpc", surface, meshes, "XMLPartitionedDatasetCollectionReader")):
        path = folder / ("%s.%s" % ("points" if proxy is points else "surface", extension))
        mode = {"DataMode": "Binary"} if extension == "vtpc" else {}  # some readers of VTK stumble over appended data
        simple.SaveData(str(path), proxy=proxy, **mode)
        check_opened(path, expected, reader)
    used = {name: mesh_checks.triangles(mesh) for name, mesh in meshes.items()}
    simple.SaveData(str(folder / "surface.ts"), proxy=surface)
    found = fetch(simple.OpenDataFile(str(folder / "surface.ts")))
    assert {name: len(mesh_checks.triangles(mesh)) for name, mesh in found.items()} == {
        name: len(corners) for name, corners in used.items()}
    for extension in ("irap", "fgr", "zmap"):
        simple.SaveData(str(folder / ("grid." + extension)), proxy=points)
        for name, horizon in horizons.items():
            path = folder / ("grid_%s.%s" % (name.replace(" ", "_"), extension))
            kept = name if extension == "zmap" else path.stem  # IRAP has no room for a name
            check_opened(path, {kept: horizon}, "HorizonGridReader")


def check_saved_faults(points, folder):
    """Fault lines, saved in each format, are opened as lines, which cut the same links."""
    fault = folder / "own.pol"
    fault.write_text("20.5 -9.0 0\n20.5 900.0 0\n", encoding="ascii")
    lines = simple.FaultLinesReader(FileName=[str(fault)])
    cut = simple.HorizonFaults(Input=points, FaultLines=lines, Detect=False)
    expected = {name: cut_links(horizon) for name, horizon in fetch(cut).items()}
    assert any(expected.values()), expected
    for extension in ("pl", "dat"):
        path = folder / ("faults." + extension)
        simple.SaveData(str(path), proxy=simple.OutputPort(cut, 1))
        again = simple.HorizonFaults(Input=points, FaultLines=simple.FaultLinesReader(FileName=[str(path)]), Detect=False)
        assert {name: cut_links(horizon) for name, horizon in fetch(again).items()} == expected, extension
    simple.SaveData(str(folder / "polygons.pol"), proxy=lines)
    assert sorted(path.name for path in folder.glob("polygons*")) == ["polygons.pol"]


def cut_links(horizon):
    links = horizon.GetFieldData().GetArray("FaultedLinks")
    return [links.GetTuple(n) for n in range(links.GetNumberOfTuples())]


def check_animation(sample, folder):
    """Frames with different errors have meshes with different numbers of triangles, in the extracts as by hand."""
    surface = simple.HorizonSurface(registrationName="animated", Input=simple.OpenDataFile(str(sample)))
    expected = []
    for error in ERRORS:
        surface.MaximumError = error
        expected.append({name: mesh_checks.check_mesh(mesh) for name, mesh in fetch(surface).items()})
        assert str(surface.Results) == surface.GetClientSideObject().GetResults(), (error, surface.Results)
    scene = simple.GetAnimationScene()
    scene.PlayMode, scene.NumberOfFrames = "Sequence", len(ERRORS)
    track = simple.GetAnimationTrack("MaximumError", proxy=surface)
    last = len(ERRORS) - 1
    track.KeyFrames = [simple.CompositeKeyFrame(KeyTime=n / last, KeyValues=[error], Interpolation="Ramp")
                       for n, error in enumerate(ERRORS)]
    simple.CreateExtractor("VTPC", surface, registrationName="extract").Writer.DataMode = "Binary"
    simple.SaveExtracts(ExtractsOutputDirectory=str(folder))
    for frame, triangles in enumerate(expected):
        found = fetch(simple.OpenDataFile(str(folder / ("animated_%06d.vtpc" % frame))))
        assert {name: len(mesh_checks.triangles(mesh)) for name, mesh in found.items()} == triangles, frame
    totals = [sum(triangles.values()) for triangles in expected]
    assert totals == sorted(totals, reverse=True) and totals[0] > 3 * totals[-1] > 0, totals


def check_results(sample, folder):
    """What a stage tells in scripts is of the time that was asked for last."""
    fewer = folder / "fewer.vsm"
    simple.SaveData(str(fewer), proxy=simple.VerneySparseMatrixReader(
        FileName=str(sample), HorizonStatus=["Horizon 1"]))
    surface = simple.HorizonSurface(Input=simple.VerneySparseMatrixReader(FileName=[str(sample), str(fewer)]))
    told = []
    for time in (0.0, 1.0, 0.0):
        surface.UpdatePipeline(time)
        told.append(str(surface.Results))
        assert told[-1] == surface.GetClientSideObject().GetResults(), (time, told[-1])
    assert told[0] == told[2] != told[1], told


def main():
    sample = pathlib.Path(sys.argv[1]).resolve() / "blobs.vsm"
    folder = pathlib.Path(sys.argv[2]).resolve()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    fault = pipelines.write_fault(folder)
    smtrace.start_trace()
    proxies = pipelines.all_stages(sample, fault)
    trace = smtrace.stop_trace()
    expected = snapshot(proxies)
    for name, (_, data) in expected.items():
        assert name == "lines" or list(data) == pipelines.CHOSEN, (name, list(data))
    check_states(expected, folder, trace)
    check_renamed(folder / "state.pvsm", "quiet", "ThreadWidth", "SpurWidth", (1, 2, 3))
    check_renamed(folder / "state.pvsm", "points", "Elevation", "ZFrom", (0, 1, 1))
    check_renamed(folder / "state.pvsm", "outline", "UseCuts", "TearAtFaults", (1, 0, 1))
    simple.ResetSession()
    points = simple.OpenDataFile(str(sample))
    check_saved_data(points, simple.HorizonSurface(Input=points), folder)
    check_saved_faults(points, folder)
    simple.ResetSession()
    check_results(sample, folder)
    simple.ResetSession()
    check_animation(sample, folder / "extracts")


main()
