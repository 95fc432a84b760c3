# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The benchmark at a small size: every stage is there with every number of threads, and the figures fit each other.

Arguments: the script benchmark.sh, the folder of a build, a folder for files.
"""

import json
import os
import pathlib
import subprocess
import sys

SIZE = 4000
STAGES = {"read", "boundary", "boundary simplification", "rough", "elaborate", "triangulation, all points",
          "triangulation, after rough", "error", "whole chain", "file to mesh"}
PEERS = {"vtkDelimitedTextReader", "vtkBinnedDecimation", "vtkQuadricClustering", "vtkQuadricDecimation",
         "vtkDelaunay2D", "ParaView's chain"}


def main():
    script, build, folder = sys.argv[1:4]
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    done = subprocess.run([script, "--sizes", str(SIZE), "--json", str(folder / "benchmark.json"),
                           "--markdown", str(folder / "Benchmarks.md")], check=True, stdout=subprocess.PIPE, text=True,
                          env=dict(os.environ, SEISMICHORIZONS_BUILD=build))
    assert done.stdout == (folder / "Benchmarks.md").read_text(encoding="utf-8")
    found = json.loads((folder / "benchmark.json").read_text(encoding="utf-8"))
    for threads in (1, 2):
        stages = {r["stage"]: r for r in found["stages"] if r["threads"] == threads}
        assert set(stages) == STAGES, sorted(stages)
        for name, r in stages.items():
            # The stage after rough has fewer points.
            assert 100 < r["points"] < 1.2 * SIZE, (name, r)
            assert 0.0 < r["seconds"] < 5.0, (name, r)
            assert 0.0 <= r["bytes_per_point"] < 100000.0, (name, r)
            assert abs(r["seconds"] * r["points_per_second"] / r["points"] - 1.0) < 1e-9, (name, r)
        assert stages["whole chain"]["seconds"] > 0.5 * stages["read"]["seconds"]
        for name in STAGES:
            assert "| %s |" % name in done.stdout, name
    assert PEERS <= {r["peer"] for r in found["peers"]}, found["peers"]
    for r in found["peers"]:
        assert r["seconds"] > 0.0 and abs(r["ratio"] * r["our_seconds"] / r["seconds"] - 1.0) < 1e-9, r


main()
