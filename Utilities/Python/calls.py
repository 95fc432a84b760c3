# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Calls VTK classes in the way Python users expect: with lower-case keywords, exceptions, warnings, a progress bar and
Ctrl-C. `CellSize` of the documentation is `cell_size` here."""

from __future__ import annotations

import contextlib
import re
import sys
import types
import warnings

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkCommonMisc import vtkErrorCode

from . import heights, interrupt, ledger, wording
from .stage import HorizonError, configure, heard_by, update
from .stage import warn as warn_in_python

SEQUENTIAL = "Sequential"  # VTK's initial back-end
QUIET_SECONDS = 1.0  # before a bar appears
MATRIX_SIZE = 16
MEMORY_WORDS = "more data than memory"  # occurs in all such messages
NOT_WRITTEN = "cannot be written"  # occurs in messages of the package
LATTICE_WORDS = "no field data array LatticeDimensions"
LATTICE_CURE = "; horizon_from_points(xyz) finds the lattice of points"
RENAMED = {"thread_width": "spur_width", "elevation": "z_from"}  # keywords of version 0.2


def snake(name):
    """Converts `CellSize` to `cell_size` and `Percentile95` to `percentile_95`."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])|(?<=[a-z])(?=[0-9])", "_", name).lower()


def properties(algorithm):
    """Returns the settable properties by keyword: {"cell_size": "CellSize"}."""
    of_vtk = next(kind for kind in type(algorithm).__mro__ if kind.__module__.startswith("vtkmodules"))
    names = [name[3:] for name in dir(algorithm) if name.startswith("Set") and hasattr(algorithm, "Get" + name[3:])]
    return {snake(name): name for name in names if not hasattr(of_vtk, "Set" + name)
            and ") -> vtk" not in getattr(algorithm, "Get" + name).__doc__}


def default(algorithm, name):
    """Returns the value of a property; for a choice, its name."""
    value = getattr(algorithm, "Get" + name)()
    return next((choice for choice in _choices(algorithm, name) if getattr(algorithm, choice, None) == value), value)


def _choices(algorithm, name):
    """Returns the names of the choices of a property."""
    start = "Set%sTo" % name
    return [method[len(start):] for method in dir(algorithm) if method.startswith(start)]


def set_keywords(algorithm, keywords, horizon=None):
    """Sets properties by keyword. Heights with a unit, such as "2 ms", are converted to the unit of z of the horizon.
    Returns that unit, or an empty text. Raises ValueError and TypeError."""
    known = properties(algorithm)
    given = {}
    for keyword, value in keywords.items():
        if RENAMED.get(keyword) in known:
            text = "keyword %s, expected %s, its new name" % (keyword, RENAMED[keyword])
            warnings.warn(text, FutureWarning, stacklevel=3)
            keyword = RENAMED[keyword]
        if keyword not in known:
            raise TypeError("%s, expected one of %s" % (keyword, ", ".join(known)))
        given[known[keyword]] = value
    words = {name: value for name, value in given.items()
             if isinstance(value, str) and isinstance(getattr(algorithm, "Get" + name)(), float) and horizon is not None}
    numbers = {name: heights.Height(text) for name, text in words.items()}
    if words:
        with python_errors(algorithm):
            given.update(heights.in_unit_of(numbers, horizon))
        units = [name for name in known.values() if hasattr(algorithm, "Set%sToWorld" % name)]
        step = heights.step_of(horizon)
        if step is None or any(name in given for name in units):
            given.update({name: "World" for name in units if any(number.unit for number in numbers.values())})
        else:  # heights without a unit, or with their default, are in vertical indices
            given.update({name: given[name] / step for name, number in numbers.items() if number.unit})
    for name, value in given.items():
        choices = _choices(algorithm, name)
        if isinstance(value, str) and choices and value not in choices:
            raise ValueError("%s '%s', expected one of %s" % (snake(name), value, ", ".join(choices)))
        try:
            configure(algorithm, **{name: value})
        except TypeError as error:
            raise TypeError("%s (%s)" % (snake(name), error)) from None
    return next((number.unit for number in numbers.values() if number.unit), "")


def run(algorithm, label):
    """Runs an algorithm on all processors. Its error becomes an exception, and its warnings become Python warnings."""
    messages = []
    backend = vtkSMPTools.GetBackend()
    vtkSMPTools.SetBackend("STDThread" if backend == SEQUENTIAL else backend)
    observer = _Bar(label)
    tag = algorithm.AddObserver("ProgressEvent", lambda *_: observer.show(algorithm.GetProgress()))
    try:
        with interrupt.noting():
            update(algorithm, warnings=messages)
    except HorizonError as error:
        raise _exception(_with_keywords(str(error), algorithm), algorithm) from None
    finally:
        algorithm.RemoveObserver(tag)
        vtkSMPTools.SetBackend(backend)
        observer.end()
    if algorithm.IsA("vtkHorizonSurface"):
        messages += filter(None, [ledger.warning(ledger.read(algorithm.GetOutputDataObject(0)))])
    for text in messages:
        warn(text, algorithm)


