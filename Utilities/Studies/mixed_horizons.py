# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes one .vsm file of horizons of mixed size on one lattice, from several runs of generate_horizons.

    python3 mixed_horizons.py build/release/bin/generate_horizons mixed.vsm

The default is 200 horizons of 5000 to 500000 points, 5 million points in all.
"""

import argparse
import pathlib
import subprocess
import tempfile

# Numbers of horizons, and approximate points of each.
CLASSES = ((1, 500000), (4, 200000), (15, 80000), (40, 30000), (60, 15000), (80, 5000))
LARGEST_AT_ONCE = 20  # horizons generated together, one above the other


def read_columns(path):
    """Returns the size of a lattice, and its lines with the voxels of each column."""
    with open(path, encoding="ascii") as file:
        size = [int(number) for number in file.readline().split()]
        return size, [line.split() for line in file]


def shift(line, first_index, first_id):
    """Returns the voxels of a column with shifted vertical indices and IDs."""
    for position in range(0, len(line), 5):
        line[position] = str(int(line[position]) + first_index)
        line[position + 1] = str(int(line[position + 1]) + first_id)
    return line


def generate(program, horizons, points, seed, folder):
    path = pathlib.Path(folder) / "part.vsm"
    depth = max(120, 6 * horizons)
    side = int((1.83 * points) ** 0.5) + 8  # a horizon covers about half of its square
    subprocess.run([program, "--size", str(side), str(side), str(depth), "--horizons", str(horizons), "--seed", str(seed),
                    "--holes", "4", "--islands", "2", str(path)], check=True, stdout=subprocess.DEVNULL)
    return read_columns(path)


def merge(parts):
    """Stacks several lattices into one; returns its size and the voxels of each column."""
    size = [max(part[axis] for part, _, _ in parts) for axis in (0, 1)] + [0]
    columns = [[] for _ in range(size[0] * size[1])]
    for part, lines, first_id in parts:
        for number, line in enumerate(lines):
            j, i = divmod(number, part[0])
            columns[j * size[0] + i] += shift(line, size[2], first_id)
        size[2] += part[2]
    return size, columns


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", metavar="GENERATE_HORIZONS")
    parser.add_argument("file", metavar="FILE.vsm")
    parser.add_argument("--scale", type=float, default=1.0, help="of the numbers of points (default: %(default)s)")
    arguments = parser.parse_args()
    parts, first_id = [], 0
    with tempfile.TemporaryDirectory() as folder:
        for count, points in CLASSES:
            for begin in range(0, count, LARGEST_AT_ONCE):
                horizons = min(LARGEST_AT_ONCE, count - begin)
                size, lines = generate(arguments.program, horizons, points * arguments.scale, first_id + 1, folder)
                parts.append((size, lines, first_id))
                first_id += horizons
    size, columns = merge(parts)
    with open(arguments.file, "w", encoding="ascii") as file:
        file.write("%d %d %d\n" % tuple(size))
        file.writelines(" ".join(column) + "\n" for column in columns)


main()
