# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Defaults and reach of every property: C++ class, plugin XML and documentation have to agree.

Arguments: the folder of the XML files and the folder of the documentation.
"""

import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

import seismichorizons

# Setters that a proxy reaches in another way than by a property of their own.
REACHED_OTHERWISE = {
    "SetHorizonStatus": "GetHorizonSelection",
    "SetFileName": "AddFileName",
}
# Setters that ParaView has no use for: the controller is its own from the start.
NOT_REACHED = {"SetController"}
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


def documented_defaults(page):
    """The table with the columns Property, Default, Range, Unit, Meaning as a dictionary."""
    found = {}
    columns = None
    for line in page.read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if not line.lstrip().startswith("|"):
            columns = None
        elif cells[:5] == ["Property", "Default", "Range", "Unit", "Meaning"]:
            columns = cells
        elif columns and not set(line) <= set("|-: "):
            expect(all(cells[:5]) and len(cells) >= 5, "%s: a cell is empty: %s" % (page.name, line))
            found[cells[0].strip("`")] = cells[1].strip("`")
    return found


def check_default(where, prop, algorithm, documented):
    name, command = prop.get("name"), prop.get("command")
    actual = getter_value(algorithm, command)
    default = prop.get("default_values")
    if default is None:
        expect(actual in ([None], [""]), "%s: %s has no default in the XML, but %s in C++" % (where, name, actual))
        return
    text = documented.get(name, "")
    if prop.tag == "StringVectorProperty":
        expect([default] == actual and text == default,
               "%s: %s is %s in the XML, %s in C++, and %r in the documentation" % (where, name, default, actual, text))
        return
    expect(numbers(default) == [float(v) for v in actual],
           "%s: %s is %s in the XML, but %s in C++" % (where, name, default, actual))
    entries = {e.get("value"): e.get("text").replace(" ", "") for e in prop.iter("Entry")}
    if entries:
        expect(text in (default, entries[default]),
               "%s: %s is %s in the XML, but %r in the documentation" % (where, name, entries[default], text))
    else:
        expect(numbers(text) == numbers(default),
               "%s: %s is %s in the XML, but %r in the documentation" % (where, name, default, text))


def check_help(where, element):
    help_text = element.find("Documentation")
    expect(help_text is not None and len((help_text.text or "").split()) >= 4,
           "%s: %s has no documentation" % (where, element.get("name")))


def check_setters(where, cls, commands):
    """Every setter that the class itself has is reached by a property."""
    inherited = set(dir(next(base for base in cls.__mro__ if not base.__module__.startswith("seismichorizons"))))
    for name in sorted(set(dir(cls)) - inherited):
        shortcut = re.match(r"Set\w+To[A-Z]\w*$", name)
        if name.startswith("Set") and not shortcut and name not in NOT_REACHED:
            expect(name in commands or REACHED_OTHERWISE.get(name) in commands,
                   "%s: no property reaches %s::%s" % (where, cls.__name__, name))


def list_properties(proxy, proxies):
    """The properties of a proxy, those of its bases first."""
    base = proxy.get("base_proxyname")
    inherited = list_properties(proxies[base], proxies) if base else []
    return inherited + [element for element in proxy if element.tag.endswith("Property")]


def check_proxy(proxy, properties, documentation):
    where = proxy.get("name")
    cls = getattr(seismichorizons, proxy.get("class"))
    algorithm = cls()
    help_text = proxy.find("Documentation")
    expect(help_text is not None and help_text.get("short_help") and help_text.get("long_help"),
           "%s: short_help or long_help is missing" % where)
    check_help(where, proxy)
    page = documentation / (where + ".md")
    expect(page.is_file(), "%s: there is no page %s" % (where, page.name))
    documented = documented_defaults(page) if page.is_file() else {}
    commands = set()
    for prop in properties:
        check_help(where, prop)
        command = prop.get("command", "")
        commands.add(command)
        if prop.tag == "InputProperty" or prop.get("information_only") == "1":
            continue
        expect(prop.get("name") in documented or command == "GetHorizonSelection",
               "%s: %s is not in the table of %s" % (where, prop.get("name"), page.name))
        if command.startswith("Set") and command not in NO_GETTER:
            check_default(where, prop, algorithm, documented)
    check_setters(where, cls, commands)


def main():
    xml_folder, documentation = (pathlib.Path(argument) for argument in sys.argv[1:3])
    proxies = {proxy.get("name"): proxy for file in sorted(xml_folder.glob("*.xml"))
               for kind in ("SourceProxy", "WriterProxy") for proxy in ElementTree.parse(file).iter(kind)}
    expect(len(proxies) >= 5, "only %d proxies in %s" % (len(proxies), xml_folder))
    for proxy in proxies.values():
        if proxy.get("class"):  # others are bases
            check_proxy(proxy, list_properties(proxy, proxies), documentation)
    for problem in problems:
        print(problem)
    sys.exit(1 if problems else 0)


main()
