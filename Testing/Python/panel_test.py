# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The panels of the plugin are in order, and its hints name what is there. Argument: the source tree."""

import json
import pathlib
import re
import sys
import unittest
import xml.etree.ElementTree as ElementTree

TREE = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(TREE / "Utilities" / "CMake"))

import property_texts  # noqa: E402

PROXIES = {name: proxy.element for name, proxy in property_texts.Texts(TREE).proxies.items()}


def lineage(proxy):
    base = PROXIES.get(proxy.get("base_proxyname"))
    return (lineage(base) if base is not None else []) + [proxy]


def properties(proxy):
    return [element for part in lineage(proxy) for element in part if element.tag.endswith("Property")]


def groups(proxy):
    return [group for part in lineage(proxy) for group in part.findall("PropertyGroup")]


def is_shown(prop):
    """Whether it is a line of the panel; what is only told is shown when the XML says so."""
    is_told = prop.get("information_only") == "1"
    return prop.get("panel_visibility", "never" if is_told else "default") != "never"


def is_text(prop):
    """A box of text, with a title of its own."""
    return prop.find("Hints/Widget[@type='multi_line']") is not None


def colour_maps():
    root = ElementTree.parse(TREE / "ParaViewPlugin" / "HorizonRepresentation.xml")
    return {proxy.get("name"): {entry.get("name"): entry for entry in proxy.iter("ColorMap")}
            for proxy in root.iter("PVRepresentationProxy")}


class PanelTest(unittest.TestCase):
    def test_every_line_is_in_one_section(self):
        for name, proxy in PROXIES.items():
            sections = [entry.get("name") for group in groups(proxy) for entry in group.findall("Property")]
            shown = [prop.get("name") for prop in properties(proxy)
                     if is_shown(prop) and prop.tag != "InputProperty" and not is_text(prop)]
            self.assertEqual(sorted(sections), sorted(shown), name)
            labels = [group.get("label") for group in groups(proxy)]
            self.assertTrue(all(labels) and len(set(labels)) == len(labels), (name, labels))

    def test_first_sights_name_arrays_and_colours(self):
        arrays = set(re.findall(r'= "(\w+)"', (TREE / "Common" / "Horizon" / "DataModel.h").read_text(encoding="utf-8")))
        maps = colour_maps()
        used = set()
        arrays.add("heights")  # of the representation
        for name, proxy in PROXIES.items():
            kinds = {hint.get("port"): hint.get("type") for hint in proxy.iter("Representation")}
            for hint in proxy.iter("FirstSight"):
                kind = kinds.get(hint.get("port"), kinds.get(None)) or next(iter(kinds.values()))
                self.assertIn(kind, maps, name)
                self.assertIn(hint.get("array", "Amplitude"), arrays, name)
                if hint.get("colors"):
                    self.assertIn(hint.get("colors"), maps[kind], name)
                    used.add(hint.get("colors"))
        self.assertEqual(used, {entry for entries in maps.values() for entry in entries})

    def test_distances_have_the_colours_of_the_command(self):
        entry = colour_maps()["HorizonRepresentation"]["Horizon Distance"]
        points = [float(point.get(key)) for point in entry.iter("Point") for key in ("x", "r", "g", "b")]
        presets = json.loads((TREE / "Utilities" / "DistanceColors.json").read_text(encoding="utf-8"))
        self.assertEqual(points, presets[0]["RGBPoints"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
