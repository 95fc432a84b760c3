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
# One that is turned, with lines of even numbers.
TURNED = "Inline Crossline X Y Z\n" + "".join(
    "%d %d %d %d %d\n" % (10 + 2 * row, 20 + 2 * column, 1000 + 30 * column - 40 * row, 2000 + 40 * column + 30 * row,
                          500 + row % 5) for row in range(12) for column in range(15))
FITTED = 50  # what makes its 4 units of height a quarter of its width
# A line, and a survey in its direction whose heights are not flat.
LINE = "40 1 60\n" + "".join("%d 1 1 0 0\n" % (10 + n) for n in range(40))
STEEP = "Inline Crossline X Y TWT_ms\n" + "".join(
    "%d %d %d %d %d\n" % (row, column, column, row, 1000 + row + column) for row in range(9) for column in range(9))
# Two horizons on one lattice, each with a vertical step of its own.
STEPS = "Name Inline Crossline X Y Z\n" + "".join(
    "%s %d %d %d %d %g\n" % (name, row, column, 25 * column, 25 * row, 100 + step * ((row * column) % 9))
    for name, step in (("top", 4.0), ("base", 0.5)) for row in range(9) for column in range(9))
# A fault along the middle, of a throw that is to be filled in.
FAULT = "40 40 99\n" + "".join(("10" if n % 40 < 20 else "THROW") + " 1 1 0 0\n" for n in range(1600))
MESSAGE = window.WINDOW + "/SurveyAxesMessage"
NO_LATTICE = "No survey axes: nothing is shown that has a lattice; expected horizons or a cube."


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
    # Numbers that stand for something else say so.
    events.filter("HorizonDespiking")
    field = "DoubleRangeWidget/DoubleLineEdit"
    text = window.FIELDS + "ProxyPanel/Threshold/%s/SpecialValue" % field
    events.check(text, "text", "by the noise")
    for value, is_shown in (("3", "false"), ("0.0", "true"), ("", "false")):
        events.set_number("Threshold", value, field)
        events.check(text, "visible", is_shown)


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
    events.check(TOOLBAR + "VerticalExaggeration", "currentText", "5")
    events.undo(1)
    events.macro("NoteView")
    # What comes now gets the factor that undo has brought back.
    events.add(window.WINDOW + "/pipelineBrowserDock/pipelineBrowser", "currentChanged", "/0|0/0|0")
    events.filter("HorizonExteriorBoundary")
    events.apply()
    events.macro("NoteView")
    events.save_state("exaggerated.pvsm")


def check_exaggeration(notes):
    for note in notes:
        assert len(note["scales"]) > 1 and note["scales"] == [[1, 1, 2]] * len(note["scales"]), note
        assert note["axes scale"] == [1, 1, -2], note


def count_lines(events, picks):
    """A message where there is nothing to count; axes of a turned survey, which follow heights and what is shown."""
    events.add(TOOLBAR + "SurveyAxes", "set_boolean", "true")
    events.check(MESSAGE, "text", NO_LATTICE)
    events.add(MESSAGE + "/qt_msgbox_buttonbox/1QPushButton0", "activate")
    events.macro("NoteView")
    events.open(picks.parent / "turned.xyz", several_readers=True)
    events.apply()
    events.add(TOOLBAR + "SurveyAxes", "set_boolean", "true")
    events.macro("NoteView")
    events.add(TOOLBAR + "VerticalExaggeration", "set_string", "2")
    events.macro("NoteView")
    events.open(picks.parent / "flat.vsm")
    events.apply()
    events.macro("NoteView")
    events.add(TOOLBAR + "SurveyAxes", "set_boolean", "false")
    events.macro("NoteView")


def count_lines_southwards(events, picks):
    events.open(picks, several_readers=True)
    events.apply()
    events.add(TOOLBAR + "SurveyAxes", "set_boolean", "true")
    events.macro("NoteView")


def place(note, x, y, z):
    """Where a point of the axes is in the world."""
    matrix = note["axes matrix"]
    return [round(sum(a * b for a, b in zip(matrix[row:row + 4], (x, y, z, 1))), 6) for row in (0, 4, 8)]


