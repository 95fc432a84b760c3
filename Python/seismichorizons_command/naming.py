# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Unique names of result files, also on systems whose file names ignore case."""

import collections
import contextlib
import os
import pathlib
import re

from . import figures, reading, writing
from .core import HorizonError

LONGEST_NAME = 255  # bytes of a file name on all common systems
LONGEST_STEM, LONGEST_ENDING = 160, 20  # bytes of the stem, and of numbers and extensions


def make_labels(files):
    """Labels files by name, preceded by as many folders as are necessary to distinguish the files and their results
    (`a/x.vsm`). Raises HorizonError if a file is given twice."""
    # Links are not followed, because users know files by the names they typed.
    places = [pathlib.PurePath(os.path.abspath(path)).parts[1:] for path in files]
    for number, place in enumerate(places):
        if places.index(place) < number:
            raise HorizonError("%s is given twice" % figures.plain(files[places.index(place)]))
    lengths = [1] * len(files)
    labels = None
    while True:
        before, labels = labels, [pathlib.PurePath(*place[-length:]) for place, length in zip(places, lengths)]
        users = collections.defaultdict(list)
        for number, stem in enumerate(make_stems(labels)):
            users[stem.casefold()].append(number)
        # Files in the same folder are distinguished by numbers.
        twins = [numbers for numbers in users.values() if len({places[number][:-1] for number in numbers}) > 1]
        if not twins or labels == before:
            return labels
        for number in sum(twins, []):
            lengths[number] += 1


def make_stems(labels):
    """Returns the first part of the result names: `a_x` for `a/x.vsm` and `a/x.vsm.gz`; `x_dat` and `x_map` for files that
    differ only in their extension."""
    short = [_without_extension(label) for label in labels]
    users = collections.Counter(str(stem).casefold() for stem in short)
    return ["_".join(stem.parts) + (label.name[len(stem.name):].replace(".", "_")
                                    if users[str(stem).casefold()] > 1 else "") for label, stem in zip(labels, short)]


def distinct(names):
    """Returns unique names: a name that equals an earlier one, ignoring case, gets a number appended."""
    names = list(names)
    given = {name.casefold() for name in names}
    used, found = set(), []
    for name in names:
        number, one = 1, name
        while one.casefold() in used or (number > 1 and one.casefold() in given):
            number += 1
            one = "%s_%d" % (name, number)
        used.add(one.casefold())
        found.append(one)
    return found


def shorten(text, most):
    """Returns the beginning of a text, limited to `most` bytes in a file name."""
    return os.fsencode(text)[:most].decode(errors="ignore") if len(os.fsencode(text)) > most else text


class Taken:
    """Files that results must not replace: input files and the results of other files."""

    def __init__(self, files):
        self._inputs = {}
        for path in files:
            with contextlib.suppress(OSError):  # its reader reports it
                state = os.stat(path)
                self._inputs[state.st_dev, state.st_ino] = path
        self._names = {}

    def require(self, folder, names, label):
        """Raises HorizonError if one of the names is taken in a folder; otherwise reserves them for a file."""
        for name in names:
            writing.require_writable(folder / name)
            with contextlib.suppress(FileNotFoundError):
                state = os.stat(folder / name)
                if (state.st_dev, state.st_ino) in self._inputs:
                    raise HorizonError("%s: %s is an input and would be replaced, expected another --output-folder" % (
                        label, folder / name))
            if name.casefold() in self._names:
                raise HorizonError("%s and %s would write the same results, %s" % (
                    self._names[name.casefold()], label, name))
        self._names.update((name.casefold(), label) for name in names)


def _without_extension(label):
    if label.suffix.lower() == ".gz":
        label = label.with_suffix("")
    return label.with_suffix("")


class Names:
    """The names of the result files."""

    def __init__(self, stem, names, settings, with_pictures):
        mesh_stems = dict(zip(names, _mesh_stems(stem, names)))
        self.meshes = {name: ["%s.%s" % (mesh_stem, form) for form in settings.formats
                              if form not in writing.LAYER_FORMATS]
                       for name, mesh_stem in mesh_stems.items()}
        self.figures = ["%s_error.csv" % stem] if settings.error is not None and not settings.error_if_whole else []
        self.pictures = ["%s.png" % stem] if with_pictures else []
        self._stem = stem
        self.layers = ["%s_layers.%s" % (stem, form) for form in ("csv", "vtu", *(
            form for form in settings.formats if form in writing.LAYER_FORMATS))] if settings.layers is not None else []
        self.body_formats = [form for form in settings.formats if form in writing.MESH_FORMATS] if self.layers else []
        self.bodies = [self.body(number, form) for number in range(len(names) - 1) for form in self.body_formats]
        has_surfaces = settings.torn is not None and settings.torn.get("LineType") == "Sticks"
        self.faults = ["%s_faults.%s" % (stem, form) for form in settings.formats
                       if form in writing.MESH_FORMATS] if has_surfaces else []
        # By horizon: file names and the data that they are of.
        self.lines = self._lines(mesh_stems, writing.FAULT_LINES, settings.fault_formats) if settings.torn is not None else {}
        self.cutoffs = self._lines(mesh_stems, writing.CUTOFF_LINES, settings.fault_formats or ["dat"]) if settings.cutoffs is not None else {}
        self.cutoff_tables = ["%s_%s.csv" % (stem, kind) for kind in ("throws", "juxtaposition")] if settings.cutoffs is not None else []

        self.sealed = ["%s_sealed.%s" % (stem, form) for form in ("ml", "msh", "vtp")] if settings.sealed is not None else []
        self.sealed_tables = ["%s_%s.csv" % (stem, kind) for kind in ("bodies", "fault_areas", "picks")] if self.sealed else []

    @staticmethod
    def _lines(mesh_stems, kinds, formats):
        return {name: {"%s_%s.%s" % (mesh_stem, kind, form): given for kind, given in kinds.items() for form in formats}
                for name, mesh_stem in mesh_stems.items()}

    def of_stack(self):
        """Those that belong to all horizons together."""
        return [*self.layers, *self.bodies, *self.cutoff_tables, *self.sealed, *self.sealed_tables, *(file for files in self.cutoffs.values() for file in files)]

    def body(self, number, form):
        """Returns the file name of the body of a layer."""
        return "%s_layer_%d.%s" % (self._stem, number + 1, form)

    def all(self):
        return [*sum(self.meshes.values(), []), *self.figures, *self.pictures, *self.faults, *(file for files in self.lines.values() for file in files), *self.of_stack()]


def _mesh_stems(stem, names):
    """Returns the file stem of each horizon: `x_horizon_7` for Horizon 7 of x.vsm, `x_Top` for Top. A horizon with the same
    name as its file gets the stem alone."""
    stems = []
    for name in names:
        short = reading.short_name(name)
        text = re.sub(r"[^\w.+-]+", "_", "horizon_" + short if short != name else name)
        stems.append(shorten(stem if text == stem else "%s_%s" % (stem, text), LONGEST_NAME - LONGEST_ENDING))
    return distinct(stems)
