# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Generated horizons, which the scripts in this folder draw."""

import pathlib
import subprocess
import tempfile

from seismichorizons.pipeline import read_first


def make_surface(generator, options, **properties):
    """A horizon by the program generate_horizons with these options, read with these properties."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "surface.vsm"
        subprocess.run([generator, *options, path], check=True, stdout=subprocess.DEVNULL)
        return read_first(path, **properties)