def check_lines(notes):
    refused, shown, exaggerated, higher, hidden = notes
    assert refused["axes"] == hidden["axes"] == ["X Axis", "Y Axis"], notes
    assert not refused["counts lines"] and not hidden["counts lines"], notes
    assert shown["axes"] == ["Crossline", "Inline"] and shown["counts lines"], shown
    assert shown["axes bounds"] == [20, 48, 10, 32, 500, 504], shown
    # Crossline 22 is the second one, and inline 14 the third.
    assert place(shown, 22, 14, 500) == [1000 + 30 - 2 * 40, 2000 + 40 + 2 * 30, -500 * FITTED], shown
    assert place(exaggerated, 20, 10, 500) == [1000, 2000, -1000], exaggerated
    assert higher["axes bounds"] == [20, 48, 10, 32, 2, 504] and higher["scales"] == [[1, 1, 2]] * 2, higher


def check_lines_southwards(notes):
    note, = notes
    assert note["axes"] == ["Inline", "Crossline"], note  # right-handed
    assert note["axes bounds"][:4] == [100, 111, 300, 314], note
    assert place(note, 102, 301, 0) == [1025, 1950, 0], note


def see_first(events, steep):
    """An empty view looks obliquely, exaggerates what is flat until it is empty again, and has one scale of heights."""
    folder = steep.parent
    events.open(folder / "flat.vsm")
    events.apply()
    events.macro("NoteView")
    events.add(window.PANEL + "/Delete", "activate")
    events.macro("NoteView")
    events.open(steep, several_readers=True)
    events.apply()
    events.macro("NoteView")
    events.open(folder / "deep.xyz", several_readers=True)
    events.apply()
    events.macro("NoteView")
    events.add(window.PANEL + "/Delete", "activate")
    events.macro("NoteView")
    events.add(window.WINDOW + "/cameraToolbar/actionPositiveX", "activate")
    events.open(folder / "deep.xyz", several_readers=True)
    events.apply()
    events.macro("NoteView")


def check_first_sight(notes):
    flat, emptied, steep, both, left, turned = notes
    assert flat["seen from"] == [0.35, -0.75, 0.56] and flat["axes scale"] == [1, 1, -5], flat
    assert flat["shown"] == [["VerneySparseMatrixReader", "Depth", [2, 4]]], flat
    assert emptied["axes scale"] == [1, 1, 1] and emptied["shown"] == [], emptied
    assert steep["axes scale"] == [1, 1, -0.1] and steep["axis"] == "Time (ms)", steep
    assert steep["shown"] == [["HorizonTextReader", "Time (ms)", [1000, 1016]]], steep
    assert steep["formats"] in (["%.0f"], ["{:.0f}"]), steep  # of ParaView 5 and 6
    assert steep["contours"] == ["contours every 1 ms"], steep
    assert [entry[2] for entry in both["shown"]] == [[1000, 1116]] * 2, both
    assert left["shown"] == steep["shown"], left
    # The view is moved to see both, but not once somebody has turned it.
    assert both["seen from"] == steep["seen from"] and both["focus"][2] == -105.8, both
    assert left["focus"] == both["focus"], left
    assert turned["seen from"] == [-1, 0, 0] and turned["focus"][2] == steep["focus"][2], turned


def see_two(events, steps):
    """Horizons whose vertical steps differ are seen like others, and have axes of one survey."""
    events.open(steps, several_readers=True)
    events.apply()
    events.add(TOOLBAR + "SurveyAxes", "set_boolean", "true")
    events.macro("NoteView")


def check_two(notes):
    note, = notes
    assert note["seen from"] == [0.35, -0.75, 0.56] and note["axes"] == ["Crossline", "Inline"], note


def see_throws(events, fault):
    """Colours around zero stay so when a second file widens them, and when it goes."""
    for name in ("fault.vsm", "larger.vsm"):
        events.open(fault.parent / name)
        events.apply()
        events.filter("HorizonFaults")
        events.apply()
        events.macro("NoteView")
    events.add(window.PANEL + "/Delete", "activate")
    events.macro("NoteView")


