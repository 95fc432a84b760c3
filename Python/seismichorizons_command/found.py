# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Summarizes in a few lines how a file was interpreted, so that a wrong guess is visible: columns, lattice, heights and
omitted points."""

import math

from . import data, figures, heights, pipeline, reading
from .settings import with_options

MOST_NAMES = 4  # of files that are written
DIRECTION = "z increases "  # begins what a source says of the direction of z
SUPPOSED = ", taken as "  # is in what a source supposes


class Found:
    """Summary of one file, whose horizons are added one after the other."""

    def __init__(self):
        self._surveys = []
        self._bounds = []
        self._errors = []  # automatic ones: (vertical step, error in vertical indices, that of which it is six times, its name)

    def add(self, horizon, mesh):
        """Adds a horizon as it was read, or the mesh of a horizon larger than memory, and its mesh."""
        if not data.count_points(horizon):  # nothing is known of a horizon larger than memory without a mesh
            return
        self._surveys.append(figures.survey(horizon))
        self._bounds.append(data.bounds(horizon)[4:6])
        noise = heights.noise_of(mesh)
        if noise:
            word, deviation = noise
            self._errors.append((heights.step_of(mesh) or 1.0, pipeline.chosen_parameters(mesh)["MaximumError"], deviation, word))

    def lines(self, origin, settings):
        """Returns the summary; `origin` is the result of reading.describe."""
        what = [*(origin["description"][:1] or [origin["format"]]), *(
            with_options(line) for line in origin["description"][1:] if SUPPOSED in line)]
        if not self._surveys:
            return what
        reason = next((line for line in origin["description"] if line.startswith(DIRECTION)), "")
        return [*what, *self._lattice(), self._heights(origin["format"], settings, reason), *self._left_out(), *settings.fault_files]

    def _lattice(self):
        survey = self._surveys[0]
        lattice = survey["lattice"]
        if not lattice:
            return []
        steps = lattice["column_step"][:2], lattice["row_step"][:2]
        lines = "crosslines and inlines" if survey["line_numbers"] else "columns and rows"
        return ["%d x %d %s, %.7g x %.7g apart, the first axis %.4g degrees from north" % (
            *lattice["columns"][:2], lines, *(math.hypot(*step) for step in steps),
            math.degrees(math.atan2(*steps[0])) % 360.0)]

    def _heights(self, form, settings, reason):
        """Returns the range of z as in the file, its direction and the reason for it, and the size of a vertical index."""
        survey = self._surveys[0]
        down = survey["vertical_direction"] == "down"
        least, most = min(b[0] for b in self._bounds), max(b[1] for b in self._bounds)
        if down:
            least, most = -most, -least
        is_count = reading.counts_indices(form, settings.reader)
        said = settings.said_unit()
        supposed = "%s (as the error; --vertical-unit %s also stores it)" % (said, said) if said else ""
        known = survey["vertical_unit"] or said
        unit = survey["vertical_unit"] or supposed or ("vertical indices" if is_count else "(unit unknown)")
        steps = sorted({abs(s["lattice"]["vertical_step"]) for s in self._surveys if s["lattice"]})
        error = settings.plain_error()
        because = reason.partition(", ")[2].replace("VerticalDirection", "--vertical-direction")
        words = ["z %.7g to %.7g %s, growing %s" % (least + 0.0, most + 0.0, unit, "down" if down else "up")
                 + (" (%s)" % because if because else "")]
        if steps and not is_count:
            words.append("vertical step %s" % _range(steps))
            if error is not None:
                words.append(" ".join(["error of %g vertical indices: %s" % (error, _range([error * step for step in steps])), known]).strip())
        if self._errors:
            errors, noises = (sorted(own[place] * (1.0 if is_count else own[0]) for own in self._errors) for place in (1, 2))
            words.append("%s, six times the %s of %s" % (
                " ".join(["error", _range(errors, 2), "vertical indices" if is_count else known]).strip(),
                " or ".join(sorted({own[3] for own in self._errors})), _range(noises, 2)))
        return "; ".join(words)

    def _left_out(self):
        """Returns a line on points that are not in the horizons, if there are any."""
        left_out = [(sum(s[key] or 0 for s in self._surveys), what) for key, what in
                    (("dropped_duplicates", "duplicates"), ("dropped_nulls", "without z"))]
        words = [("%d %s left out" % pair).replace("1 duplicates", "1 duplicate") for pair in left_out if pair[0]]
        repeats = sum(s["dropped_repeats"] or 0 for s in self._surveys)
        conflict = max(s["largest_conflict"] or 0.0 for s in self._surveys)
        words += ["%d of the duplicates exact repeats" % repeats] if repeats else []
        words += ["others up to %.4g apart" % conflict] if conflict else []
        return ["; ".join(words)] if words else []


def _range(values, digits=6):
    least, most = ("%.*g" % (digits, value) for value in (values[0], values[-1]))
    return least if least == most else "%s to %s" % (least, most)


def written(names, folder):
    """Returns a line with the names of the results."""
    shown = names if len(names) <= MOST_NAMES else [*names[:MOST_NAMES], "..."]
    return "%d file%s in %s: %s" % (len(names), "" if len(names) == 1 else "s", folder, ", ".join(shown))
