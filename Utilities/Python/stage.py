# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""One stage, which is a VTK algorithm: created with properties by name, and run with errors as exceptions.

Properties have the names of the documentation (`CellSize=3` calls `SetCellSize(3)`); a choice may be given by name
(`ZFrom="RealZ"`).
"""

import contextlib
import os
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

_hearers = []  # handlers of warnings that no caller collects; the last one is used


class HorizonError(ValueError):
    """An error with a one-line message for the user."""


@contextlib.contextmanager
def heard_by(hear):
    """Passes algorithm warnings that no caller collects to hear(text) within the block. Outside, they are Python warnings."""
    _hearers.append(hear)
    try:
        yield
    finally:
        _hearers.pop()


def warn(text):
    """Issues a Python warning that names the calling line outside the package."""
    level, frame = 2, sys._getframe(1)
    while frame.f_back is not None and frame.f_globals.get("__name__", "").partition(".")[0] in (PACKAGE, "contextlib"):
        level, frame = level + 1, frame.f_back
    warnings_of_python.warn(text, stacklevel=level)


def set_threads(number):
    """Sets the number of threads of the stages; 0 means all processors."""
    # The default back-end of many VTK builds is sequential.
    vtkSMPTools.SetBackend("STDThread")
    vtkSMPTools.Initialize(number)


def share_threads(number, jobs):
    """Sets the share of one of several processes in a number of threads; 0 means all processors."""
    available = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    set_threads(max(1, (number or available) // jobs))


def configure(algorithm, **properties):
    for name, value in properties.items():
        choose = getattr(algorithm, "Set%sTo%s" % (name, value), None)
        if choose:
            choose()
        else:
            getattr(algorithm, "Set" + name)(value)


def make(class_name, **properties):
    """Creates an algorithm of this package by class name."""
    algorithm = getattr(sh, class_name)()
    configure(algorithm, **properties)
    return algorithm


def update(algorithm, label="", warnings=None, work=None):
    """Runs an algorithm and returns the time in seconds. Raises HorizonError with the error message of the algorithm.

    With a label, the progress of a long run is shown on the terminal; `work` is the amount of work, as (number, unit).
    Warnings are appended to a list `warnings`; without one they go to heard_by.
    """
    start = time.monotonic()
    with watched(algorithm, label, warnings, work):
        algorithm.Update()
        return time.monotonic() - start


def update_writer(writer, label, warnings=None):
    """Runs a writer; errors name the file by a label, because it may be in a temporary folder. Raises HorizonError, which
    says "cannot be written" for errors of the file system."""
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
    """Watches an algorithm while the block runs, and raises its first error as HorizonError. If the program has been asked
    to end, stops the algorithm and raises SystemExit."""
    errors, found_warnings = [], [] if warnings is None else warnings
    progress = Progress(label, work)

    def on_progress(_caller, _event):
        if interrupt.is_asked():
            algorithm.AbortExecuteOn()
        progress.show(algorithm.GetProgress())

    observers = [(algorithm, algorithm.AddObserver("ProgressEvent", on_progress))]
    # Algorithms report the cause of an error before their executives report the failure.
    for speaker in _upstream(algorithm):
        for observed in (speaker, speaker.GetExecutive()):
            observers.append((observed, observed.AddObserver("ErrorEvent", _collect(errors))))
        observers.append((speaker, speaker.AddObserver("WarningEvent", _collect(found_warnings))))
    try:
        yield
    finally:
        for observed, tag in observers:
            observed.RemoveObserver(tag)
        progress.end()
    if warnings is None:
        for text in found_warnings:
            (_hearers[-1] if _hearers else warn)(text)
    interrupt.check()
    if errors:
        raise HorizonError(errors[0])


def _upstream(algorithm):
    """Returns an algorithm and all algorithms upstream of it."""
    found = [algorithm]
    for one in found:
        for port in range(one.GetNumberOfInputPorts()):
            for number in range(one.GetNumberOfInputConnections(port)):
                source = one.GetInputAlgorithm(port, number)
                if source is not None and source not in found:
                    found.append(source)
    return found


def _collect(messages):
    """Returns an observer that collects error or warning messages."""

    @calldata_type(VTK_STRING)
    def on_message(_caller, _event, message):
        messages.append(_one_line(message))

    return on_message


def _one_line(message):
    """Returns a VTK message without its source location. VTK passes None for a message that is not UTF-8, as names in files
    may be."""
    message = message or "a message that is not UTF-8, expected text without special characters"
    _, _, text = message.partition("): ")
    return " ".join((text or message).split())
