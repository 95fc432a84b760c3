# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Plays events in the window of ParaView, in the form in which it records them itself.

Macros, the files of the folder Macros, are the eyes and ears of a test: an event starts them like a user does, from their
menu, and they run in the process of the window, between two events. They write what they find into the working directory.
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import xml.sax.saxutils

MACROS = pathlib.Path(__file__).resolve().parent / "Macros"
WINDOW = "pqClientMainWindow"
PANEL = WINDOW + "/propertiesDock/propertiesPanel"
FIELDS = PANEL + "/scrollArea/qt_scrollarea_viewport/scrollAreaWidgetContents/PropertiesFrame/"
LONGEST = 300  # seconds; a dialog that nobody answers would keep the window open for good
WRONG = ("critical:", "ERR|", "Traceback")


class Events:
    """What a user does, one thing after the other."""

    def __init__(self):
        self.lines = []

    def add(self, place, command, arguments=""):
        quoted = [xml.sax.saxutils.quoteattr(str(text)) for text in (place, command, arguments)]
        self.lines.append("  <pqevent object=%s command=%s arguments=%s />" % tuple(quoted))

    def menu(self, name, action):
        self.add(WINDOW + "/menubar/" + name, "activate", action)

    def file_chosen(self, dialog, path):
        self.add(WINDOW + "/" + dialog, "filesSelected", path)

    def open(self, path, several_readers=False):
        """File > Open, without Apply; where several readers offer themselves, the one on top is taken."""
        self.menu("menu_File", "actionFileOpen")
        self.file_chosen("FileOpenDialog", path)
        if several_readers:
            self.add(WINDOW + "/pqSelectReaderDialog/okButton", "activate")

    def undo(self, times):
        for _ in range(times):
            self.menu("menu_Edit", "actionEditUndo")

    def redo(self, times):
        for _ in range(times):
            self.menu("menu_Edit", "actionEditRedo")

    def save_data(self, path):
        """File > Save Data, with the writer's settings as they are."""
        self.menu("menu_File", "actionFileSaveData")
        self.file_chosen("FileSaveDialog", path)
        self.add(WINDOW + "/WriterSettingsDialog/widget/OKButton", "activate")

    def save_state(self, path):
        self.menu("menu_File", "actionFileSaveServerState")
        self.file_chosen("FileSaveServerStateDialog", path)

    def filter(self, name):
        """A filter of the active source, without Apply."""
        self.add(WINDOW + "/menubar/menuFilters/pqProxyGroupMenuManager0/" + name, "activate")

    def choose_input(self, name, source):
        """Chooses a second input in the panel; of a source with several outputs, SOURCE:OUTPUT."""
        self.add(FIELDS + "ProxyPanel/%s/1QComboBox0" % name, "set_string", source)

    def apply(self):
        self.add(PANEL + "/Accept", "activate")

    def set_number(self, name, value, widget="IntRangeWidget/LineEdit"):
        """Types into the field of a property that has a slider."""
        self.add(FIELDS + "ProxyPanel/%s/%s" % (name, widget), "set_string", value)

    def set_check(self, name, state):
        self.add(FIELDS + "ProxyPanel/%s/CheckBox" % name, "set_boolean", "true" if state else "false")

    def choose_horizon(self, row, state):
        """Checks an item of the list of horizons, or takes the check away."""
        self.add(FIELDS + "ProxyPanel/HorizonStatus/Horizons", "setCheckState", "%d.0,%d" % (row, 2 if state else 0))

    def check(self, place, name, value):
        """A property of an object of the window has to have that value."""
        quoted = tuple(xml.sax.saxutils.quoteattr(str(text)) for text in (place, name, value))
        self.lines.append("  <pqcheck object=%s property=%s arguments=%s />" % quoted)

    def check_results(self, text):
        """The results of the stage in the panel have to be this text."""
        self.check(FIELDS + "ProxyPanel/Results/Results", "plainText", text)

    def macro(self, name):
        self.menu("menu_Macros", name)

    def write(self, path):
        head = '<?xml version="1.0" ?>\n<pqevents>\n'
        path.write_text(head + "\n".join(self.lines) + "\n</pqevents>\n", encoding="utf-8")


def new_folder(path):
    """An empty folder."""
    folder = pathlib.Path(path).resolve()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


def _environment(folder):
    """A home of its own, so that no settings of a user come in, with the macros."""
    home = folder / "home"
    shutil.copytree(MACROS, home / "ParaView" / "Macros")
    shutil.copytree(MACROS, folder / "Macros")  # where ParaView 6 looks for them with --dr
    os.chmod(home, 0o700)
    return dict(os.environ, HOME=str(home), XDG_CONFIG_HOME=str(home), XDG_RUNTIME_DIR=str(home))


def run(paraview, script, folder, *arguments):
    """Plays the script with the folder as working directory; returns the exit code and the log."""
    command = [paraview, "--dr", "--test-directory=%s" % folder, "--test-script=%s" % script, *arguments, "--exit"]
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=LONGEST,
                              cwd=folder, env=_environment(folder))
    except subprocess.TimeoutExpired as expired:
        print((expired.stdout or b"").decode())
        sys.exit("the window did not end in %d s" % LONGEST)
    return done.returncode, done.stdout


def play(paraview, events, folder, *arguments, error=None):
    """Plays events that have to find their objects, and may cause no error but an expected one. Returns what macros noted, a
    list."""
    script = folder / "events.xml"
    events.write(script)
    code, log = run(paraview, script, folder, *arguments)
    is_wrong = error not in log if error else any(word in log for word in WRONG)
    if code != 0 or is_wrong:
        print(log)
        sys.exit("the events were not played to their end, or there was an error")
    notes = folder / "notes.txt"
    return [json.loads(line) for line in notes.read_text(encoding="utf-8").splitlines()] if notes.exists() else []
