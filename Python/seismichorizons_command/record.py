# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Records the events of a run: its files, their horizons, warnings and errors (see figures.py)."""

import datetime
import json
import os
import time

from . import album as albums
from . import figures
from .settings import with_options


class Record:
    """The record of one run. `tell` is called with "error" or "warning" and the text. With `has_figures`, figures of
    horizons, which take some time, are recorded; `album` (album.Album) also receives the horizons, unless it is None."""

    def __init__(self, tell, has_figures=False, album=None):
        self._tell = tell
        self._has_figures = has_figures
        self._start = time.monotonic()
        self._started = datetime.datetime.now(datetime.timezone.utc)
        self._given = {}
        self._running = {}
        self.album = album
        self.files = []
        self.warnings = []
        self.error = None
        self.meshes = 0  # in results that are complete
        self._meshes_of_file = 0

    def begin(self, settings):
        self._given = figures.parameters(settings)
        self._running = {"formats": list(settings.formats), "memory": settings.memory,
                         "leave_out_invalid": settings.leave_out_invalid}

    def begin_file(self, path, label):
        self._meshes_of_file = 0
        self.files.append({"path": figures.plain(path), "label": figures.plain(label), "status": "failed", "error": None,
                           "bytes": os.path.getsize(path) if os.path.exists(path) else None, "format": None,
                           "description": [], "horizons_in_file": None, "survey": None, "seconds_reading": None,
                           "horizons": [], "layers": [], "results": [], "warnings": []})

    def add_horizon(self, result, supply, names):
        """Records a horizon whose mesh is written to the files `names`."""
        self._meshes_of_file += 1
        if not self._has_figures:
            return
        file = self.files[-1]
        if file["survey"] is None:
            file["survey"] = figures.survey(result.data.get("points") or result.data["mesh"])
        file["horizons"].append({**figures.horizon(result), "results": list(names)})
        if self.album:
            sizes = sorted(supply.sizes, reverse=True)
            self.album.add(result, sizes.index(result.number_of_points))

    def add_layers(self, made):
        """Records volumes between the horizons of a file (volumes.Layers)."""
        self.files[-1]["layers"] = [vars(own) for own in made.figures.values()]
        if self.album:
            self.album.add_layers(made)

    def part(self, tell):
        """Returns a record for one file in another process."""
        return Record(tell, self._has_figures, albums.Album(self.album.with_pictures, is_part=True) if self.album else None)

    def take(self, file, messages):
        """Adds a file of another record, and tells its messages."""
        self.files.append(file)
        for kind, text in messages:
            self._tell(kind, text)

    def take_results(self, outcome):
        """Adds the meshes that another process has made (jobs.Outcome)."""
        self.meshes += outcome.meshes
        if self.album:
            self.album.take(outcome.entries, outcome.layers)

    def end_file(self, supply, results):
        """Records that the results of a file are complete."""
        self.meshes += self._meshes_of_file
        self.files[-1].update(status="done", seconds_reading=supply.seconds, results=list(results), **supply.origin)

    def end_stack(self, results):
        """Records that the results of layers between files are complete."""
        self.files[-1].update(status="done", seconds_reading=0.0, results=list(results))

    def fail_file(self, error):
        """Records that a file has no results, or that they cannot be reported."""
        file = self.files[-1]
        file["error"] = with_options(str(error))
        if file["status"] != "done":
            file["horizons"] = []
        if self.album:
            self.album.cut(sum(len(file["horizons"]) for file in self.files))
        self._tell("error", file["error"])

    def warn(self, text):
        """Records a warning, once, about the current file or, before the first file, about the run."""
        text = with_options(text)
        warnings = self.files[-1]["warnings"] if self.files else self.warnings
        if text not in warnings:
            warnings.append(text)
            self._tell("warning", text)

    def warn_of_file(self, path, label, text):
        """Records a warning about a file, with its label in place of its path."""
        self.warn("%s: %s" % (label, text.replace("%s: " % path, "", 1)))

    def fail(self, error):
        """Records that the whole run failed."""
        self.error = with_options(str(error))
        self._tell("error", self.error)

    def summary(self, folder, files):
        """Returns a line on files, such as "12 files: 11 done, 1 failed, 2 warnings; 34 meshes in out/"."""
        failed = sum(file["error"] is not None for file in files)
        warnings = sum(len(file["warnings"]) for file in self.files) + len(self.warnings)
        words = ["%d done" % (len(files) - failed), *(["%d failed" % failed] if failed else []),
                 *([_count(warnings, "warning")] if warnings else [])]
        return "%s: %s; %s in %s" % (_count(len(files), "file"), ", ".join(words), _count(self.meshes, "mesh", "es"),
                                     figures.plain(os.path.join(folder, "")))

    def is_done(self):
        return self.error is None and all(file["error"] is None for file in self.files)

    def as_values(self):
        """Returns the record as values for JSON and a report."""
        return figures.without_nan({
            "version": 1, "program": "horizon_mesh", "done": self.is_done(), "error": self.error,
            "warnings": self.warnings,
            "started": self._started.isoformat(timespec="seconds"), "seconds": time.monotonic() - self._start,
            "versions": figures.versions(), "command": figures.command(), "parameters": self._given,
            "running": self._running, "files": self.files})

    def as_json(self):
        """Returns the record as one line of JSON."""
        return json.dumps(self.as_values(), allow_nan=False)


def _count(number, noun, plural="s"):
    return "%d %s%s" % (number, noun, "" if number == 1 else plural)
