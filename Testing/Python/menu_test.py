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

    def test_every_filter_is_in_the_menu_once(self):
        names = [entry.get("name") for entry in self.entries]
        self.assertEqual(sorted(names), sorted(filters()))

    def test_every_entry_has_its_icon(self):
        for entry in self.entries:
            self.assertEqual(entry.get("icon"), PREFIX + "Icons/%s.svg" % entry.get("name"))
        icons = {path.stem: ElementTree.parse(path).getroot() for path in (PLUGIN / "Icons").iterdir()}
        self.assertEqual(set(icons), {entry.get("name") for entry in self.entries})
        for name, root in icons.items():
            self.assertEqual((root.tag.rpartition("}")[2], root.get("viewBox")), ("svg", "0 0 32 32"), name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
