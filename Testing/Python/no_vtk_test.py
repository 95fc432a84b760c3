# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The methods know nothing of VTK, but for one small header that spreads loops over threads. Argument: source tree."""

import pathlib
import re
import sys

ALLOWED = "Parallel.h"


def main():
    tree = pathlib.Path(sys.argv[1])
    sources = sorted((tree / "Filters" / "Algorithms").iterdir()) + sorted(tree.glob("Readers/SparseMatrix*"))
    sources += sorted(tree.glob("Utilities/*.cxx")) + sorted(tree.glob("Utilities/*.h"))
    assert len(sources) > 5, sources
    found = []
    for path in sources:
        if path.name == ALLOWED:
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if re.match(r'\s*#\s*include\s*[<"]vtk', line):
                found.append("%s:%d: %s" % (path.relative_to(tree), number, line))
    print("\n".join(found) or "%d files include nothing of VTK" % len(sources))
    sys.exit(1 if found else 0)


main()
