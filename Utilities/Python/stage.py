# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""One stage, that is one VTK algorithm: made with properties by their names, and run with errors as exceptions.

Properties are those of the documentation (`CellSize=3` calls `SetCellSize(3)`); one that is a choice may be given by
the name of the choice (`ZFrom="RealZ"`).
"""

import contextlib
import sys
import time
import warnings as warnings_of_python

import seismichorizons as sh
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkmodules.vtkCommonMisc import vtkErrorCode

from . import interrupt
from .progress import Progress


PACKAGE = __name__.partition(".")[0]

_hearers = []  # who gets the warnings that no caller collects; the last one does


class HorizonError(ValueError):
    """What the user should read: one line."""


@contextlib.contextmanager
def heard_by(hear):
    """Within the block, hear(text) gets the warnings of algorithms that no caller collects. Outside they are warnings of
    Python."""
    _hearers.append(hear)
    try:
        yield
    finally:
        _hearers.pop()


def warn(text):
    """A warning of Python, which names the line outside the package that led to it."""
    level, frame = 2, sys._getframe(1)
    while frame.f_back is not None and frame.f_globals.get("__name__", "").partition(".")[0] in (PACKAGE, "contextlib"):
        level, frame = level + 1, frame.f_back
    warnings_of_python.warn(text, stacklevel=level)


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
    (number, unit). With a list for warnings, those go there; else to heard_by.
    """
    start = time.monotonic()
    with watched(algorithm, label, warnings, work):
        algorithm.Update()
        return time.monotonic() - start


def update_writer(writer, label, warnings=None):
    """Runs a writer; errors name the file by a label, as it may lie in a folder for a while. Raises HorizonError, of files
    that cannot be written with these words."""
    try:
        update(writer, "%s: writing" % label, warnings)
    except HorizonError as error:
        is_of_disk = writer.GetErrorCode() in (vtkErrorCode.CannotOpenFileError, vtkErrorCode.OutOfDiskSpaceError)
        raise HorizonError("%s%s: %s" % (label, " cannot be written" if is_of_disk else "", str(error).replace(
            "%s: " % writer.GetFileName(), "", 1))) from None


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
    errors, told = [], [] if warnings is None else warnings
    progress = Progress(label, work)

    def on_progress(_caller, _event):
        if interrupt.is_asked():
            algorithm.AbortExecuteOn()
        progress.show(algorithm.GetProgress())

    observers = [(algorithm, algorithm.AddObserver("ProgressEvent", on_progress))]
    # Only algorithms say what is wrong; their executives repeat that something is.
    for speaker in _upstream(algorithm):
        for observed in (speaker, speaker.GetExecutive()):
            observers.append((observed, observed.AddObserver("ErrorEvent", _collect(errors))))
        observers.append((speaker, speaker.AddObserver("WarningEvent", _collect(told))))
    try:
        yield
    finally:
        for observed, tag in observers:
            observed.RemoveObserver(tag)
        progress.end()
    if warnings is None:
        for text in told:
            (_hearers[-1] if _hearers else warn)(text)
    interrupt.check()
    if errors:
        raise HorizonError(errors[0])


def _upstream(algorithm):
    """An algorithm, and those that its input comes from."""
    found = [algorithm]
    for one in found:
        for port in range(one.GetNumberOfInputPorts()):
            for number in range(one.GetNumberOfInputConnections(port)):
                source = one.GetInputAlgorithm(port, number)
                if source is not None and source not in found:
                    found.append(source)
    return found


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
