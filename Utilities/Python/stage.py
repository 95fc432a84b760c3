# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""One stage, that is one VTK algorithm: made with properties by their names, and run with errors as exceptions.

Properties are those of the documentation (`CellSize=3` calls `SetCellSize(3)`); one that is a choice may be given by
the name of the choice (`ZFrom="RealZ"`).
"""

import contextlib
import time

import seismichorizons as sh
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkSMPTools

from . import interrupt
from .progress import Progress


class HorizonError(ValueError):
    """What the user should read: one line."""


def set_threads(number):
    """How many threads the stages use; 0 stands for all processors."""
    # The default back-end of many VTK builds is the sequential one.
    vtkSMPTools.SetBackend("STDThread")
    vtkSMPTools.Initialize(number)


def configure(algorithm, **properties):
    for name, value in properties.items():
        choose = getattr(algorithm, "Set%sTo%s" % (name, value), None)
        if choose:
            choose()
        else:
            getattr(algorithm, "Set" + name)(value)


def make(class_name, **properties):
    """An algorithm of this package, by the name of its class."""
    algorithm = getattr(sh, class_name)()
    configure(algorithm, **properties)
    return algorithm


def update(algorithm, label="", warnings=None, work=None):
    """Runs an algorithm and returns the seconds it took. Raises HorizonError with what the algorithm says is wrong.

    With a label, progress is told on the terminal when the algorithm takes long; `work` is how much there is to do, as
    (number, unit). With a list for warnings, those go there; else VTK prints them.
    """
    start = time.monotonic()
    with watched(algorithm, label, warnings, work):
        algorithm.Update()
        return time.monotonic() - start


def apply(algorithm, *inputs, **properties):
    """Runs an algorithm on its inputs, one for each port, and returns its first output. Raises HorizonError."""
    configure(algorithm, **properties)
    for port, data in enumerate(inputs):
        algorithm.SetInputDataObject(port, data)
    update(algorithm)
    return algorithm.GetOutputDataObject(0)


@contextlib.contextmanager
def watched(algorithm, label="", warnings=None, work=None):
    """Watches an algorithm as long as the block runs, and raises its first error, if there was one, as HorizonError.
    Stops the algorithm, and raises SystemExit, when the program is to end."""
    errors = []
    progress = Progress(label, work)

    def on_progress(_caller, _event):
        if interrupt.is_asked():
            algorithm.AbortExecuteOn()
        progress.tell(algorithm.GetProgress())

    on_error = _collect(errors)
    executive = algorithm.GetExecutive()
    # Only the algorithm says what is wrong; its executive repeats that something is.
    observers = [(algorithm, algorithm.AddObserver("ErrorEvent", on_error)),
                 (executive, executive.AddObserver("ErrorEvent", on_error)),
                 (algorithm, algorithm.AddObserver("ProgressEvent", on_progress))]
    if warnings is not None:
        observers.append((algorithm, algorithm.AddObserver("WarningEvent", _collect(warnings))))
    try:
        yield
    finally:
        for observed, tag in observers:
            observed.RemoveObserver(tag)
        progress.end()
    interrupt.check()
    if errors:
        raise HorizonError(errors[0])


def _collect(messages):
    """An observer of errors or warnings."""

    @calldata_type(VTK_STRING)
    def on_message(_caller, _event, message):
        messages.append(_one_line(message))

    return on_message


def _one_line(message):
    """The text of a VTK message without the place in the source that it comes from. VTK gives None for one with bytes
    that are no UTF-8, as names in files can have."""
    message = message or "a message that is not UTF-8, expected text without special characters"
    _, _, text = message.partition("): ")
    return " ".join((text or message).split())