def check_throws(notes):
    ranges = [[ends for array, ends in note["colours"] if array == "Throw"] for note in notes]
    assert ranges == [[[-20, 20]], [[-70, 70]] * 2, [[-20, 20]]], ranges


def see_stages(events, line):
    """A line from its side; outlines beside those they were made of; a mesh alone."""
    events.open(line)
    events.apply()
    events.macro("NoteView")
    events.add(window.PANEL + "/Delete", "activate")
    events.open(line.parent / "steep.xyz", several_readers=True)
    events.apply()
    # A height is also told in the other unit.
    events.filter("HorizonDespiking")
    events.set_number("Threshold", "2.5", "DoubleRangeWidget/DoubleLineEdit")
    text = window.FIELDS + "ProxyPanel/Threshold/DoubleRangeWidget/DoubleLineEdit/SpecialValue"
    events.check(text, "text", "= 2.5 ms")
    events.add(window.FIELDS + "ProxyPanel/ThresholdUnit/ComboBox", "set_string", "World")
    events.check(text, "text", "= 2.5 steps")
    events.add(window.PANEL + "/Delete", "activate")
    for stage in ("HorizonExteriorBoundary", "HorizonBoundarySimplification", "HorizonRoughSimplification",
                  "HorizonTriangulation"):
        events.filter(stage)
        events.apply()
        events.macro("NoteView")


def check_stages(notes):
    line, boundary, simplified, rough, mesh = notes
    assert line["seen from"] == [0, -1, 0], line
    names = [[entry[0] for entry in note["shown"]] for note in notes[1:]]
    assert names == [["HorizonExteriorBoundary"], ["HorizonBoundarySimplification", "HorizonExteriorBoundary"],
                     ["HorizonExteriorBoundary", "HorizonRoughSimplification"], ["HorizonTriangulation"]], names
    assert {entry[1] for entry in simplified["shown"]} == {"Boundary", "Simplified Boundary"}, simplified
    assert [note["axis"] for note in notes[1:]] == ["Time (ms)"] * 4, notes


def keep_camera(events, flat):
    """Nobody moves the camera but the user: not even stages that hide what they were made from."""
    events.open(flat)
    events.apply()
    events.macro("NoteView")  # the first view comes late
    events.macro("MoveCamera")
    events.macro("NoteView")
    events.filter("HorizonSurface")
    events.apply()
    events.macro("NoteView")


def check_camera(notes):
    first, moved, last = ([note[name] for name in ("seen from", "distance", "focus")] for note in notes)
    assert first != moved and moved == last, notes
    assert [shown[0] for shown in notes[2]["shown"]] == ["HorizonSurface"], notes


def cover(events, steep):
    """A new result hides another one of the same horizon, but not one of another horizon; what is shown is selected."""
    first = "/0|0/0|0"
    for _ in range(2):
        events.open(steep, several_readers=True)
        events.apply()
    events.add(window.WINDOW + "/pipelineBrowserDock/pipelineBrowser", "currentChanged", first)
    for stage in ("HorizonDespiking", "HorizonSurface"):
        events.filter(stage)
        events.apply()
        events.macro("NoteView")
        if stage == "HorizonSurface":
            events.add(window.PANEL + "/Delete", "activate")  # as Undo, which comes no further than to a macro in ParaView 6
            events.macro("NoteView")
        events.add(window.WINDOW + "/pipelineBrowserDock/pipelineBrowser", "currentChanged", first)
    events.open(steep.parent / "steps.xyz", several_readers=True)
    events.apply()
    events.filter("HorizonLayers")
    events.apply()
    events.macro("NoteView")


def check_cover(notes):
    names = [sorted(entry[0] for entry in note["shown"]) for note in notes]
    assert names[:2] == [["HorizonDespiking", "HorizonTextReader"], ["HorizonSurface", "HorizonTextReader"]], names
    assert "HorizonDespiking" in names[2] and "HorizonSurface" not in names[2], names
    assert [notes[n]["selected"] for n in (0, 1, 3)] == [0, 0, 1], notes


