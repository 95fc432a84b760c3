# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A command under with-xvfb.sh has its X server as long as it runs, also after Ctrl-C. Argument: with-xvfb.sh."""

import os
import shutil
import signal
import subprocess
import sys

SKIPPED = 77  # for CTest

COMMAND = """
import signal, sys, time
from seismichorizons_command import batch

def finish(_number, _frame):
    time.sleep(0.5)  # a server that ends, too, has done so by then
    assert batch.why_no_pictures() is None
    print("finished")
    sys.exit(3)

signal.signal(signal.SIGINT, finish)
print("ready", flush=True)
while True:
    time.sleep(0.1)  # signal.pause() would wait for another one, should this one come just before it
"""


def main():
    if not shutil.which("Xvfb"):
        sys.exit(SKIPPED)
    with subprocess.Popen([sys.argv[1], sys.executable, "-c", COMMAND], stdout=subprocess.PIPE, text=True,
                          start_new_session=True) as process:
        assert process.stdout.readline() == "ready\n"
        # As a terminal does it.
        os.killpg(process.pid, signal.SIGINT)
        output, _ = process.communicate(timeout=60)
    assert (output, process.returncode) == ("finished\n", 130), (output, process.returncode)


main()
