# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Each stage as a function, generated from its class: `hole_filling` is HorizonHoleFilling with its properties as keywords.

    python -m seismichorizons.stages

prints the signatures for editors and type checkers.
"""

import inspect
import textwrap

import seismichorizons

from . import calls, heights
from .stage import make

STAGE = "vtkHorizon"
# Classes whose functions are hand-written (functions.py, volumes.py).
OWN = ("vtkHorizonCrossings", "vtkHorizonLayers", "vtkHorizonSurface", "vtkHorizonSurfaceDistance")
INPUTS = ("horizon", "other")
TEXT_WIDTH = 76  # characters, as in the documentation of classes
TYPES = {bool: "bool", int: "int", float: "float | str", str: "str"}  # types of keywords; heights may have a unit


def apply(class_name, inputs, keywords):
    """Runs a stage and returns its first output."""
    for data in inputs:
        calls.require_points(data, "a horizon")
    algorithm = make(class_name)
    unit = calls.set_keywords(algorithm, keywords, inputs[0])
    for port, data in enumerate(inputs):
        algorithm.SetInputDataObject(port, data)
    calls.run(algorithm, calls.snake(class_name[len(STAGE):]))
    if unit or "maximum_error" in keywords:
        heights.note_unit(algorithm.GetOutputDataObject(0), unit)
    return calls.wrap(algorithm.GetOutputDataObject(0))


def _make_stage(class_name, algorithm):
    """Returns the function of a stage, which takes its inputs and then its properties as keywords."""
    known = calls.properties(algorithm)
    names = INPUTS[:algorithm.GetNumberOfInputPorts()]

    def stage(*inputs, **keywords):
        if not 1 <= len(inputs) <= len(names):
            raise TypeError("%d datasets, expected %s" % (len(inputs), " and ".join(names)))
        return apply(class_name, inputs, keywords)

    stage.__name__ = stage.__qualname__ = calls.snake(class_name[len(STAGE):])
    stage.__doc__ = _text(class_name, names, known)
    stage.__signature__ = inspect.Signature([
        *(inspect.Parameter(name, inspect.Parameter.POSITIONAL_ONLY,
                            default=inspect.Parameter.empty if name == names[0] else None) for name in names),
        *(inspect.Parameter(keyword, inspect.Parameter.KEYWORD_ONLY, default=calls.default(algorithm, name))
          for keyword, name in known.items())])
    return stage


def _text(class_name, names, known):
    """Returns the docstring of a stage's function, from the documentation of its class."""
    made = getattr(seismichorizons, class_name)
    title, _, rest = made.__doc__.partition("\n\nSuperclass:")
    title = " ".join(title.partition(" - ")[2].split())
    lines = [title[:1].upper() + title[1:] + ".", "", rest.partition("\n\n")[2].strip().replace("@sa ", "See also "), "",
             "Parameters", "----------",
             *(name + " : vtkPolyData" + ("" if name == names[0] else ", optional") for name in names)]
    for keyword, name in known.items():
        text = " ".join((getattr(made, "Set" + name).__doc__ or "").partition("\n\n")[2].split())
        lines += [keyword, *textwrap.wrap(text, TEXT_WIDTH, initial_indent="    ", subsequent_indent="    ")]
    return "\n".join([*lines, "", "Returns", "-------", "vtkPolyData, or pyvista.PolyData if PyVista is imported", "",
                      "Raises", "------", "TypeError, ValueError",
                      "    If the input is not a horizon, or a parameter is out of range.", ""])


def _make_stages():
    """Returns the functions of all other stages by name."""
    made = {}
    for class_name in dir(seismichorizons):
        kind = getattr(seismichorizons, class_name)
        if class_name not in OWN and isinstance(kind, type) and issubclass(kind, seismichorizons.vtkHorizonStage):
            try:
                algorithm = kind()
            except (NotImplementedError, TypeError):
                continue  # the class is abstract
            function = _make_stage(class_name, algorithm)
            made[function.__name__] = function
    return made


STAGES = _make_stages()
globals().update(STAGES)
__all__ = [*STAGES]


def print_types():
    """Prints the signatures of all stages."""
    print("from collections.abc import Sequence\n\nfrom vtkmodules.vtkCommonDataModel import vtkPolyData\n")
    for name, function in STAGES.items():
        words = []
        for parameter in inspect.signature(function).parameters.values():
            if parameter.kind is parameter.POSITIONAL_ONLY:
                words.append(parameter.name + (": vtkPolyData" if parameter.default is parameter.empty else
                                               ": vtkPolyData | None = ..."))
            else:
                words.append("%s: %s = ..." % (parameter.name, TYPES.get(type(parameter.default), "Sequence[float]")))
        number = sum(word.split(":")[0] in INPUTS for word in words)
        print("def %s(%s, /, *, %s) -> vtkPolyData: ..." % (name, ", ".join(words[:number]), ", ".join(words[number:])))


if __name__ == "__main__":
    print_types()
