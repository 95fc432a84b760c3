# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Every kind of wrong file, and what the message about it has to contain."""

VOXEL = b"1 7 1 0.5 4.0"

# name: (content, parts of the message)
FILES = {
    "empty": (b"", ["line 1"]),
    "header-words": (b"two by two\n", ["line 1", "two by two"]),
    "header-short": (b"2 2\n\n\n\n\n", ["line 1", "2 2"]),
    "header-negative": (b"2 -2 3\n\n\n\n\n", ["line 1", "-2"]),
    "header-zero": (b"0 2 3\n", ["line 1", "0 2 3"]),
    "header-overflow": (b"2000000000 2000000000 2000000000\n", ["line 1"]),
    "value-count": (b"2 1 3\n" + VOXEL + b" 2\n\n", ["line 2", "6 values"]),
    "vertical-index-large": (b"2 1 3\n\n3 7 1 0.5 4.0\n", ["line 3", "\"3\"", "0 to 2"]),
    "vertical-index-negative": (b"2 1 3\n-1 7 1 0.5 4.0\n\n", ["line 2", "\"-1\"", "0 to 2"]),
    "word": (b"2 1 3\n1 7 1 strong 4.0\n\n", ["line 2", "\"strong\""]),
    "not-a-number": (b"2 1 3\n\n1 7 1 nan 4.0\n", ["line 3", "\"nan\"", "finite"]),
    "infinite": (b"2 1 3\n\n1 7 1 0.5 inf\n", ["line 3", "\"inf\"", "finite"]),
    "two-in-a-cell": (b"2 1 3\n" + VOXEL + b" " + VOXEL + b"\n\n", ["line 2", "vertical index 1"]),
    "too-long": (b"2 1 3\n\n" + VOXEL + b"\n" + VOXEL + b"\n", ["line 4", "last column"]),
    "too-short": (b"2 2 3\n\n" + VOXEL, ["line 3", "2 columns", "expected 4"]),
}


def write(folder):
    """Writes all of them and returns a list of (path, parts of the message)."""
    folder.mkdir(parents=True, exist_ok=True)
    written = []
    for name, (content, parts) in FILES.items():
        path = folder / (name + ".vsm")
        path.write_bytes(content)
        written.append((path, parts))
    directory = folder / "directory.vsm"
    directory.mkdir(exist_ok=True)
    written.append((directory, [str(directory)]))
    missing = folder / "missing.vsm"
    written.append((missing, [str(missing)]))
    return written
