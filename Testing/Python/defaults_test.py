# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The default in the comment of a setter is that of the class and of the functions of Python, sliders stay within the range, and
the tables of the pages are those that the comments make.

Argument: the source tree.
"""

import inspect
import pathlib
import re
import sys

import seismichorizons
from seismichorizons import vtk as sh

TREE = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(TREE / "Utilities" / "CMake"))

import property_texts  # noqa: E402

# ParaView's own values: its writers run on all processes.
IN_PARAVIEW = {"Gathered": "1"}

# Functions whose arguments have the names of properties.
STAGES = {"extract": "SeismicReflectionExtraction", "read_cube": "SEGYCubeReader", "despike": "HorizonDespiking", "faults": "HorizonFaults",
          "fill_holes": "HorizonHoleFilling", "surface": "HorizonSurface", "thickness": "HorizonThickness", "distance": "HorizonSurfaceDistance",
          "layers": "HorizonLayers", "crossings": "HorizonCrossings"}
FEWEST_COMPARED = 25

problems = []


def expect(condition, message):
    if not condition:
        problems.append(message)


def numbers(text):
    return [float(n) for n in re.findall(r"[-+]?\d+(?:\.\d*)?(?:[eE][-+]?\d+)?", text)]


def check_default(where, prop, algorithm):
    value = getattr(algorithm, prop.get("command").replace("Set", "Get", 1))()
    actual = list(value) if isinstance(value, (tuple, list)) else [value]
    default = prop.get("default_values")
    name = prop.get("name")
    if name in IN_PARAVIEW:
        expect(default == IN_PARAVIEW[name], "%s is %s in the panel" % (where, default))
    elif default is None:
        expect(actual in ([None], [""]), "%s has no default in its text, but %s in C++" % (where, actual))
    elif prop.tag == "StringVectorProperty":
        expect([default] == actual, "%s is %s in its text, %s in C++" % (where, default, actual))
    else:
        expect(numbers(default) == [float(v) for v in actual], "%s is %s in its text, %s in C++" % (where, default, actual))


def check_slider(where, prop, text):
    for domain in (*prop.findall("IntRangeDomain"), *prop.findall("DoubleRangeDomain")):
        expect(text.range, "%s has no range" % where)
        ends = re.fullmatch(r"(?:finite, )?(?:at least )?([-\d.e]+)(?: to ([-\d.e]+))?", text.range or "")
        if ends:
            low, high = (numbers(end or "") for end in ends.groups())
            expect(numbers(domain.get("min", "-inf"))[:1] >= low, "%s: from %s in the panel" % (where, domain.get("min")))
            expect(not high or not domain.get("max") or numbers(domain.get("max"))[:1] <= high,
                   "%s: to %s in the panel" % (where, domain.get("max")))


def check_proxy(proxy, texts):
    algorithm = getattr(sh, proxy.class_name)()
    help_text = proxy.element.find("Documentation")
    expect(help_text is not None and help_text.get("long_help") and len((help_text.text or "").split()) >= 4,
           "%s: long_help or help is missing" % proxy.name)
    for prop in proxy.properties:
        where = "%s: %s" % (proxy.name, prop.get("name"))
        text = texts.find(proxy, prop)
        expect(text and len(text.meaning.split()) >= 4, "%s has no text" % where)
        is_set = prop.get("command", "").startswith("Set") and prop.tag != "InputProperty"
        if is_set and prop.get("command") != "SetInputArrayToProcess":
            check_default(where, prop, algorithm)
            check_slider(where, prop, text)


def camel(text):
    return "".join(part.capitalize() for part in text.split("_"))


def check_functions():
    """Where an argument is not chosen by the class itself (None or empty), its default is that of the property."""
    compared = 0
    for function, stem in STAGES.items():
        stage = getattr(sh, "vtk" + stem)()
        for name, parameter in inspect.signature(getattr(seismichorizons, function)).parameters.items():
            get = getattr(stage, "Get" + camel(name), None)
            if get is None or parameter.default in (None, "", inspect.Parameter.empty) or get() is None:
                continue
            compared += 1
            default = getattr(stage, camel(parameter.default), None) if isinstance(parameter.default, str) else parameter.default
            expect(default == get(), "%s: %s is %r, %r in C++" % (function, name, parameter.default, get()))
    expect(compared >= FEWEST_COMPARED, "only %d arguments have the names of properties" % compared)


def main():
    check_functions()
    texts = property_texts.Texts(TREE)
    proxies = [proxy for proxy in texts.proxies.values() if not proxy.is_base]
    expect(len(proxies) >= 20, "only %d proxies" % len(proxies))
    for proxy in proxies:
        check_proxy(proxy, texts)
    for path, text, fresh in texts.pages():
        expect(text == fresh, "%s: its table is not that of the texts: build the target texts" % path.name)
    for problem in problems:
        print(problem)
    sys.exit(1 if problems else 0)


main()
