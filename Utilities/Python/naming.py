# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Names of files of results: all different, also where systems take names that differ in case alone for the same."""

import collections
import contextlib
import os
import pathlib
import re

from . import figures, reading, writing
from .stage import HorizonError

LONGEST_NAME = 255  # bytes of the name of a file, on all usual systems
LONGEST_STEM, LONGEST_ENDING = 160, 20  # of what names of results start with, and of numbers and extensions


def make_labels(files):
    """What files are called: by their names, with as many of their folders in front as it takes to tell them and their
    results apart (`a/x.vsm`). Raises HorizonError where one is given twice."""
    # Links are not followed: users know files by the names that they gave.
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
        # Folders do not tell files of one folder apart: numbers do.
        twins = [numbers for numbers in users.values() if len({places[number][:-1] for number in numbers}) > 1]
        if not twins or labels == before:
            return labels
        for number in sum(twins, []):
            lengths[number] += 1


def make_stems(labels):
    """What the names of results start with: `a_x` for `a/x.vsm` and for `a/x.vsm.gz`; `x_dat` and `x_map` for files that
    differ in nothing else."""
    short = [_without_extension(label) for label in labels]
    users = collections.Counter(str(stem).casefold() for stem in short)
    return ["_".join(stem.parts) + (label.name[len(stem.name):].replace(".", "_")
                                    if users[str(stem).casefold()] > 1 else "") for label, stem in zip(labels, short)]


def distinct(names):
    """The same names. One that differs from another in case alone, which is the same file on some systems, or not at all,
    gets a number behind it."""
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
    """The beginning of a text, of at most so many bytes in the name of a file."""
    return os.fsencode(text)[:most].decode(errors="ignore") if len(os.fsencode(text)) > most else text


class Taken:
    """Files that no result may replace: those that are read, and the results of others."""

    def __init__(self, files):
        self._inputs = {}
        for path in files:
            with contextlib.suppress(OSError):  # its reader tells
                state = os.stat(path)
                self._inputs[state.st_dev, state.st_ino] = path
        self._names = {}

    def require(self, folder, names, label):
        """Raises HorizonError where one of the names is not free in a folder. Then they are those of a file."""
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
    """The names of the files of results."""

    def __init__(self, stem, names, settings, with_pictures):
        self.meshes = {name: ["%s.%s" % (mesh_stem, form) for form in settings.formats
                              if form not in writing.LAYER_FORMATS]
                       for name, mesh_stem in zip(names, _mesh_stems(stem, names))}
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

    def body(self, number, form):
        """That of the body of a layer."""
        return "%s_layer_%d.%s" % (self._stem, number + 1, form)

    def all(self):
        return [*sum(self.meshes.values(), []), *self.figures, *self.pictures, *self.faults, *self.layers, *self.bodies]


def _mesh_stems(stem, names):
    """What the files of each horizon are called: `x_horizon_7` for Horizon 7 of x.vsm, `x_Top` for Top. A horizon
    that has the name of its file is called as that."""
    stems = []
    for name in names:
        short = reading.short_name(name)
        text = re.sub(r"[^\w.+-]+", "_", "horizon_" + short if short != name else name)
        stems.append(shorten(stem if text == stem else "%s_%s" % (stem, text), LONGEST_NAME - LONGEST_ENDING))
    return distinct(stems)