def separate(events, steep):
    """A horizon gets a scale of its own, in the same colours, by one click."""
    for name in ("steep.xyz", "deep.xyz"):
        events.open(steep.parent / name, several_readers=True)
        events.apply()
    events.macro("NoteView")
    events.macro("SeparateColors")  # as the button does, which is at another place in ParaView 6
    events.macro("NoteView")


def check_separate(notes):
    both, own = ([entry[1:] for entry in note["shown"]] for note in notes)
    assert both == [["Time (ms)", [1000, 1116]]] * 2, both
    assert sorted(own) == [["Time (ms)", [1000, 1016]], ["Time (ms)", [1100, 1116]]], own  # each its own
    tops = [note["tops"] for note in notes]
    assert tops[0] == tops[1] and min(tops[0][0][:2]) > 0.9, tops


def fail(events):
    """A stage that makes nothing leaves the view as it was."""
    events.add(window.WINDOW + "/menubar/menuSources/pqProxyGroupMenuManager0/SphereSource", "activate")
    events.apply()
    events.macro("NoteView")
    events.filter("HorizonSurface")
    events.apply()
    events.macro("NoteView")


def check_failure(before, after):
    assert [shown[0] for shown in before["shown"]] == ["Sphere"], before
    assert "Sphere" in [shown[0] for shown in after["shown"]], after
    assert [before[name] for name in ("distance", "focus")] == [after[name] for name in ("distance", "focus")], after


def load_exaggerated(events):
    """The toolbar knows the factor of a state file, and gives it to what comes later."""
    events.check(TOOLBAR + "VerticalExaggeration", "currentText", "2")
    events.add(window.WINDOW + "/pipelineBrowserDock/pipelineBrowser", "currentChanged", "/0|0/0|0")
    events.filter("HorizonExteriorBoundary")
    events.apply()
    events.macro("NoteView")


def main():
    paraview, data, folder = sys.argv[1:4]
    folder = window.new_folder(folder)
    sample = pathlib.Path(data).resolve() / "blobs.vsm"
    (folder / "flat.vsm").write_text(FLAT, encoding="ascii")
    (folder / "picks.xyz").write_text(PICKS, encoding="ascii")
    for name, text in (("turned.xyz", TURNED), ("steep.xyz", STEEP), ("deep.xyz", STEEP.replace(" 10", " 11")),
                       ("line.vsm", LINE), ("steps.xyz", STEPS), ("fault.vsm", FAULT.replace("THROW", "30")),
                       ("larger.vsm", FAULT.replace("THROW", "80"))):
        (folder / name).write_text(text, encoding="ascii")
    scenes = ((choose_horizons, sample, check_horizons, 3), (exaggerate, folder / "flat.vsm", check_exaggeration, 3),
              (count_lines, folder / "picks.xyz", check_lines, 5),
              (count_lines_southwards, folder / "picks.xyz", check_lines_southwards, 1),
              (see_first, folder / "steep.xyz", check_first_sight, 6), (see_two, folder / "steps.xyz", check_two, 1),
              (see_throws, folder / "fault.vsm", check_throws, 3),
              (see_stages, folder / "line.vsm", check_stages, 5), (cover, folder / "steep.xyz", check_cover, 4),
              (separate, folder / "steep.xyz", check_separate, 2), (keep_camera, folder / "flat.vsm", check_camera, 3))
    for number, (play, file, check, count) in enumerate(scenes):
        events = window.Events()
        play(events, file)
        notes = window.play(paraview, events, window.new_folder(folder / str(number)))
        assert len(notes) == count, notes
        check(notes)

    events = window.Events()
    fail(events)
    check_failure(*window.play(paraview, events, window.new_folder(folder / "failed"), error="Horizon From Points finds"))

    events = window.Events()
    load_exaggerated(events)
    state = "--state=%s" % (folder / "1" / "exaggerated.pvsm")
    note, = window.play(paraview, events, window.new_folder(folder / "loaded"), state)
    assert len(note["scales"]) > 2 and note["scales"] == [[1, 1, 2]] * len(note["scales"]), note


main()
