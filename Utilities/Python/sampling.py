# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Heights of meshes at the columns of their lattice, from the grid writer."""

import os
import tempfile

from .stage import make, update, update_writer


def sample(mesh, direction, label):
    """Returns a horizon of the columns that the triangles of a mesh cover. `direction` is the direction in which z of the
    mesh increases. Raises HorizonError, which names the mesh by its label, and OSError."""
    with tempfile.TemporaryDirectory() as folder:
        grid = os.path.join(folder, "sampled.irap")
        writer = make("vtkHorizonGridWriter", FileName=grid)
        writer.SetInputDataObject(0, mesh)
        update_writer(writer, label)
        reader = make("vtkHorizonGridReader", FileName=grid, VerticalDirection=direction)
        update(reader)
    return reader.GetOutputDataObject(0).GetPartition(0, 0)
