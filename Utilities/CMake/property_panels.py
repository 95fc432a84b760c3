# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Expands the properties that an XML file of the plugin names into elements of ParaView.

`<Property name="Threshold"/>` in a PropertyGroup, or in a proxy outside of groups, becomes an element with the command, the
number of elements, the default and the domain that the header of the class states. Attributes describe the panel:

    label, panel_visibility, ...  as in ParaView
    min, max            ends of the slider that differ from the range; an empty text removes one
    special             the text of a switch that sets the default, or special_value ("0"), in place of a number
    placeholder         the text of an empty field
    components          labels of the numbers of one property
    visible_if          when it is shown: "Method=Plate" for a choice, "KeepHoles=on" for a switch, "Target!=LargestError"
                        for other choices, "Gridding=Plate|Nearest" for two choices, "A=on and B=off" for both conditions
    enabled_if          the same conditions; it is shown in grey otherwise
    entries             "IbmFloat: IBM Float; IeeeFloat: IEEE Float": labels of choices that differ from their names

A getter without a setter is information: a text is a box of the panel, a number is not shown. FileName and HorizonStatus
add the properties that ParaView needs for series of files and lists of horizons. `<Input name="Other">Its text.</Input>` is
an input of types="vtkPolyData vtkUnstructuredGrid", which may be composite unless single="1". several="1" takes several
connections; optional="1" needs none, and is chosen in the panel.
"""

import re
import xml.etree.ElementTree as ElementTree

ELEMENTS = {"bool": "Int", "int": "Int", "vtkIdType": "Int", "vtkTypeBool": "Int", "double": "Double", "text": "String"}
SWITCHES = ("bool", "vtkTypeBool")
FOR_PANEL = {"name", "min", "max", "special", "special_value", "placeholder", "components", "visible_if", "enabled_if",
             "entries", "header"}
FILES = """
<Parts>
  <StringVectorProperty name="FileName" command="AddFileName" clean_command="ClearFileNames" repeat_command="1" animateable="0"
                        number_of_elements="0" number_of_elements_per_command="1" panel_visibility="never">
    <FileListDomain name="files"/>
  </StringVectorProperty>
  <DoubleVectorProperty name="TimestepValues" information_only="1" repeat_command="1" si_class="vtkSITimeStepsProperty">
    <TimeStepsInformationHelper/>
    <Documentation>The times of a series.</Documentation>
  </DoubleVectorProperty>
</Parts>"""
HORIZONS = """
<Parts>
  <StringVectorProperty name="HorizonInfo" command="GetHorizonSelection" information_only="1" number_of_elements_per_command="2"
                        si_class="vtkSIDataArraySelectionProperty"/>
  <IdTypeVectorProperty name="HorizonSizes" command="GetHorizonSizes" information_only="1" si_class="vtkSIDataArrayProperty"/>
  <StringVectorProperty name="HorizonStatus" panel_widget="horizon_list" label="Horizon Status" command="GetHorizonSelection"
                        information_property="HorizonInfo" animateable="0" element_types="2 0" number_of_elements="0"
                        number_of_elements_per_command="2" repeat_command="1" si_class="vtkSIDataArraySelectionProperty">
    <ArraySelectionDomain name="array_list">
      <RequiredProperties><Property function="ArrayList" name="HorizonInfo"/></RequiredProperties>
    </ArraySelectionDomain>
    <Hints><HorizonList sizes="HorizonSizes" header="Points"/></Hints>
  </StringVectorProperty>
</Parts>"""


def with_blanks(name):
    """A name as ParaView shows it."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])|(?<=[a-z])(?=[0-9])", " ", name)


def in_paraview(entry):
    """The attributes of a name that ParaView has as well."""
    return {key: value for key, value in entry.attrib.items() if key not in FOR_PANEL}


def read_methods(lines):
    """Setters and getters among the lines of a class, with the type and the number of their values."""
    methods = {}
    macro = r"^  vtk(Set|Get|Horizon)(\w*?)Macro\((\w+)(?:, (\w+))?(?:, (\d))?"
    for access, kind, name, of, length in re.findall(macro, lines, re.M):
        of = "text" if kind in ("String", "FilePath", "Text") else "bool" if kind == "Flag" else "int" if "Choice" in kind else of
        for method in ("Set", "Get") if access == "Horizon" else (access,):
            methods[method + name] = (of, length if kind == "Vector" else "1")
    for name in re.findall(r"^  const char\* (Get\w+)\(\)", lines, re.M):
        methods[name] = ("text", "1")
    return methods


