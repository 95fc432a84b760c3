# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""How far long work is, on a terminal: a line for each stage that takes more than a second, with its rate and the time
that is left. Where the error output is no terminal, nothing is said."""

import os
import shutil
import sys
import time

LONG_WORK = 1.0  # seconds after which work starts to tell
BETWEEN = 0.2  # seconds from one look of the line to the next
SMALLEST_PART = 0.01  # with less done, nothing is known of what is left


class Progress:
    """Of one stage, which has a label; without one nothing is said. `work` is how much there is to do, as (number, unit),
    say (6000000, "points"); None where that is not known."""

    def __init__(self, label, work=None):
        self._label = label
        self._work = work
        self._start = time.monotonic()
        self._last = self._start + LONG_WORK - BETWEEN
        self._told = False

    def tell(self, part):
        """The part of the work that is done, from 0 to 1."""
        now = time.monotonic()
        if not self._label or now - self._last < BETWEEN or not sys.stderr.isatty():
            return
        self._last = now
        self._told = True
        self._write("\r", self.line(part, now - self._start), "")

    def end(self):
        """The line stays, with the whole time in place of that which is left."""
        if self._told:
            self._write("\r", self.line(None, time.monotonic() - self._start), "\n")

    def line(self, part, seconds):
        """The words of the line after so many seconds; a part of None is the end."""
        words = ["%s: %s" % (self._label, "done" if part is None else "%3.0f %%" % (100.0 * part))]
        done = 1.0 if part is None else part
        if self._work and done >= SMALLEST_PART and seconds > 0.0:
            words.append("%s/s" % amount_text(done * self._work[0] / seconds, self._work[1]))
        if part is None:
            words.append(duration_text(seconds))
        elif part >= SMALLEST_PART:
            words.append("%s left" % duration_text(seconds * (1.0 - part) / part))
        return "  ".join(words)

    @staticmethod
    def _write(before, line, after):
        # A line that is longer than the terminal would go on below, and be there many times.
        width = shutil.get_terminal_size().columns - 1
        sys.stderr.write(before + line[:width] + "\x1b[K" + after)
        sys.stderr.flush()


def file_work(path):
    """The bytes of a file as work; None where there is no file."""
    try:
        return os.path.getsize(path), "B"
    except OSError:
        return None


def amount_text(number, unit):
    """Three digits of a number, as "1.25 M points"."""
    for limit, letter in ((1e12, "T"), (1e9, "G"), (1e6, "M"), (1e3, "k")):
        if number >= 0.9995 * limit:
            return "%.3g %s%s%s" % (number / limit, letter, "" if len(unit) == 1 else " ", unit)
    return "%.3g %s" % (number, unit)


def duration_text(seconds):
    """Seconds below ten with a digit, then minutes and hours."""
    if seconds < 9.95:
        return "%.1f s" % seconds
    seconds = round(seconds)
    if seconds < 60:
        return "%d s" % seconds
    if seconds < 3600:
        return "%d min %02d s" % divmod(seconds, 60)
    return "%d h %02d min" % divmod(seconds // 60, 60)
