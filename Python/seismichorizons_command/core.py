# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Calls of the core (the package seismichorizons), with errors for the user, progress, and the end on request.

Properties have the names of the documentation and of ParaView's panels, such as `CellSize` and `ZFrom="RealZ"`.
"""

import contextlib
import os

from seismichorizons import _core
from seismichorizons._data import snake

from . import interrupt
from .progress import Progress

NO_MEMORY = "more data than memory, expected fewer or smaller horizons"

_hearers = []  # handlers of warnings; the last one is used


class HorizonError(ValueError):
    """An error with a one-line message for the user."""


@contextlib.contextmanager
def heard_by(hear):
    """Passes warnings that no caller collects to hear(text) within the block."""
    _hearers.append(hear)
    try:
        yield
    finally:
        _hearers.pop()


def warn(text):
    """Passes on a warning. Outside of heard_by nobody hears it."""
    if _hearers:
        _hearers[-1](text)


def set_threads(number):
    """Sets the number of threads of the stages; 0 means all processors."""
    _core.set_threads(number or _processors())


def share_threads(number, jobs):
    """Sets the share of one of several processes in a number of threads; 0 means all processors."""
    _core.set_threads(max(1, (number or _processors()) // jobs))


def _processors():
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def run(function, *arguments, label="", work=None):
    """Returns what a function of the core returns. Raises HorizonError with its error, and SystemExit if the program has
    been asked to end.

    With a label, the progress of a long run is shown on the terminal; `work` is the amount of work, as (number, unit).
    """
    progress = Progress(label, work)

    def on_progress(fraction):
        interrupt.check()
        progress.show(fraction)

    try:
        with errors():
            made = function(*arguments, on_progress)
    finally:
        progress.end()
    interrupt.check()
    return made


@contextlib.contextmanager
def errors(prefix=""):
    """Within the block errors are HorizonError, and begin with the prefix."""
    try:
        yield
    except (ValueError, OSError, ImportError) as error:
        raise HorizonError("%s%s" % (prefix, error)) from None
    except MemoryError:
        raise HorizonError("%s%s" % (prefix, NO_MEMORY)) from None


# Properties that the core has by another name.
RENAMED = {"GrowthStrategy": "growth", "DuplicatePolicy": "duplicates"}


def options(properties):
    """Returns properties as options of the core."""
    return {RENAMED.get(name) or snake(name): snake(value) if isinstance(value, str) else value
            for name, value in properties.items()}
