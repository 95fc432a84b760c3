# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin takes all processors, unless the environment says otherwise. Arguments: pvpython, or nothing inside it."""

import os
import subprocess
import sys


def backend(pvpython, **variables):
    """What a process that has loaded the plugin runs loops on."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith("VTK_SMP_")}
    done = subprocess.run([pvpython, __file__], capture_output=True, text=True, timeout=60, check=True,
                          env={**environment, **variables})
    return done.stdout.split()[-1]


def main():
    if len(sys.argv) == 1:
        from paraview import simple
        from vtkmodules.vtkCommonCore import vtkSMPTools

        assert hasattr(simple, "HorizonSurface")
        print(vtkSMPTools.GetBackend())
        return
    assert backend(sys.argv[1]) in ("STDThread", "TBB", "OpenMP")
    assert backend(sys.argv[1], VTK_SMP_BACKEND_IN_USE="Sequential") == "Sequential"


main()