def warn(text, algorithm=None):
    """Issues a warning with keywords in place of options and properties."""
    warn_in_python(_with_keywords(text, algorithm))


@contextlib.contextmanager
def python_errors(algorithm=None):
    """Within the block, a HorizonError of the package is raised as ValueError, or as OSError if a file cannot be written.
    Errors and warnings name keywords in place of options."""
    try:
        with heard_by(warn):
            yield
    except HorizonError as error:
        kind = OSError if NOT_WRITTEN in str(error) else ValueError
        raise kind(_with_keywords(str(error), algorithm)) from None


def _with_keywords(text, algorithm):
    """Returns a message with keywords in place of options and properties."""
    names = {} if algorithm is None else {name: keyword for keyword, name in properties(algorithm).items()}
    text = wording.rename(text, names, wording.as_keyword)
    text = re.sub(r"--([a-z][a-z-]*)", lambda found: found[1].replace("-", "_") + "=", text)
    return text + (LATTICE_CURE if LATTICE_WORDS in text else "")


def _exception(text, algorithm):
    """Returns the Python exception for an error of VTK."""
    if MEMORY_WORDS in text:
        return MemoryError(text)
    code = algorithm.GetErrorCode()
    if code == vtkErrorCode.FileNotFoundError:
        return FileNotFoundError(text)
    if code in (vtkErrorCode.CannotOpenFileError, vtkErrorCode.OutOfDiskSpaceError):
        return OSError(text)
    return ValueError(text)


class _Bar:
    """Progress bar of a long call, by tqdm if it is installed."""

    def __init__(self, label):
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # tqdm warns in notebooks without widgets
                from tqdm.auto import tqdm
        except ImportError:
            self._bar = None
        else:
            self._bar = tqdm(total=1.0, desc=label, delay=QUIET_SECONDS, leave=False,
                             bar_format="{desc}: {percentage:3.0f}% |{bar}| {remaining} left")

    def show(self, fraction):
        if self._bar is not None:
            self._bar.update(fraction - self._bar.n)

    def end(self):
        if self._bar is not None:
            self._bar.close()


def wrap(data):
    """Returns data as PyVista objects if PyVista is imported, otherwise unchanged."""
    pyvista = sys.modules.get("pyvista")
    return data if pyvista is None or data is None else pyvista.wrap(data)


def require_points(data, what):
    """Raises TypeError if something is not a VTK dataset, and ValueError if it has no points."""
    require_data(data, what)
    if not data.GetNumberOfElements(vtkDataObject.POINT):
        raise ValueError("%s without points, expected some" % what)


def require_data(data, what):
    """Raises TypeError if something is not a VTK dataset."""
    if not isinstance(data, vtkDataObject):
        raise TypeError("%s, expected %s as a dataset of VTK or PyVista: horizon(z) makes one of an array of heights, "
                        "horizon_from_points(xyz) of points, read(path) of a file" % (type(data).__name__, what))


class Details(types.SimpleNamespace):
    """The metadata of a dataset as attributes: `vertical_unit`, `largest_error` and others (see DataModel.md)."""


def details(data: vtkDataObject) -> Details:
    """Returns the field data of a horizon or a mesh as attributes.

    Parameters
    ----------
    data : vtkDataObject
        Result of any function of this package.

    Returns
    -------
    Details
        Single values as numbers and texts, several values as a numpy array or a list of texts, named components as
        attributes such as `ledger_columns.left_out`, and `lattice_to_world` as a 4 x 4 array. Errors are in vertical
        indices or, if the result was requested with a unit such as "2 m", in that unit, as numbers with an attribute
        `unit`.

    Examples
    --------
    >>> import numpy as np, seismichorizons as sh
    >>> sh.details(sh.horizon(np.zeros((4, 5)), spacing=(25, 25), vertical_unit="ms")).vertical_unit
    'ms'
    """
    require_data(data, "it")
    fields = data.GetFieldData()
    arrays = [fields.GetAbstractArray(number) for number in range(fields.GetNumberOfArrays())]
    found = {array.GetName(): _value(array) for array in arrays if (array.GetName() or "").isidentifier()}
    unit = heights.unit_of(data, heights.NOTED_UNIT)
    for name in found.keys() & set(heights.FIGURES) if unit else ():
        found[name] = heights.Height.of(found[name] * heights.per_index(data, unit), unit)
    return Details(**{snake(name): value for name, value in found.items()})


def _value(array):
    if not array.IsNumeric():
        texts = [array.GetValue(number) for number in range(array.GetNumberOfValues())]
        return texts[0] if len(texts) == 1 else texts
    numbers = vtk_to_numpy(array)
    if array.HasAComponentName() and array.GetNumberOfTuples() == 1:
        return Details(**{snake(array.GetComponentName(n)): number.item() for n, number in enumerate(numbers[0])})
    if numbers.size == 1:
        return numbers.reshape(-1)[0].item()
    return numbers.reshape(4, 4).copy() if numbers.shape == (1, MATRIX_SIZE) else numbers.squeeze().copy()