def read_values(text):
    """The names of the choices of each property in a header, with their numbers as texts."""
    enums = re.findall(r"/// Values of (\w+)[^\n]*\n  enum \w+\n  {\n(.*?)  };", text, re.S)
    values = {name: re.findall(r"(\w+) = (\d+)", body) for name, body in enums}
    for name, names in re.findall(r"vtkHorizonChoice\dMacro\((\w+),\s+\w+,\s+(.*?)\)", text, re.S):
        values[name] = [(value, str(number)) for number, value in enumerate(re.split(r",\s+", names))]
    return values


def _ends(text):
    """The ends of a range in words, as texts; None for those it does not have."""
    found = re.search(r"(?:at least |^|, )(-?[\d.e]+)(?: to (-?[\d.e]+)(/\d+)?)?", text or "")
    if not found:
        return {}
    low, high, divisor = found.groups()
    if ", or -1" in text:
        low = "-1"
    if divisor:
        high = repr(float(high) / float(divisor[1:]))
    return {"min": low, **({"max": high} if high else {})}


class Expander:
    """Makes the elements of one proxy. `facts` gives texts, methods and values of the class by its names."""

    def __init__(self, proxy, facts):
        self.proxy = proxy
        self.facts = facts

    def fail(self, words):
        raise SystemExit("%s: %s" % (self.proxy.get("name"), words))

    def expand(self):
        """Puts elements in place of names; the properties are then in the order in which they are named."""
        made, groups = [], []
        for child in self.proxy:
            if child.tag == "Property":
                made += self.make(child)
            elif child.tag == "Input":
                made.append(self.make_input(child))
            elif child.tag == "PropertyGroup":
                groups.append(child)
                made += [element for entry in list(child) for element in self.make_grouped(entry, child)]
            elif child.tag == "Hints":
                groups.append(child)
            else:
                made.append(child)
        self.proxy[:] = made + groups

    def add_unnamed(self, reached):
        """Puts properties that the file does not name behind the others. `reached` are commands of base properties."""
        own = [child for child in self.proxy if child.tag.endswith("Property")]
        reached = reached | {child.get("command") for child in own}
        names = [method[3:] for method in self.facts.methods if method.startswith("Set") and method not in reached]
        end = list(self.proxy).index(own[-1]) + 1 if own else 0
        self.proxy[end:end] = [element for name in names for element in self.make(ElementTree.Element("Property", name=name))]

    def make_grouped(self, entry, group):
        """The elements of a property that a group names; the group then has its name alone."""
        named = {child.get("name") for child in self.proxy if child.tag.endswith("Property")}
        if entry.get("name") in named:
            return []
        group[list(group).index(entry)] = ElementTree.Element("Property", name=entry.get("name"))
        return self.make(entry) if entry.tag == "Property" else [entry]

    def make_input(self, entry):
        attributes = dict(entry.attrib)
        types = attributes.pop("types", "vtkPolyData vtkUnstructuredGrid").split()
        several = attributes.pop("several", None)
        single = attributes.pop("single", None)
        optional = attributes.pop("optional", None)
        name = attributes.pop("name", "Input")
        usual = {"command": "AddInputConnection", "clean_command": "RemoveAllInputs", "multiple_input": "1"} if several \
            else {"command": "SetInputConnection"}
        if optional:
            attributes = {"panel_visibility": "default", "panel_widget": "input_selector", **attributes}
        element = ElementTree.Element("InputProperty", {"name": name, **usual, **attributes})
        groups = ElementTree.SubElement(element, "ProxyGroupDomain", name="groups")
        for group in ("sources", "filters"):
            ElementTree.SubElement(groups, "Group", name=group)
        domain = ElementTree.SubElement(element, "DataTypeDomain", name="input_type",
                                        **({} if single else {"composite_data_supported": "1"}))
        for kind in types:
            ElementTree.SubElement(domain, "DataType", value=kind)
        element.extend(list(entry))
        if optional:
            ElementTree.SubElement(ElementTree.SubElement(element, "Hints"), "Optional")
        text = " ".join("".join(entry.itertext()).split())
        if text:
            ElementTree.SubElement(element, "Documentation").text = text
        return element

    def make(self, entry):
        """The elements of a property."""
        name = entry.get("name")
        if name == "FileName" and "AddFileName" in self.facts.texts:
            return list(ElementTree.fromstring(FILES))
        if name == "HorizonStatus":
            made = list(ElementTree.fromstring(HORIZONS))
            made[-1].find("Hints/HorizonList").set("header", entry.get("header", "Points"))
            made[-1].attrib.update(in_paraview(entry))
            return made
        command = next((access + name for access in ("Set", "Get") if access + name in self.facts.methods), None)
        if not command:
            self.fail("%s is no property of its class" % name)
        kind, length = self.facts.methods[command]
        element = ElementTree.Element(ELEMENTS[kind] + "VectorProperty", name=name, command=command, number_of_elements=length)
        if command.startswith("Get"):
            self.complete_information(element, kind)
        else:
            self.complete(element, entry, kind)
        element.attrib.update(in_paraview(entry))
        self.add_hints(element, entry)
        return [element]

    def complete_information(self, element, kind):
        element.set("information_only", "1")
        if kind == "text":
            element.set("panel_visibility", "default")
            ElementTree.SubElement(ElementTree.SubElement(element, "Hints"), "Widget", type="multi_line")
        else:
            element.set("default_values", "0")
            element.set("panel_visibility", "never")

    def complete(self, element, entry, kind):
        """The default and the domain of a property that can be set."""
        name = element.get("name")
        text = self.facts.texts.get(element.get("command"))
        if not text or not text.default:
            self.fail("%s has no default, expected a comment of its setter that ends with one" % name)
        values = self.facts.values.get(name, [])
        default = self.number(name, text.default)
        if kind != "text" or default not in ("empty", "none"):
            element.set("default_values", default if kind == "text" else default.replace(",", ""))
        if values:
            self.add_entries(element, entry, values)
        elif kind in SWITCHES:
            ElementTree.SubElement(element, "BooleanDomain", name="bool")
        elif kind != "text":
            ends = {**_ends(text.range), **{end: entry.get(end) for end in ("min", "max") if entry.get(end) is not None}}
            ElementTree.SubElement(element, ELEMENTS[kind] + "RangeDomain",
                                   {"name": "range", **{end: value for end, value in ends.items() if value}})

    def add_entries(self, element, entry, values):
        """The choices; Automatic comes first."""
        words = dict(pair.split(": ") for pair in entry.get("entries", "").split("; ") if pair)
        domain = ElementTree.SubElement(element, "EnumerationDomain", name="enum")
        for name, value in sorted(values, key=lambda pair: pair[0] != "Automatic"):
            ElementTree.SubElement(domain, "Entry", text=words.pop(name, with_blanks(name)), value=value)
        if words:
            self.fail("%s has no choices %s" % (element.get("name"), ", ".join(words)))

    def number(self, name, value):
        """A choice or a switch as its number; other values as they are."""
        values = {"off": "0", "on": "1", **dict(self.facts.values.get(name, []))}
        if name in self.facts.values and value not in values:
            self.fail("%s, expected one of %s for %s" % (value, ", ".join(values), name))
        return values.get(value, value)

    def add_hints(self, element, entry):
        hints = element.find("Hints")
        hints = ElementTree.Element("Hints") if hints is None else hints
        if entry.get("placeholder"):
            ElementTree.SubElement(hints, "PlaceholderText").text = entry.get("placeholder")
        if entry.get("components"):
            labels = ElementTree.SubElement(hints, "ShowComponentLabels")
            for number, label in enumerate(entry.get("components").split()):
                ElementTree.SubElement(labels, "ComponentLabel", component=str(number), label=label)
        text = self.facts.texts.get(element.get("command"))
        unit = text.unit if text and re.fullmatch(r"\w+Unit", text.unit or "") else None
        special = {"text": entry.get("special"), "value": entry.get("special_value", element.get("default_values"))}
        if entry.get("special") or unit:
            ElementTree.SubElement(hints, "PropertyWidgetDecorator", type="HorizonSpecialValue",
                                   **(special if entry.get("special") else {}), **({"unit": unit} if unit else {}))
        for condition, mode in (("visible_if", "visibility"), ("enabled_if", "enabled_state")):
            if entry.get(condition):
                hints.append(self.decorator(entry.get(condition), mode))
        for own in entry:
            hints.extend(own) if own.tag == "Hints" else element.append(own)
        if len(hints) and element.find("Hints") is None:
            element.append(hints)

    def decorator(self, condition, mode):
        terms = [self.term(term, mode) for term in condition.split(" and ")]
        if len(terms) == 1:
            return terms[0]
        composite = ElementTree.Element("PropertyWidgetDecorator", type="CompositeDecorator")
        ElementTree.SubElement(composite, "Expression", type="and").extend(terms)
        return composite

    def term(self, term, mode):
        name, inverse, words = re.fullmatch(r"(\w+)(!?)=([\w|]+)", term).groups()
        values = [self.number(name, word) for word in words.split("|")]
        if "Set" + name not in self.facts.methods or not all(value.isdigit() for value in values):
            self.fail("%s, expected a choice or a switch of the class" % term)
        element = ElementTree.Element("PropertyWidgetDecorator", type="GenericDecorator", mode=mode, property=name)
        element.set("value" if len(values) == 1 else "values", " ".join(values))
        if inverse:
            element.set("inverse", "1")
        return element
