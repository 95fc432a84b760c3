# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C and the signal TERM: they are only recorded, and the program ends at the next point where work can stop.

Results are put in place all together, which an exception at any moment could interrupt.
"""

import signal
import sys

_noted = None  # the number of the signal


def listen():
    """Starts recording the signals."""
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, _note)


def _note(number, _frame):
    global _noted
    _noted = number


def is_asked():
    """Whether the program has been asked to end."""
    return _noted is not None


def check():
    """Raises SystemExit if the program has been asked to end, with the usual shell exit code of the signal."""
    if is_asked():
        sys.exit(128 + _noted)
