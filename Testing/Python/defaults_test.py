# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Every property has a text, and what it says of default, range and choices is so in the C++ class and the plugin's XML; the
tables of the pages are those that the texts make.

Argument: the source tree.
"""

import pathlib
import re
import sys

import seismichorizons

TREE = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(TREE / "Utilities" / "CMake"))

import property_texts  # noqa: E402

# Setters that a proxy reaches in another way than by a property of their own.
REACHED_OTHERWISE = {
    "SetHorizonStatus": "GetHorizonSelection",
    "SetFileName": "AddFileName",
}
# Setters that ParaView has no use for: the controller is its own from the start, and inputs are connections.
NOT_REACHED = {"SetController", "SetInputData"}
# Names of version 0.2, which states reach in another way (Startup/RenamedProperties.h).
DEPRECATED = {"SetThreadWidth", "SetElevation"}
# ParaView's own values: its writers run on all processes.
IN_PARAVIEW = {"Gathered": "1"}
# Setters of VTK itself that have no getter.
NO_GETTER = {"SetInputArrayToProcess"}

problems = []


def expect(condition, message):
    if not condition:
        problems.append(message)


def numbers(text):
    return [float(n) for n in re.findall(r"[-+]?\d+(?:\.\d*)?(?:[eE][-+]?\d+)?", text)]


def getter_value(algorithm, command):
    value = getattr(algorithm, command.replace("Set", "Get", 1))()
    return list(value) if isinstance(value, (tuple, list)) else [value]


def said_default(text, prop, values):
    """The default that a text has, as the XML would."""
    if prop.find("BooleanDomain") is not None:
        return {"off": "0", "on": "1"}.get(text.default)
    return dict(values).get(text.default, text.default)


def check_default(where, prop, algorithm, text, values):
    actual = getter_value(algorithm, prop.get("command"))
    default = prop.get("default_values")
    if prop.get("name") in IN_PARAVIEW:
        expect(default == IN_PARAVIEW[prop.get("name")], "%s is %s in the XML" % (where, default))
        default = {"0": "1", "1": "0"}[default]
    if default is None:
        expect(actual in ([None], [""]) and text.default in ("none", "empty"),
               "%s has no default in the XML, but %s in C++, and %r in its text" % (where, actual, text.default))
        return
    said = said_default(text, prop, values)
    if prop.tag == "StringVectorProperty":
        expect([default] == actual == [said],
               "%s is %s in the XML, %s in C++, and %r in its text" % (where, default, actual, said))
    else:
        expect(numbers(default) == [float(v) for v in actual] == numbers(said or ""),
               "%s is %s in the XML, %s in C++, and %r in its text" % (where, default, actual, text.default))


def check_range(where, prop, text, values):
    """The choices of the panel are the enumerators, and its sliders stay within the range of the text."""
    entries = {entry.get("value"): entry.get("text").replace(" ", "").lower() for entry in prop.iter("Entry")}
    expect(entries == {value: name.lower() for name, value in values},
           "%s: choices %s in the XML, %s in C++" % (where, entries, values))
    for domain in prop:
        if domain.tag in ("IntRangeDomain", "DoubleRangeDomain"):
            expect(text.range, "%s has no range" % where)
            ends = re.fullmatch(r"(?:finite, )?(?:at least )?([-\d.e]+)(?: to ([-\d.e/]+))?", text.range or "")
            if ends:
                low, high = ends.group(1), ends.group(2)
                expect(numbers(domain.get("min", "-inf"))[:1] >= numbers(low),
                       "%s: from %s in the XML, %s in its text" % (where, domain.get("min"), low))
                if high and "/" not in high and not prop.get("name").endswith("Byte"):  # a field without a slider
                    expect(numbers(domain.get("max", "inf"))[:1] <= numbers(high) and domain.get("max"),
                           "%s: to %s in the XML, %s in its text" % (where, domain.get("max"), high))


def check_setters(where, cls, commands):
    """Every setter that the class itself has is reached by a property."""
    inherited = set(dir(next(base for base in cls.__mro__ if not base.__module__.startswith("seismichorizons"))))
    for name in sorted(set(dir(cls)) - inherited):
        shortcut = re.match(r"Set\w+To[A-Z]\w*$", name)
        if name.startswith("Set") and not shortcut and name not in NOT_REACHED | DEPRECATED:
            expect(name in commands or REACHED_OTHERWISE.get(name) in commands,
                   "%s: no property reaches %s::%s" % (where, cls.__name__, name))


def check_proxy(proxy, texts):
    cls = getattr(seismichorizons, proxy.class_name)
    algorithm = cls()
    help_text = proxy.element.find("Documentation")
    expect(help_text is not None and help_text.get("long_help") and len((help_text.text or "").split()) >= 4,
           "%s: long_help or help is missing" % proxy.name)
    expect(texts.headers[proxy.class_name].brief, "%s has no brief" % proxy.class_name)
    for prop in proxy.properties:
        where = "%s: %s" % (proxy.name, prop.get("name"))
        text = texts.find(proxy, prop)
        expect(text and len(text.meaning.split()) >= 4, "%s has no text" % where)
        command = prop.get("command", "")
        if not text or not command.startswith("Set") or prop.get("information_only") == "1":
            continue
        expect(text.default or command == "SetInputConnection", "%s has no default in its text" % where)
        if prop.tag != "InputProperty" and command not in NO_GETTER:
            values = texts.values(proxy, prop)
            check_default(where, prop, algorithm, text, values)
            check_range(where, prop, text, values)
    check_setters(proxy.name, cls, {prop.get("command") for prop in proxy.properties})


def main():
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
