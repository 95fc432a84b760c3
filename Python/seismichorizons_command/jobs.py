# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Files in several processes. A process works on one file, in a folder of the workspace, and sends what it found; the main
process puts results in place and reports, in the order of the files, so that the number of processes changes nothing."""

import contextlib
import copy
import ctypes
import os
import pickle
import select
import signal
import sys
import tempfile
import traceback
from dataclasses import dataclass, field
from typing import Optional

from . import interrupt, progress
from .core import HorizonError

CAN_FORK = hasattr(os, "fork")
BETWEEN = 0.1  # seconds between looks at the signals
CHUNK = 1 << 20  # bytes read at a time
PR_SET_PDEATHSIG = 1  # of Linux


@dataclass
class Outcome:
    """What a process found in a file. `file` is its record, `before` its record when the names of the results were known,
    and `unpublished` the one when they were complete; `told` is the number of messages before the names were known.
    `folder` has the results, if they are complete, and `stacked` belongs to layers between files."""

    file: dict = field(default_factory=dict)
    before: dict = field(default_factory=dict)
    unpublished: dict = field(default_factory=dict)
    messages: list = field(default_factory=list)
    told: int = 0
    names: list = field(default_factory=list)
    lines: list = field(default_factory=list)
    folder: Optional[str] = None
    meshes: int = 0
    entries: list = field(default_factory=list)
    layers: list = field(default_factory=list)
    stacked: Optional[tuple] = None


class Later:
    """Keeps results for the main process, in place of batch.Results."""

    def __init__(self, results, outcome, record):
        self.workspace, self.folder = results.workspace, results.folder
        self._outcome, self._record = outcome, record

    def require(self, names, _label):
        self._outcome.names, self._outcome.told = names, len(self._outcome.messages)
        self._outcome.before = copy.deepcopy(self._record.files[-1])

    def publish(self, folder):
        self._outcome.unpublished = copy.deepcopy(self._record.files[-1])
        kept = tempfile.mkdtemp(dir=self.workspace)
        written = sorted(os.listdir(folder))
        for name in written:
            os.replace(os.path.join(folder, name), os.path.join(kept, name))
        self._outcome.folder = kept
        return written


def run_in_order(work, tasks, number):
    """Yields work(task) of each task, in order; at most `number` processes run at a time. Yields an
    error instead if a process ends early. If the program is asked to end, ends all processes and raises SystemExit."""
    running, done = {}, {}
    waiting = list(enumerate(tasks))
    try:
        for place in range(len(tasks)):
            while place not in done:
                while waiting and len(running) < number:
                    following, task = waiting.pop(0)
                    process, pipe = _start(work, task, list(running))
                    running[pipe] = (following, process, bytearray())
                for pipe in select.select(list(running), [], [], BETWEEN)[0]:
                    chunk = os.read(pipe, CHUNK)
                    running[pipe][2].extend(chunk)
                    if not chunk:
                        following, process, content = running.pop(pipe)
                        os.close(pipe)
                        done[following] = _received(content, os.waitstatus_to_exitcode(os.waitpid(process, 0)[1]))
                interrupt.check()
            yield done.pop(place)
    finally:
        for pipe, (_, process, _) in running.items():
            os.close(pipe)
            os.kill(process, signal.SIGKILL)  # what it leaves is in the workspace
            os.waitpid(process, 0)


def _received(content, code):
    """Returns what a process has sent or, if it ended early, an error."""
    if code == 0:
        return pickle.loads(content)
    end = "signal %d" % -code if code < 0 else "exit code %d" % code
    return HorizonError("its process ended with %s; fewer --jobs leave more memory to each" % end)


def _start(work, task, pipes):
    """Starts a process, which sends work(task) and ends. Returns its number and the pipe to read from."""
    reading, writing = os.pipe()
    main = os.getpid()
    sys.stdout.flush()
    sys.stderr.flush()
    process = os.fork()
    if process:
        os.close(writing)
        return process, reading
    code = 1
    try:
        for pipe in [reading, *pipes]:
            os.close(pipe)
        _end_with(main)
        progress.silence()
        with open(writing, "wb") as stream:
            pickle.dump(work(task), stream)
        code = 0
    except BaseException as error:  # nothing of the main process may run here
        if not isinstance(error, SystemExit):  # it was asked to end at its beginning
            traceback.print_exc()
    finally:
        os._exit(code)


def _end_with(main):
    """Lets the main process decide when this one ends, and ends it if the main process is killed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    with contextlib.suppress(AttributeError, OSError):  # other systems than Linux
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
    if os.getppid() != main:
        os._exit(1)


def store(points, folder):
    """Writes points into a folder for the main process and returns the path."""
    descriptor, path = tempfile.mkstemp(dir=folder, suffix=".points")
    try:
        with open(descriptor, "wb") as file:
            pickle.dump(points, file, pickle.HIGHEST_PROTOCOL)
    except OSError as error:
        raise HorizonError("%s cannot be written: %s" % (path, error.strerror)) from None
    return path


def restore(path):
    """Returns the points that another process stored, and removes the file."""
    with open(path, "rb") as file:
        points = pickle.load(file)
    os.unlink(path)
    return points
