# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Every filter of the plugin is in its menu and toolbar, with an icon of its own. Argument: the folder of the plugin."""

import pathlib
import sys
import unittest
import xml.etree.ElementTree as ElementTree

PLUGIN = pathlib.Path(sys.argv[1])
PREFIX = ":/SeismicHorizons/"


def filters():
    """The names of all filter proxies, each of a file of its own."""
    names = set()
    for path in PLUGIN.glob("*.xml"):
        for group in ElementTree.parse(path).iter("ProxyGroup"):
            if group.get("name") == "filters":
                names.update(proxy.get("name") for proxy in group.iter("SourceProxy"))
    return names


class MenuTest(unittest.TestCase):
    def setUp(self):
        self.entries = list(ElementTree.parse(PLUGIN / "Menu.xml").iter("Proxy"))
        resources = ElementTree.parse(PLUGIN / "SeismicHorizons.qrc")
        self.files = {file.text for file in resources.iter("file")}

    def test_every_filter_is_in_the_menu_once(self):
        names = [entry.get("name") for entry in self.entries]
        self.assertEqual(sorted(names), sorted(filters()))

    def test_every_entry_has_its_icon(self):
        for entry in self.entries:
            icon = "Icons/%s.svg" % entry.get("name")
            self.assertEqual(entry.get("icon"), PREFIX + icon)
            self.assertIn(icon, self.files)

    def test_resources_are_there(self):
        for name in self.files:
            root = ElementTree.parse(PLUGIN / name).getroot()
            if name.endswith(".svg"):
                self.assertEqual((root.tag.rpartition("}")[2], root.get("viewBox")), ("svg", "0 0 32 32"))
        icons = {"Icons/" + path.name for path in (PLUGIN / "Icons").iterdir()}
        self.assertEqual(icons, {name for name in self.files if name.startswith("Icons/")})


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
