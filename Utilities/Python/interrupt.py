# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Ctrl-C and the signal TERM: they are only noted, and the program ends at the next place where work can be left.

An exception would not do: inside the observers of a stage, VTK prints it and ends the program there and then.
"""

import contextlib
import signal
import sys
import threading

_noted = None  # the number of the signal


def listen():
    """From now on the signals are noted."""
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, _note)


def _note(number, _frame):
    global _noted
    _noted = number


def is_asked():
    """Whether the program is to end."""
    return _noted is not None


def check():
    """Raises SystemExit when the program is to end, with the exit code that shells have for the signal."""
    if is_asked():
        sys.exit(128 + _noted)


@contextlib.contextmanager
def noting():
    """Within the block Ctrl-C is only noted; then it is what it is in Python, a KeyboardInterrupt. In another thread than
    the first, which gets no signals, nothing changes, and nor does it in programs that handle signals themselves, as
    pvbatch under MPI: what they have cannot be put back from here."""
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
