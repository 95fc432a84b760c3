# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Heights of meshes at the columns of their lattice, by the writer of grids."""

import os
import tempfile

from .stage import make, update, update_writer


def sample(mesh, direction, label):
    """A horizon of the columns that the triangles of a mesh cover. `direction` says where z of the mesh grows to. Raises
    HorizonError, which names the mesh by its label, and OSError."""
    with tempfile.TemporaryDirectory() as folder:  # which nobody else has
        grid = os.path.join(folder, "sampled.irap")
        writer = make("vtkHorizonGridWriter", FileName=grid)
        writer.SetInputDataObject(0, mesh)
        update_writer(writer, label)
        reader = make("vtkHorizonGridReader", FileName=grid, VerticalDirection=direction)
        update(reader)
    return reader.GetOutputDataObject(0).GetPartition(0, 0)
