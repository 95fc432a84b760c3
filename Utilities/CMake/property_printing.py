# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the methods PrintSelf of all classes, which print their properties and results, into a source file.

    property_printing.py FILE HEADER...

A class that has more to print than these has a method of its own in its .cxx.
"""

import pathlib
import re
import sys

from property_panels import SWITCHES, read_methods, read_values

START = """// Made by property_printing.py.
#include <algorithm> // for std::find_if
#include <initializer_list>
#include <utility> // for std::pair

%s
namespace
{
/// The name of a choice.
const char* NameOf(int value, std::initializer_list<std::pair<int, const char*>> names)
{
  const auto found = std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.first == value; });
  return found == names.end() ? "unknown" : found->second;
}

const char* PrintedText(const char* text)
{
  return text ? text : "(none)";
}
}
"""
METHOD = """
void %s::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
%s}
"""


def printed(name, kind, length, values):
    """The value of a property as it is put into a stream."""
    member = "this->" + name
    if values:
        return "NameOf(%s, { %s })" % (member, ", ".join('{ %s, "%s" }' % (choice, choice) for choice, _ in values))
    if kind in SWITCHES:
        return '(%s ? "on" : "off")' % member
    if kind == "text":
        return "PrintedText(this->Get%s())" % name
    return " << ' ' << ".join("%s[%d]" % (member, n) for n in range(int(length))) if length != "1" else member


def print_self(class_name, text):
    values = read_values(text)
    properties = {command[3:]: shape for command, shape in read_methods(text).items()}
    lines = ["  this->Files.Print(os, indent);\n"] if "vtkHorizonFileNamesMacro();" in text else []
    lines += ['  os << indent << "%s: " << %s << "\\n";\n' % (name, printed(name, *shape, values.get(name)))
              for name, shape in properties.items()]
    return METHOD % (class_name, "".join(lines))


def main():
    headers = [pathlib.Path(argument) for argument in sys.argv[2:]]
    written = {}
    for header in sorted(headers, key=lambda path: path.name):
        text = header.read_text(encoding="utf-8")
        has_own = re.search(r"::PrintSelf\(", header.with_suffix(".cxx").read_text(encoding="utf-8"))
        if "void PrintSelf(ostream& os, vtkIndent indent) override;" in text and not has_own:
            written[header.stem] = print_self(header.stem, text)
    includes = "".join('#include "%s.h"\n' % name for name in written)
    pathlib.Path(sys.argv[1]).write_text(START % includes + "".join(written.values()), encoding="utf-8")


main()
