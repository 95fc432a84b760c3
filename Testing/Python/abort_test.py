# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs in pvpython: each stage tells how far it is, stops when it is asked to, and gives the whole result when it runs again.

What is asked for is what the Abort button asks for in versions of ParaView where it stops filters: SetAbortExecuteAndUpdateTime
of the running one. Arguments: the folder of the data and one for files.
"""

import pathlib
import sys

# Before any object of these classes comes out of a proxy: Python would take it for one of a base class, for good.
import seismichorizons.vtk  # noqa: F401

import mesh_checks
import pipelines
from errors_test import captured

STOP_AT = 0.2


class Watcher:
    """Listens to the progress of a proxy, and asks it to stop."""

    def __init__(self, proxy, stop_at=2.0):
        self.algorithm, self.stop_at = proxy.GetClientSideObject(), stop_at
        self.reports, self.asked_at = [], None
        self.tag = self.algorithm.AddObserver("ProgressEvent", self.listen)

    def listen(self, algorithm, _):
        self.reports.append(algorithm.GetProgress())
        if self.asked_at is None and self.stop_at <= self.reports[-1] < 1:
            self.asked_at = len(self.reports)
            algorithm.SetAbortExecuteAndUpdateTime()

    def leave(self):
        self.algorithm.RemoveObserver(self.tag)


def outputs(proxy):
    algorithm = proxy.GetClientSideObject()
    return [algorithm.GetOutputDataObject(port) for port in range(algorithm.GetNumberOfOutputPorts())]


def elements(proxy):
    """How many points and rows all outputs have."""
    return [data.GetNumberOfElements(data.ROW if data.IsA("vtkTable") else data.POINT) for data in outputs(proxy)]


def run(proxy, watcher):
    """Runs a proxy as after a change of a parameter; returns what was written to the error output."""
    proxy.GetClientSideObject().Modified()
    proxy.SMProxy.MarkDirty(proxy.SMProxy)
    with captured() as log:
        proxy.UpdatePipeline()
        watcher.leave()
        return log()


def kept(proxy):
    """Copies of the horizons of output 0."""
    copies = {}
    for name, horizon in mesh_checks.blocks(outputs(proxy)[0]).items():
        copies[name] = horizon.NewInstance()
        copies[name].DeepCopy(horizon)
    return copies


def check(name, proxy):
    proxy.UpdatePipeline()
    expected, counts = kept(proxy), elements(proxy)
    watcher = Watcher(proxy)
    assert run(proxy, watcher) == "", name
    reports = watcher.reports
    assert reports == sorted(reports) and reports[-1] == 1, (name, reports)

    watcher = Watcher(proxy, STOP_AT)
    told = run(proxy, watcher)
    assert told == "", (name, told)
    assert watcher.asked_at is not None, (name, watcher.reports)
    after = watcher.reports[watcher.asked_at:]
    # The pipeline itself says 1 at the end, and begins again for a second output, for as long as it is asked to stop.
    assert all(report < STOP_AT or report == 1 for report in after), (name, watcher.reports)
    assert not any(elements(proxy)), (name, elements(proxy))

    watcher.algorithm.SetAbortExecute(0)
    assert run(proxy, Watcher(proxy)) == "", name
    assert elements(proxy) == counts and list(kept(proxy)) == list(expected), (name, elements(proxy), counts)
    for block, horizon in kept(proxy).items():
        pipelines.assert_same(horizon, expected[block])
    print("%s: %d reports, stopped at %.2f" % (name, len(reports), max(r for r in watcher.reports if r < 1)))


def check_downstream(proxies):
    """What follows a stage that was stopped is empty, without a word, and whole when that has run again."""
    stopped, last = proxies["loops"], (proxies["mesh"], proxies["distance"])
    counts = [elements(proxy) for proxy in last]
    watcher = Watcher(stopped, STOP_AT)
    assert run(stopped, watcher) == ""
    for again in (False, True):
        if again:
            watcher.algorithm.SetAbortExecute(0)
            assert run(stopped, watcher) == ""
        with captured() as log:
            for proxy in last:
                proxy.UpdatePipeline()
            told = log()
        assert told == "", told
        found = [elements(proxy) for proxy in last]
        assert found == counts if again else not any(map(any, found)), (found, counts)
    # Errors are told again.
    proxies["distance"].SamplesPerPoint = -1.0
    with captured() as log:
        proxies["distance"].UpdatePipeline()
        assert "expected" in log(), "no error"


def main():
    folder = pathlib.Path(sys.argv[2]).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    sample = pathlib.Path(sys.argv[1]).resolve() / "blobs.vsm"
    proxies = pipelines.all_stages(sample, pipelines.write_fault(folder))
    for name, proxy in proxies.items():
        if name != "lines":  # a few points are read at once
            check(name, proxy)
    check_downstream(proxies)


main()
