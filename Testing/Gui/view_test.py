# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the plugin adds to the window: the list of horizons in the panel, and the toolbar for heights and axes.

Arguments: ParaView, the folder of the data, and one for files.
"""

import pathlib
import sys

import window

LIST = window.FIELDS + "ProxyPanel/HorizonStatus/"
BUTTONS = LIST + "Buttons/"
TOOLBAR = window.WINDOW + "/HorizonToolBar/"
# A horizon 29 times as wide as it is high.
FLAT = "59 30 9\n" + "".join("%d 1 1 0 0\n" % (2 + n % 59 // 20) for n in range(59 * 30))
# A survey whose inline numbers grow southwards.
PICKS = "Inline Crossline X Y Z\n" + "".join(
    "%d %d %d %d %d\n" % (100 + row, 300 + column, 1000 + 25 * column, 2000 - 25 * row, 500 + (row + column) % 5)
    for row in range(12) for column in range(15))


def choose_horizons(events, sample):
    """By size, and by name; a choice that is not applied can be taken back."""
    events.open(sample)
    events.add(BUTTONS + "SmallestSize", "set_int", "6000")
    events.add(BUTTONS + "AtLeast", "activate")
    events.apply()
    events.macro("NoteView")
    events.add(BUTTONS + "None", "activate")
    events.add(LIST + "Search", "set_string", "zon 2")
    events.add(BUTTONS + "All", "activate")
    events.apply()
    events.macro("NoteView")
    events.add(BUTTONS + "None", "activate")
    events.add(window.PANEL + "/Reset", "activate")
    events.filter("HorizonSurface")
    events.apply()
    events.macro("NoteView")


def check_horizons(notes):
    chosen = [note["horizons"] for note in notes]
    assert chosen == [[["Horizon 1", "Horizon 3"]], [["Horizon 2"]], [["Horizon 2"]]], chosen


def exaggerate(events, flat):
    """All that is in the view has one factor, also what comes later; the axes know it."""
    events.open(flat)
    events.apply()
    events.add(TOOLBAR + "VerticalExaggeration", "set_string", "2")
    events.filter("HorizonSurface")
    events.apply()
    events.macro("NoteView")
    # No macro before undo: in ParaView 6 it is a step itself.
    events.add(TOOLBAR + "FitHeights", "activate")
    events.undo(1)
    events.macro("NoteView")
    # What comes now gets the factor that undo has brought back.
    events.filter("HorizonSurface")
    events.apply()
    events.macro("NoteView")
    events.add(TOOLBAR + "FitHeights", "activate")
    events.macro("NoteView")


def check_exaggeration(notes):
    for factor, note in zip((2, 2, 2, 5), notes):
        assert len(note["scales"]) > 1 and note["scales"] == [[1, 1, factor]] * len(note["scales"]), note
        assert note["axes scale"] == [1, 1, factor], note


def count_lines(events, picks):
    events.open(picks, several_readers=True)
    events.apply()
    events.add(TOOLBAR + "SurveyAxes", "set_boolean", "true")
    events.macro("NoteView")
    events.add(TOOLBAR + "SurveyAxes", "set_boolean", "false")
    events.macro("NoteView")


def check_lines(notes):
    shown, hidden = notes
    assert (shown["axes"], hidden["axes"]) == (["Crossline", "Inline"], ["X Axis", "Y Axis"]), notes
    # Crossline 300 is at x = 1000 and the next one at 1025, inline 100 at y = 2000 and 102 at 1950.
    (x, y), (along, across) = shown["axes position"][:2], shown["axes scale"][:2]
    numbers = [(1000 - x) / along, (1025 - x) / along, (2000 - y) / across, (1950 - y) / across]
    assert numbers == [300, 301, 100, 102], numbers
    assert hidden["axes scale"] == [1, 1, 1] and hidden["axes position"] == [0, 0, 0], hidden


def main():
    paraview, data, folder = sys.argv[1:4]
    folder = window.new_folder(folder)
    sample = pathlib.Path(data).resolve() / "sample.vsm"
    (folder / "flat.vsm").write_text(FLAT, encoding="ascii")
    (folder / "picks.xyz").write_text(PICKS, encoding="ascii")
    scenes = ((choose_horizons, sample, check_horizons, 3), (exaggerate, folder / "flat.vsm", check_exaggeration, 4),
              (count_lines, folder / "picks.xyz", check_lines, 2))
    for number, (play, file, check, count) in enumerate(scenes):
        events = window.Events()
        play(events, file)
        notes = window.play(paraview, events, window.new_folder(folder / str(number)))
        assert len(notes) == count, notes
        check(notes)


main()
