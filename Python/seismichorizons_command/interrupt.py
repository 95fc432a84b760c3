# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C and the signal TERM: they are only recorded, and the program ends at the next point where work can stop.

An exception would not work: inside the observers of a stage, VTK prints it and ends the program immediately.
"""

import contextlib
import signal
import sys
import threading

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


@contextlib.contextmanager
def noting():
    """Records Ctrl-C within the block, and raises KeyboardInterrupt after it. Does nothing in threads other than the main
    one, which receive no signals, and in programs that handle signals natively, such as pvbatch under MPI, because Python
    cannot restore their handlers."""
    global _noted
    if threading.current_thread() is not threading.main_thread() or signal.getsignal(signal.SIGINT) is None:
        yield
        return
    before = signal.signal(signal.SIGINT, _note)
    try:
        with contextlib.suppress(SystemExit):
            yield
    finally:
        signal.signal(signal.SIGINT, before)
        asked, _noted = is_asked(), None
    if asked:
        raise KeyboardInterrupt
