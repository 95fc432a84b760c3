# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of cells of layers with groups of faces, read by the pages of Gmsh and Abaqus."""

import collections

import numpy as np

# Corners of the faces of elements, outwards.
GMSH = {6: ((0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (0, 3, 5, 2), (1, 2, 5, 4)),
        5: ((0, 3, 2, 1), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)), 4: ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3))}
ABAQUS = {"C3D6": ((1, 2, 3), (4, 5, 6), (1, 2, 5, 4), (2, 3, 6, 5), (3, 1, 4, 6)),
          "C3D4": ((1, 2, 3), (1, 4, 2), (2, 4, 3), (3, 4, 1))}


def read_msh(path):
    """Points by number, physical names, entities with their physical group and surfaces, and elements of each entity."""
    lines = iter(path.read_text(encoding="utf-8").splitlines())
    names, entities, points, elements = {}, {}, {}, collections.defaultdict(list)
    for line in lines:
        if line == "$PhysicalNames":
            for _ in range(int(next(lines))):
                dimension, tag, name = next(lines).split(" ", 2)
                names[int(dimension), int(tag)] = name[1:-1]
        elif line == "$Entities":
            counts = [int(word) for word in next(lines).split()]
            for dimension, count in enumerate(counts):
                for _ in range(count):
                    tag, *words = next(lines).split()
                    numbers = [int(word) for word in words[6:]]
                    assert numbers[0] == 1 and numbers[2] == len(numbers) - 3, numbers
                    entities[dimension, int(tag)] = names[dimension, numbers[1]], numbers[3:]
        elif line == "$Nodes":
            for _ in range(int(next(lines).split()[0])):
                count = int(next(lines).split()[3])
                tags = [int(next(lines)) for _ in range(count)]
                points.update((tag, [float(word) for word in next(lines).split()]) for tag in tags)
        elif line == "$Elements":
            blocks, total, _, last = (int(word) for word in next(lines).split())
            seen = set()
            for _ in range(blocks):
                dimension, tag, kind, count = (int(word) for word in next(lines).split())
                for _ in range(count):
                    number, *corners = (int(word) for word in next(lines).split())
                    assert len(corners) == {2: 3, 3: 4, 4: 4, 6: 6, 7: 5}[kind]
                    elements[dimension, tag].append(corners)
                    seen.add(number)
            assert len(seen) == total == last
    return np.array([points[n] for n in range(1, len(points) + 1)]), entities, elements


def read_inp(path):
    """Faces of surfaces by name, as sets of nodes, by the numbers of Abaqus."""
    elements, surfaces, mode = {}, {}, None
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.startswith("*"):
            words = dict(word.strip().split("=") for word in line.split(",")[1:])
            mode = line.split(",")[0], words.get("TYPE"), words.get("NAME")
        elif mode[0] == "*ELEMENT":
            number, *corners = (int(word) for word in line.split(","))
            elements[number] = mode[1], corners
        elif mode[0] == "*SURFACE":
            assert mode[1] == "ELEMENT"
            number, face = line.split(", S")
            kind, corners = elements[int(number)]
            surfaces.setdefault(mode[2], []).append(frozenset(corners[n - 1] for n in ABAQUS[kind][int(face) - 1]))
    return surfaces


def areas_of(points, faces):
    """Vectors: outwards, as long as the area."""
    total = np.zeros((len(faces), 3))
    for row, face in enumerate(faces):
        corners = points[np.array(face) - 1]
        for n in range(1, len(face) - 1):
            total[row] += np.cross(corners[n] - corners[0], corners[n + 1] - corners[0]) / 2.0
    return total


def volume_of(points, cell):
    """By tetrahedra to the first corner."""
    own = points[np.array(cell) - 1] - points[cell[0] - 1]
    return sum(np.linalg.det(own[[face[0], face[n], face[n + 1]]]) for face in GMSH[len(cell)] for n in range(1, len(face) - 1)) / 6.0
