# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Starts a server of ParaView and a client of it over loopback (client_server_client.py), without the plugin on either
side until the client loads it, and ends both, whatever happens.

Arguments: the folder of the data, a folder for results, pvpython, the server, and on how many processes it runs. Exits
with 77 where the server is not installed.
"""

import os
import pathlib
import random
import shutil
import signal
import socket
import subprocess
import sys
import threading

LONGEST = 200  # seconds for everything


def find_port():
    """Returns a free port below those that the system gives to programs, such as mpirun."""
    while True:
        port = random.randrange(20000, 32000)
        with socket.socket() as probe:
            if probe.connect_ex(("127.0.0.1", port)) != 0:
                return port


def start(command, **options):
    # In a group of its own, so that what it starts can be ended, too.
    return subprocess.Popen(command, start_new_session=True, **options)


def end(process):
    if process.poll() is None:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()


def wait_for_server(server):
    for line in server.stdout:
        print("server: " + line, end="", flush=True)
        if "Accepting connection" in line:
            # Read on, or the server would wait for somebody to do so.
            threading.Thread(target=server.stdout.read, daemon=True).start()
            return
    raise RuntimeError("the server ended without accepting a connection")


def main():
    data, folder, pvpython, pvserver, ranks = sys.argv[1:]
    command = (["mpirun", "-np", ranks] if int(ranks) > 1 else []) + [pvserver]
    absent = sorted(program for program in {command[0], pvserver} if not shutil.which(program))
    if absent:
        print("not installed: %s" % ", ".join(absent))
        sys.exit(77)
    port = str(find_port())
    script = pathlib.Path(__file__).with_name("client_server_client.py")
    os.environ.pop("PV_PLUGIN_PATH", None)
    server = start([*command, "--server-port=" + port], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                   errors="replace")
    processes = [server]
    watch = threading.Timer(LONGEST, lambda: [end(process) for process in processes])
    watch.start()
    try:
        wait_for_server(server)
        client = start([pvpython, str(script), data, folder, port])
        processes.append(client)
        assert client.wait() == 0, "exit code %d of the client" % client.returncode
        assert server.wait(timeout=20) == 0, "exit code %d of the server" % server.returncode
    finally:
        watch.cancel()
        for process in processes:
            end(process)


main()
