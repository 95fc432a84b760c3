#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Measures speed and memory of every stage and of the whole chain, from thousands to millions of points, and of other
programs.

Utilities/Studies/benchmark.sh sets everything up and runs it. Each size with each number of threads runs in a process of
its own, so that none inherits memory from another. Seconds are wall-clock times, the shortest of several runs. Memory is
the largest growth of the resident memory of the process during the first run of a stage, including the result (VmHWM
after a reset through /proc/self/clear_refs, less VmRSS before the run).

The table goes to the standard output and, with --markdown, into a file; with --json all figures also go into a file.
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile

from benchmark_page import page
from benchmark_programs import HUGE, measure_programs, measure_reading, measure_scaling
from text import report

SIZES = (15626, 148317, 886639, 10000000)
MOST_SECONDS = 10.0  # limit for a run of another program


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=pathlib.Path, help="folder of generate_horizons and the benchmark programs")
    parser.add_argument("--sizes", type=int, nargs="+", default=list(SIZES), metavar="N", help="points of the horizons")
    parser.add_argument("--huge", action="store_true", help="50 million points as well (16 GB of memory, some minutes)")
    parser.add_argument("--threads", type=int, nargs="+", default=[1, 2], metavar="N")
    parser.add_argument("--no-peers", action="store_true", help="only ours")
    parser.add_argument("--json", type=pathlib.Path, metavar="FILE")
    parser.add_argument("--markdown", type=pathlib.Path, metavar="FILE")
    return parser.parse_args()


def measure_apart(*arguments):
    """Runs benchmark_stages.py in a separate process."""
    command = [sys.executable, str(pathlib.Path(__file__).with_name("benchmark_stages.py")), *arguments]
    return json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout)


def measure_stages(path, threads, before):
    """Measures all stages. `before` has the results of the previous size, which predict how much memory a stage needs."""
    needs = {r["stage"]: r["bytes_per_point"] for r in before if r["threads"] == threads}
    return measure_apart("stages", str(path), str(threads), json.dumps(needs))


class Peers:
    """Other programs, each until it becomes too slow."""

    def __init__(self):
        self.last = {}  # name: (points, seconds)

    def measure(self, path, points, threads):
        slow = [name for name, (size, seconds) in self.last.items()
                if seconds * (points / size) ** 1.3 > MOST_SECONDS]
        found = measure_apart("peers", str(path), str(threads), json.dumps(slow))
        self.last.update((r["peer"], (points, r["seconds"])) for r in found)
        return found


def measure(options):
    sizes = sorted(options.sizes + ([HUGE] if options.huge else []))
    stages, others = [], []
    peers = Peers()
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "horizon.vsm"
        for size in sizes:
            report("%d points" % size)
            subprocess.run([str(options.programs / "generate_horizons"), "--points", str(size), "--horizons", "1",
                            str(path)], check=True, stdout=subprocess.DEVNULL)
            before = [r for r in stages if r["size"] == max((r["size"] for r in stages), default=0)]
            found = [dict(r, size=size, threads=threads) for threads in options.threads
                     for r in measure_stages(path, threads, before)]
            stages += found
            if not options.no_peers:
                threads = max(options.threads)
                ours = {r["stage"]: r["seconds"] for r in found if r["threads"] == threads}
                others += [dict(r, points=size, threads=threads, our_seconds=ours[r["stage"]])
                           for r in peers.measure(path, size, threads)]
                others += measure_reading(options.programs, path, size)
    if not options.no_peers:
        others += measure_programs(options.programs, sizes)
    return {"processors": os.cpu_count(), "stages": stages,
            "scaling": measure_scaling(options.programs, options.threads, options.sizes),
            "peers": [dict(r, ratio=r["seconds"] / r["our_seconds"]) for r in others]}


def main():
    options = parse_arguments()
    results = measure(options)
    text = page(results, MOST_SECONDS)
    print(text, end="")
    if options.json:
        options.json.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    if options.markdown:
        options.markdown.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
