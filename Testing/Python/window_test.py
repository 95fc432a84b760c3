# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The list of horizons in the panel and the toolbar for heights, in the real window of ParaView.

Arguments: the program paraview, the sample, and a folder for files.
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import unittest
import xml.etree.ElementTree as ElementTree

SAMPLE, FOLDER = pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
MENU = "pqClientMainWindow/menubar/"
PANEL = "pqClientMainWindow/propertiesDock/propertiesPanel/"
LIST = PANEL + "scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents/PropertiesFrame/ProxyPanel/HorizonStatus/"
TOOLBAR = "pqClientMainWindow/HorizonToolBar/"
APPLY = ((PANEL + "Accept", "activate", ""),)
SURFACE = ((MENU + "menuFilters/pqProxyGroupMenuManager0/HorizonSurface", "activate", ""),)


def choose_file(path):
    return ((MENU + "menu_File", "activate", "actionFileOpen"),
            ("pqClientMainWindow/FileOpenDialog", "filesSelected", str(path)))


def write_flat(path):
    """A horizon 29 times as wide as it is high."""
    path.write_text("59 30 9\n" + "".join("%d 1 1 0 0\n" % (2 + n % 59 // 20) for n in range(59 * 30)))


def write_picks(path):
    """A survey whose inline numbers grow southwards."""
    lines = ["%d %d %d %d %d" % (100 + row, 300 + column, 1000 + 25 * column, 2000 - 25 * row, 500 + (row + column) % 5)
             for row in range(12) for column in range(15)]
    path.write_text("Inline Crossline X Y Z\n" + "\n".join(lines) + "\n")


def press(name):
    return ((LIST + "Buttons/" + name, "activate", ""),)


def exaggerate(text):
    return ((TOOLBAR + "VerticalExaggeration", "set_string", text),)


def write_script(path, events):
    root = ElementTree.Element("pqevents")
    for name, command, arguments in events:
        ElementTree.SubElement(root, "pqevent", {"object": name, "command": command, "arguments": arguments})
    ElementTree.ElementTree(root).write(path)


def play(*steps):
    """What was shown, picture by picture."""
    shutil.rmtree(FOLDER, ignore_errors=True)
    home = FOLDER / "home"
    home.mkdir(parents=True)
    home.chmod(0o700)
    write_script(FOLDER / "events.xml", [event for step in steps for event in step])
    environment = dict(os.environ, WATCH=str(FOLDER / "watch.txt"), HOME=str(home), XDG_CONFIG_HOME=str(home),
                       XDG_RUNTIME_DIR=str(home))
    watch = pathlib.Path(__file__).resolve().with_name("window_watch.py")
    done = subprocess.run([sys.argv[1], "--dr", "--script=%s" % watch, "--test-directory=%s" % FOLDER,
                           "--test-script=%s" % (FOLDER / "events.xml"), "--exit"],
                          capture_output=True, text=True, timeout=100, env=environment)
    log = done.stdout + done.stderr
    assert "critical:" not in log and "Error" not in log, log
    return [json.loads(line) for line in (FOLDER / "watch.txt").read_text().splitlines()]


class WindowTest(unittest.TestCase):
    def test_horizons_of_a_size(self):
        states = play(choose_file(SAMPLE), ((LIST + "Buttons/SmallestSize", "set_int", "6000"),), press("AtLeast"), APPLY)
        self.assertEqual(states[-1]["sample.vsm"]["Horizons"], ["Horizon 1", "Horizon 3"])

    def test_all_of_those_that_are_found_and_reset(self):
        search = ((LIST + "Search", "set_string", "zon 2"),)
        reset = ((PANEL + "Reset", "activate", ""),)
        states = play(choose_file(SAMPLE), press("None"), search, press("All"), APPLY, press("None"), reset, SURFACE, APPLY)
        self.assertEqual(states[-1]["sample.vsm"]["Horizons"], ["Horizon 2"])
        self.assertIn("HorizonSurface1", states[-1])

    def test_exaggeration_is_that_of_all_in_the_view(self):
        flat = FOLDER.with_suffix(".vsm")
        write_flat(flat)
        fit = ((TOOLBAR + "FitHeights", "activate", ""),)
        states = play(choose_file(flat), APPLY, exaggerate("2"), SURFACE, APPLY, fit)

        def factors(state):
            return [state[name]["Scale"] for name in (flat.name, "HorizonSurface1")] + [state["DataScale"]]

        both = [factors(state) for state in states if "HorizonSurface1" in state]
        self.assertIn([[1, 1, 2]] * 3, both)
        self.assertEqual(both[-1], [[1, 1, 5]] * 3)

    def test_axes_count_lines(self):
        picks = FOLDER.with_suffix(".ijz")
        write_picks(picks)
        states = play(choose_file(picks), APPLY, ((TOOLBAR + "SurveyAxes", "set_boolean", "true"),))
        self.assertEqual((states[-1]["XTitle"], states[-1]["YTitle"]), ("Crossline", "Inline"))
        # Crossline 300 is at x = 1000 and the next one at 1025, inline 100 at y = 2000 and 102 at 1950.
        position, scale = states[-1]["DataPosition"], states[-1]["DataScale"]
        self.assertEqual([(1000 - position[0]) / scale[0], (1025 - position[0]) / scale[0],
                          (2000 - position[1]) / scale[1], (1950 - position[1]) / scale[1]], [300, 301, 100, 102])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
