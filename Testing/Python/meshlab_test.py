# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The distances between surfaces beside those of MeshLab's Hausdorff filter, which is Metro. Skipped without MeshLab.

Arguments: the folder of the data, a folder for files, and the script that gives a command an X server.
"""

import pathlib
import re
import shutil
import struct
import subprocess
import sys

import numpy as np
from seismichorizons import vtk as sh
from seismichorizons.vtk import apply

import mesh_checks
import vtk_inputs

SKIPPED = 77
FACE_SAMPLES = 200000
SCRIPT = """<!DOCTYPE FilterScript>
<FilterScript>
 <filter name="Hausdorff Distance">
  <Param type="RichMesh" name="SampledMesh" value="{sampled}"/>
  <Param type="RichMesh" name="TargetMesh" value="{target}"/>
  <Param type="RichBool" name="SaveSample" value="false"/>
  <Param type="RichBool" name="SampleVert" value="{vertices}"/>
  <Param type="RichBool" name="SampleEdge" value="false"/>
  <Param type="RichBool" name="SampleFauxEdge" value="false"/>
  <Param type="RichBool" name="SampleFace" value="{faces}"/>
  <Param type="RichInt" name="SampleNum" value="{samples}"/>
  <Param type="RichAbsPerc" name="MaxDist" value="1000" min="0" max="1000"/>
 </filter>
</FilterScript>
"""


def pairs(sample):
    """Three horizons at full resolution, each with a mesh that was made in another way."""
    ways = ((sh.vtkHorizonRoughSimplification(), {"CellSize": 3}),
            (sh.vtkHorizonRoughSimplification(), {"CellSize": 8}),
            (sh.vtkHorizonElaborateSimplification(), {"FlatnessThreshold": 0.05}))
    for (name, points), (algorithm, properties) in zip(vtk_inputs.read(sample).items(), ways):
        outlined = apply(sh.vtkHorizonExteriorBoundary(), points)
        full = apply(sh.vtkHorizonTriangulation(), outlined)
        thinned = apply(algorithm, apply(sh.vtkHorizonBoundarySimplification(), outlined), **properties)
        yield name, full, apply(sh.vtkHorizonTriangulation(), thinned)


def write_ply(mesh, path):
    """In doubles, so that no digit is lost; only points that are corners of triangles."""
    triangles = mesh_checks.triangles(mesh)
    used, corners = np.unique(triangles, return_inverse=True)
    points = mesh_checks.coordinates(mesh)[used]
    header = "ply\nformat binary_little_endian 1.0\nelement vertex %d\n" % len(points)
    header += "".join("property double %s\n" % axis for axis in "xyz")
    header += "element face %d\nproperty list uchar int vertex_indices\nend_header\n" % len(triangles)
    faces = (struct.pack("<B3i", 3, *t) for t in corners.reshape(-1, 3))
    path.write_bytes(header.encode() + points.astype("<f8").tobytes() + b"".join(faces))


def meshlab(with_server, folder, sampled, vertices):
    """The largest and the mean distance from the first (0) or the second file (1) to the other one."""
    script = folder / "distance.mlx"
    script.write_text(SCRIPT.format(sampled=sampled, target=1 - sampled, vertices=str(vertices).lower(),
                                    faces=str(not vertices).lower(), samples=FACE_SAMPLES), encoding="utf-8")
    command = [str(with_server), "meshlabserver", "-i", str(folder / "full.ply"), str(folder / "mesh.ply"),
               "-s", str(script)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    found = re.search(r"max\s+([\d.]+)\s+mean\s*:\s*([\d.]+)", done.stdout + done.stderr)
    assert found, done.stdout + done.stderr
    return float(found.group(1)), float(found.group(2))


def check(what, ours, theirs, tolerance):
    off = abs(ours - theirs) / theirs
    print("%s: %.6f, MeshLab %.6f: %.1e apart" % (what, ours, theirs, off))
    assert off <= tolerance, "%s: %g apart, at most %g allowed" % (what, off, tolerance)


def main():
    data, folder, with_server = (pathlib.Path(argument) for argument in sys.argv[1:4])
    if not shutil.which("meshlabserver") or not shutil.which("Xvfb"):
        print("no meshlabserver or no Xvfb, skipped")
        sys.exit(SKIPPED)
    folder.mkdir(parents=True, exist_ok=True)
    for name, full, mesh in pairs(data / "blobs.vsm"):
        write_ply(full, folder / "full.ply")
        write_ply(mesh, folder / "mesh.ply")
        meter = sh.vtkHorizonSurfaceDistance()
        apply(meter, full, mesh, SamplesPerPoint=20)
        for port, way in enumerate(("to mesh", "to reference")):
            output = meter.GetOutputDataObject(port)
            corners = np.unique(mesh_checks.triangles(output))
            distances = mesh_checks.array(output, "Distance")[corners]
            largest, mean = meshlab(with_server, folder, port, True)
            check("%s %s, largest at vertices" % (name, way), distances.max(), largest, 1e-5)
            check("%s %s, mean at vertices" % (name, way), distances.mean(), mean, 1e-4)
            mean = meshlab(with_server, folder, port, False)[1]
            ours = output.GetFieldData().GetArray("MeanDistance").GetComponent(port, 0)
            check("%s %s, mean over the faces" % (name, way), ours, mean, 0.02)


main()
