# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The VTK classes, one per stage, reader and writer, and calls of these with errors as exceptions.

    from seismichorizons.vtk import apply, make, vtkHorizonSurface

    mesh = apply(make("vtkHorizonSurface", MaximumError=1.0), points)

Properties have the names of the documentation (`CellSize=3` calls `SetCellSize(3)`); a choice may be given by name
(`ZFrom="RealZ"`).
"""

import time
import warnings as warnings_of_python

import vtkmodules.vtkCommonExecutionModel  # noqa: F401: loads the VTK libraries, which are in another package
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING

from .vtkSeismicHorizons import *


def configure(algorithm, **properties):
    """Sets properties of an algorithm."""
    for name, value in properties.items():
        choose = getattr(algorithm, "Set%sTo%s" % (name, value), None)
        if choose:
            choose()
        else:
            getattr(algorithm, "Set" + name)(value)


def make(class_name, **properties):
    """Creates an algorithm by class name."""
    algorithm = globals()[class_name]()
    configure(algorithm, **properties)
    return algorithm


def apply(algorithm, *inputs, **properties):
    """Runs an algorithm on its inputs, one for each port, and returns its first output. Raises ValueError."""
    configure(algorithm, **properties)
    for port, data in enumerate(inputs):
        algorithm.SetInputDataObject(port, data)
    update(algorithm)
    return algorithm.GetOutputDataObject(0)


def update(algorithm, warnings=None):
    """Runs an algorithm and returns the time in seconds. Raises ValueError with the error message of the algorithm. Warnings
    are appended to a list; without one they are those of Python."""
    errors, found = [], [] if warnings is None else warnings
    observers = []
    # Algorithms report the cause of an error before their executives report the failure.
    for speaker in _upstream(algorithm):
        for observed in (speaker, speaker.GetExecutive()):
            observers.append((observed, observed.AddObserver("ErrorEvent", _collect(errors))))
        observers.append((speaker, speaker.AddObserver("WarningEvent", _collect(found))))
    start = time.monotonic()
    try:
        algorithm.Update()
    finally:
        for observed, tag in observers:
            observed.RemoveObserver(tag)
    seconds = time.monotonic() - start
    if warnings is None:
        for text in found:
            warnings_of_python.warn(text, stacklevel=2)
    if errors:
        raise ValueError(errors[0])
    return seconds


def horizons_of(output):
    """Returns the horizons of a collection that have points, by name."""
    found = {}
    for block in range(output.GetNumberOfPartitionedDataSets()):
        horizon = output.GetPartition(block, 0)
        if horizon is not None and horizon.GetNumberOfPoints():
            found[output.GetMetaData(block).Get(output.NAME())] = horizon
    return found


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
