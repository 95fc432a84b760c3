# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The rooms of Documentation/Architecture.md, and what each may include, are those of the code. Argument: source tree.

Every folder with C++ sources of the product is in a row of the table there. A file includes files of its own room by
their names, and others by paths that lead to rooms its row names; only rooms with VTK in their row include it. Files and
functions keep within their budgets. What is told in several places, versions, is the same everywhere.
"""

import ast
import pathlib
import re
import sys

FREE = ("Testing", "Utilities")  # these may use all
MOST_LINES = 400
MOST_LINES_OF_METHOD = 900  # a file of plain C++, which reads from top to bottom
MOST_LINES_OF_FUNCTION = 60


def read_table(page):
    """The rooms and what they may use: {room: set of rooms and "VTK"}."""
    rooms = {}
    for line in page.read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) == 3 and cells[0].startswith("`"):
            for room in re.findall(r"`([\w/]+)`", cells[0]):
                rooms[room] = set(re.findall(r"`([\w/]+)`", cells[2]) + re.findall(r"\bVTK\b", cells[2]))
    return rooms


def includes(path):
    """The includes of a file with their line numbers: (number, name, whether in quotes)."""
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        found = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
        if found:
            yield number, found.group(2), found.group(1) == '"'


def find_room(tree, path, name):
    """The room of a file of the project that is included; None for files of others."""
    roots = ["", "Filters", "Filters/Algorithms", "Readers", "Writers", "Utilities", "Testing/Algorithms"]
    for candidate in [path.parent / name] + [tree / root / name for root in roots]:
        if candidate.is_file():
            return candidate.parent.relative_to(tree).as_posix()
    # VTK's habit: classes, whose headers are installed side by side, are included by their names.
    classes = list(tree.glob("Filters/" + name)) + [path for folder in ("Readers/*/", "Writers/", "Writers/*/")
                                                    for path in tree.glob(folder + name)]
    return classes[0].parent.relative_to(tree).as_posix() if classes else None


def check_file(tree, path, rooms):
    """What is wrong with the includes of a file."""
    where = path.relative_to(tree).as_posix()
    room = path.parent.relative_to(tree).as_posix()
    if room not in rooms:
        return ["%s: no row for the room %s in the table" % (where, room)]
    wrong = []
    for number, name, _ in includes(path):
        other = find_room(tree, path, name)
        if other and other != room and other not in rooms[room]:
            wrong.append("%s:%d: %s may not use %s" % (where, number, room, other))
        if not other and name.startswith("vtk") and "VTK" not in rooms[room]:
            wrong.append("%s:%d: %s may not use VTK" % (where, number, room))
    return wrong


def check_length(tree, path):
    where = path.relative_to(tree).as_posix()
    lines = len(path.read_text(encoding="utf-8").splitlines())
    is_method = where.startswith("Filters/Algorithms/") and path.suffix == ".cxx"
    most = MOST_LINES_OF_METHOD if is_method else MOST_LINES
    return ["%s: %d lines, expected at most %d" % (where, lines, most)] if lines > most else []


def functions_of(path):
    """The functions of a file: (line, length of the body). In C++ all blocks but those of namespaces and types."""
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".py":
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, (ast.FunctionDef, ast.Lambda)):
                yield node.lineno, node.end_lineno - node.lineno
        return
    lines = text.splitlines()
    for first, line in enumerate(lines):
        is_type = re.match(r"\s*(namespace|class|struct|enum|union)\b", lines[first - 1])
        heads_type = re.match(r"\s*[:,] public", lines[first - 1])
        if line.strip() == "{" and not is_type and not heads_type:
            last = next(n for n in range(first, len(lines)) if re.match(line.replace("{", "}"), lines[n]))
            yield first + 1, last - first - 1


def check_functions(tree, path):
    where = path.relative_to(tree).as_posix()
    return ["%s:%d: a function of %d lines, expected at most %d" % (where, number, lines, MOST_LINES_OF_FUNCTION)
            for number, lines in functions_of(path) if lines > MOST_LINES_OF_FUNCTION]


def check_cycles(rooms):
    """Rooms that use each other, directly or not."""
    def reaches(start, goal, seen):
        return any(room == goal or (room not in seen and reaches(room, goal, seen | {room}))
                   for room in rooms.get(start, ()))
    return ["the room %s uses itself in a circle" % room for room in rooms if reaches(room, room, {room})]


def check_versions(tree):
    """That of the project, and that of VTK which the wheel stands on."""
    own = {re.search(pattern, (tree / name).read_text(encoding="utf-8")).group(1) for name, pattern in (
        ("CMakeLists.txt", r"\n  VERSION ([\d.]+)\n"), ("CITATION.cff", r"\nversion: ([\d.]+)\n"))}
    vtk = re.findall(r'"vtk(?:-sdk)?==([\d.]+)"', (tree / "pyproject.toml").read_text(encoding="utf-8"))
    return ["versions %s and %s, expected the same" % tuple(sorted(found)[:2]) for found in (own, set(vtk)) if len(found) > 1]


def main():
    tree = pathlib.Path(sys.argv[1])
    rooms = read_table(tree / "Documentation" / "Architecture.md")
    folders = ["Common", "Filters", "Readers", "Writers", "ParaViewPlugin", "Utilities", "Testing"]
    sources = sorted(path for folder in folders for path in (tree / folder).rglob("*")
                     if path.suffix in (".h", ".cxx") and "Consumer" not in path.parts)
    scripts = sorted(path for folder in folders for path in (tree / folder).rglob("*.py"))
    assert len(rooms) > 10 and len(sources) > 100 and len(scripts) > 10, (rooms, len(sources), len(scripts))
    wrong = ["the room %s is not there" % room for room in rooms if not (tree / room).is_dir()]
    wrong += check_cycles(rooms) + check_versions(tree)
    for path in sources:
        if path.relative_to(tree).parts[0] not in FREE:
            wrong += check_file(tree, path, rooms)
    for path in sources + scripts:
        wrong += check_length(tree, path) + check_functions(tree, path)
    print("\n".join(wrong) or "%d files in %d rooms" % (len(sources), len(rooms)))
    sys.exit(1 if wrong else 0)


main()
