# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Rooms use rooms as Documentation/Architecture.md draws them. Argument: source tree.

Every folder with C++ sources of the product is on a floor of the drawing there, uses rooms of its own floor without
circles and others on lower floors alone, and none that a rule forbids. Files and functions keep within their budgets.
A name has one meaning in all of them. What is said in several places, versions, is the same everywhere.
"""

import ast
import pathlib
import re
import sys

FREE = ("Testing", "Utilities")  # these may use all
MOST_LINES = 400
MOST_LINES_OF_METHOD = 900  # a file of plain C++, which reads from top to bottom
MOST_LINES_OF_FUNCTION = 60


def read_floors(page):
    """The drawing of the rooms: patterns and their floors, 0 the lowest; and rules (rooms, rooms that they may not use)."""
    text = page.read_text(encoding="utf-8")
    drawing = re.search(r"## Rooms\n.*?```\n(.*?)```", text, re.S).group(1).splitlines()
    floors = {room: floor for floor, line in enumerate(reversed(drawing)) for room in re.findall(r"[A-Z]\w*(?:/[\w*]+)*(?=  |$)", line)}
    rules = [[re.findall(r"`([\w/*]+)`", side) for side in line.split(" may not use ")]
             for line in text.splitlines() if " may not use " in line]
    return floors, [(users, used) for users, used in rules]


def matches(room, pattern):
    return room == pattern or (pattern.endswith("/*") and (room + "/").startswith(pattern[:-1]))


def floor_of(room, floors):
    """The floor of the longest pattern that a room has; None without one."""
    patterns = [pattern for pattern in floors if matches(room, pattern)]
    return floors[max(patterns, key=len)] if patterns else None


def includes(path):
    """The includes of a file with their line numbers: (number, name, whether in quotes)."""
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        found = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
        if found:
            yield number, found.group(2), found.group(1) == '"'


def find_room(tree, path, name, classes):
    """The room of a file of the project that is included; None for files of others. Classes are included by their names."""
    for candidate in (path.parent / name, tree / name):
        if candidate.is_file():
            return candidate.parent.relative_to(tree).as_posix()
    return classes.get(name)


def check_file(tree, path, floors, rules, classes, arrows):
    """What is wrong with the includes of a file; adds arrows between rooms of a floor."""
    where = path.relative_to(tree).as_posix()
    room = path.parent.relative_to(tree).as_posix()
    floor = floor_of(room, floors)
    if floor is None:
        return ["%s: the room %s is not in the drawing" % (where, room)]
    forbidden = [pattern for users, used in rules if any(matches(room, user) for user in users) for pattern in used]
    wrong = []
    for number, name, _ in includes(path):
        other = find_room(tree, path, name, classes) or ("VTK" if name.startswith("vtk") else None)
        if other in (None, room):
            continue
        above = floor_of(other, floors)
        if above is not None and above > floor:
            wrong.append("%s:%d: %s is above %s" % (where, number, other, room))
        if above == floor:
            arrows.setdefault(room, set()).add(other)
        if any(matches(other, pattern) for pattern in forbidden):
            wrong.append("%s:%d: %s may not use %s" % (where, number, room, other))
    return wrong


def check_comments(tree, path, names):
    """Files that comments name exist."""
    where = path.relative_to(tree).as_posix()
    return ["%s:%d: there is no file %s" % (where, number, name)
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1) if "//" in line
            for name in re.findall(r"\b([A-Z]\w*\.(?:h|cxx|md))\b", line.split("//", 1)[1]) if name not in names]


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


TYPE = r"^(?:class|struct|enum class|using) (\w+)(?=[\s:=])(?! \w)"
CONSTANT = r"^const(?:expr)? [\w:<>, ]+?[ &*](\w+)(?:\[\w*\])? ?[={;]"
FUNCTION = r"^[\w:<>,&* ]+?[ *&](\w+\([^;{}]*\))\n\{"  # with the types of its parameters


def names_in(text, patterns):
    for pattern in patterns:
        for found in re.finditer(pattern, text, re.M):
            yield re.sub(r"\s+", " ", re.sub(r"(?<=[\s&*>])\w+( = [^,]*)?(?=[,)])", "", found.group(1)))


def names_of(path):
    """The types of a header, or what unnamed namespaces of another file declare for that file."""
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".h":
        yield from names_in(text, (TYPE,))
        return
    for space in unnamed_spaces(text):
        yield from names_in(space, (TYPE, CONSTANT, FUNCTION))


def unnamed_spaces(text):
    for space in re.finditer(r"^namespace\n\{\n", text, re.M):
        depth, end = 1, space.end()
        while depth > 0:
            brace = re.compile(r"^(\{$|\})", re.M).search(text, end)
            depth, end = depth + (1 if brace.group() == "{" else -1), brace.end()
        yield text[space.end():end]


def is_method(path):
    """Whether a file is compiled with all methods, and without VTK."""
    return path.parts[0] in ("Common", "Filters", "Readers", "Writers") and path.parts[1] != "VTK" and not path.name.startswith("vtk")


def check_hidden(tree, paths):
    """Where files are compiled as one, a function of an unnamed namespace hides declared ones of its name."""
    declared, unnamed = {}, {}
    for path in paths:
        place = path.relative_to(tree).as_posix()
        text = path.read_text(encoding="utf-8")
        for part in [text] if path.suffix == ".h" else unnamed_spaces(text):
            for found in re.finditer(r"^[A-Za-z][\w:<>,&* ]*[ *&]([A-Z]\w+)\(", part, re.M):
                (declared if path.suffix == ".h" else unnamed).setdefault(found.group(1), set()).add(place)
    assert len(declared) > 300 and len(unnamed) > 900, (len(declared), len(unnamed))
    return ["%s: %s hides that of %s" % (place, name, " and ".join(sorted(declared[name])))
            for name in sorted(set(declared) & set(unnamed)) for place in sorted(unnamed[name])]


def check_names(tree, paths):
    """Any files may be compiled as one, in which a name has to have one meaning."""
    places = {}
    for path in paths:
        for name in names_of(path):
            places.setdefault(name, set()).add(path)
    assert len(places) > 2000, len(places)
    all_of = {name: where | places.get(name.split("(")[0], set()) for name, where in places.items()}
    return ["two of the name %s: %s" % (name, " and ".join(sorted(path.relative_to(tree).as_posix() for path in where)))
            for name, where in all_of.items() if len(where) > 1]


def check_cycles(rooms):
    """Rooms that use each other, directly or not."""
    def reaches(start, goal, seen):
        return any(room == goal or (room not in seen and reaches(room, goal, seen | {room}))
                   for room in rooms.get(start, ()))
    return ["the room %s uses itself in a circle" % room for room in rooms if reaches(room, room, {room})]


def check_versions(tree):
    """The version of the project, or its first two numbers, is the same wherever it is written."""
    def said(name, pattern):
        return re.search(pattern, (tree / name).read_text(encoding="utf-8"), re.MULTILINE).group(1)
    own = said("CMakeLists.txt", r"^  VERSION ([\d.]+)$")
    found = [(name, said(name, pattern)) for name, pattern in (
        ("CITATION.cff", r"^version: (.+)$"), ("CHANGELOG.md", r"^## (\d.+)$"),
        ("Documentation/Install.md", r"libvtkseismichorizons(\d[\d.]*)"),
        ("Documentation/Example/CMakeLists.txt", r"\(SeismicHorizons (\S+)"),
        ("Testing/Install/Consumer/CMakeLists.txt", r"\(SeismicHorizons (\S+)"))]
    return ["%s: version %s, expected that of CMakeLists.txt, %s" % (name, version, own) for name, version in found
            if version not in (own, own.rpartition(".")[0])]


def main():
    tree = pathlib.Path(sys.argv[1])
    floors, rules = read_floors(tree / "Documentation" / "Architecture.md")
    folders = ["Common", "Filters", "Sources", "Readers", "Writers", "ParaViewPlugin", "Utilities", "Testing"]
    sources = sorted(path for folder in folders for path in (tree / folder).rglob("*")
                     if path.suffix in (".h", ".cxx") and "Consumer" not in path.parts)
    scripts = sorted(path for folder in folders for path in (tree / folder).rglob("*.py"))
    assert len(floors) > 8 and rules and len(sources) > 100 and len(scripts) > 10, (floors, rules, len(sources), len(scripts))
    wrong = ["the room %s is not there" % room for room in floors if not (tree / room.replace("/*", "")).is_dir()]
    wrong += check_versions(tree)
    classes = {path.name: path.parent.relative_to(tree).as_posix() for path in sources if path.name.startswith("vtk")}
    names = {path.name for pattern in ("*.h", "*.cxx", "*.md") for path in tree.rglob(pattern)}
    arrows = {}
    for path in sources:
        if path.relative_to(tree).parts[0] not in FREE:
            wrong += check_file(tree, path, floors, rules, classes, arrows) + check_comments(tree, path, names)
    wrong += check_cycles(arrows)
    compiled = [path for path in sources if path.relative_to(tree).parts[0] not in FREE]
    wrong += check_names(tree, compiled) + check_hidden(tree, [path for path in compiled if is_method(path.relative_to(tree))])
    for path in sources + scripts:
        wrong += check_length(tree, path) + check_functions(tree, path)
    print("\n".join(wrong) or "%d files on %d floors" % (len(sources), len(set(floors.values()))))
    sys.exit(1 if wrong else 0)


main()
