# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Extensions that PyVista finds automatically: `data.horizon.surface(...)` on its meshes, `pyvista.read("top.ts")` and
`mesh.save("top.ts")`. If the package was not installed by pip, import this module first."""

import functools

import pyvista

from . import functions, stages


@pyvista.register_dataset_accessor("horizon", pyvista.PolyData)
class HorizonAccessor:
    """The functions of the package that take a horizon or a mesh, as methods."""

    def __init__(self, data):
        self._data = data


def _add_method(function):
    @functools.wraps(function)
    def method(self, *others, **keywords):
        return function(self._data, *others, **keywords)

    del method.__wrapped__  # its signature has one parameter more
    setattr(HorizonAccessor, function.__name__, method)


for _function in (functions.details, functions.distance, functions.surface, functions.write, *stages.STAGES.values()):
    _add_method(_function)


def read_file(path, **keywords):
    """Reads the horizons of a file as named blocks."""
    return pyvista.MultiBlock(functions.read(path, **keywords))


def write_file(data, path, **keywords):
    """Writes a mesh or the points of a horizon."""
    functions.write(data, path, **keywords)
