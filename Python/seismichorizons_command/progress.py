# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Progress of long work on a terminal: a line for each stage that takes more than a second, with its rate and the remaining
time. Nothing is shown if the error output is not a terminal."""

import os
import shutil
import sys
import time

LONG_WORK = 1.0  # seconds before the line appears
BETWEEN = 0.2  # seconds between updates of the line
SMALLEST_PART = 0.01  # fraction below which the remaining time is not estimated

_is_silent = False


def silence():
    """Shows no progress from now on."""
    global _is_silent
    _is_silent = True


class Progress:
    """Progress of one stage; without a label nothing is shown. `work` is the amount of work as (number, unit), for example
    (6000000, "points"); None if unknown."""

    def __init__(self, label, work=None):
        self._label = label
        self._work = work
        self._start = time.monotonic()
        self._last = self._start + LONG_WORK - BETWEEN
        self._is_shown = False

    def show(self, fraction):
        """Shows the fraction of the work that is done, from 0 to 1."""
        now = time.monotonic()
        if _is_silent or not self._label or now - self._last < BETWEEN or not sys.stderr.isatty():
            return
        self._last = now
        self._is_shown = True
        self._write("\r", self.line(fraction, now - self._start), "")

    def end(self):
        """Shows the total time in place of the remaining time."""
        if self._is_shown:
            self._write("\r", self.line(None, time.monotonic() - self._start), "\n")

    def line(self, fraction, seconds):
        """Returns the text after a number of seconds; a fraction of None means the end."""
        words = ["%s: %s" % (self._label, "done" if fraction is None else "%3.0f %%" % (100.0 * fraction))]
        done = 1.0 if fraction is None else fraction
        if self._work and done >= SMALLEST_PART and seconds > 0.0:
            words.append("%s/s" % amount_text(done * self._work[0] / seconds, self._work[1]))
        if fraction is None:
            words.append(duration_text(seconds))
        elif fraction >= SMALLEST_PART:
            words.append("%s left" % duration_text(seconds * (1.0 - fraction) / fraction))
        return "  ".join(words)

    @staticmethod
    def _write(before, line, after):
        # A line longer than the terminal would wrap, and then be repeated at each update.
        width = shutil.get_terminal_size().columns - 1
        sys.stderr.write(before + line[:width] + "\x1b[K" + after)
        sys.stderr.flush()


def file_work(path):
    """Returns the bytes of a file as work; None if there is no file."""
    try:
        return os.path.getsize(path), "B"
    except OSError:
        return None


def amount_text(number, unit):
    """Returns a number with three significant digits, such as "1.25 M points"."""
    for limit, letter in ((1e12, "T"), (1e9, "G"), (1e6, "M"), (1e3, "k")):
        if number >= 0.9995 * limit:
            return "%.3g %s%s%s" % (number / limit, letter, "" if len(unit) == 1 else " ", unit)
    return "%.3g %s" % (number, unit)


def duration_text(seconds):
    """Returns seconds with one decimal below ten, otherwise as seconds, minutes or hours."""
    if seconds < 9.95:
        return "%.1f s" % seconds
    seconds = round(seconds)
    if seconds < 60:
        return "%d s" % seconds
    if seconds < 3600:
        return "%d min %02d s" % divmod(seconds, 60)
    return "%d h %02d min" % divmod(seconds // 60, 60)
