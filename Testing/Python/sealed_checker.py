# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks sealed structural models, closed bodies between triangles of horizons, faults and walls, from their files alone.

  sealed_checker.py FILE...       a line per model, also of those in folders, with problems and places, which make the exit code 1
  sealed_checker.py --self FILE   models made from the file that are broken on purpose have to be reported

Files: "sealed 1"; "box x0 y0 z0 x1 y1 z1"; perhaps "outline N" with N corners "x y" of walls, clockwise; "surfaces N" with N lines "type name" (0 horizon, 1 fault, 2 wall, 3 top or base);
"bodies N", "layer block volume"; "vertices N", "x y z"; "triangles N", "a b c surface before behind", bodies on both sides, -1
outside; perhaps "guessed K", of faults without a known throw; perhaps "truth N", volumes by layer.

Signs are exact: of doubles with a bound of their error and, in doubt, of whole numbers and fractions. The first file and every
tenth after it are also given to TetGen, Gmsh and OpenGeode if Python has them.
"""

import collections
import copy
import functools
import importlib.util
import math
import pathlib
import subprocess
import sys
import tempfile
import types
from fractions import Fraction

import numpy as np
from sealed_programs import TOOLS

HORIZON, FAULT, WALL, END = range(4)
ONE_TRIANGLE, OTHER_BODY, NOT_IN_FILE = "an edge of one triangle", "bodies that differ at an edge", "a volume that is not in the file"


def read(path):
    """A model; an error for a file of another form."""
    lines, parts = iter(pathlib.Path(path).read_text(encoding="utf-8").splitlines()), {"guessed": ["0"], "truth": []}
    for line in lines:
        word, *values = line.split()
        parts[word] = [next(lines).split() for _ in range(int(values[0]))] if word not in ("sealed", "box", "guessed") else values
    kinds, names = zip(*parts["surfaces"])
    layers, _, volumes = np.array(parts["bodies"], float).T
    triangles = np.array(parts["triangles"], int)
    m = types.SimpleNamespace(
        box=np.array(parts["box"], float).reshape(2, 3), names=names, types=np.array(kinds, int), layer=layers.astype(int), volume=volumes,
        V=np.array(parts["vertices"], float), T=triangles[:, :3], S=triangles[:, 3], sides=triangles[:, 4:],  # before and behind
        outline=np.array(parts["outline"], float) if "outline" in parts else None, guessed=int(parts["guessed"][0]), truth=np.array(parts["truth"], float).ravel())
    ranges = ((m.T, len(m.V)), (m.S, len(names)), (m.sides + 1, len(layers) + 1), (m.types, 4), (m.layer, len(m.truth) or 10000))
    good = parts["sealed"] == ["1"] and m.sides.shape[1] == 2 and np.isfinite(m.V).all() and (m.box[1] > m.box[0]).all()
    if not (good and all(((0 <= numbers) & (numbers < count)).all() for numbers, count in ranges)):
        raise ValueError("another version, or a number out of its range")
    return m


def walls_of(m):
    """Corners of the walls, clockwise, and the way to the next one."""
    (x0, y0, _), (x1, y1, _) = m.box
    corners = m.outline if m.outline is not None else np.array([(x0, y0), (x0, y1), (x1, y1), (x1, y0)])
    return corners, np.roll(corners, -1, 0) - corners


def volume_of_walls(m):
    corners, ways = walls_of(m)
    a = corners - m.box[0, :2]
    return math.fsum(a[:, 1] * ways[:, 0] - a[:, 0] * ways[:, 1]) / 2 * float(m.box[1, 2] - m.box[0, 2])


def add(problems, kind, place, words):
    """Adds a place to those of problems of a kind."""
    problems[kind].append("at (%.10g %.10g %.10g): %s" % (*place, words))


def joined(count, links):
    """What links join: for each of a count of things the least that it is joined with."""
    least, links = np.arange(count), np.array(links, int).reshape(-1, 2)
    while (least[links[:, 0]] != least[links[:, 1]]).any():
        np.minimum.at(least, least[links].ravel(), np.repeat(least[links].min(1), 2))
        least = least[least]
    return least


def cross(p, q):
    """Cross products; numpy 1.24 has none of single vectors of objects."""
    return p[..., [1, 2, 0]] * q[..., [2, 0, 1]] - p[..., [2, 0, 1]] * q[..., [1, 2, 0]]


def whole_numbers(vertices):
    """The vertices as Python's whole numbers of a unit, in an array of objects, and how many units are one."""
    ratios = [x.as_integer_ratio() for x in vertices.ravel().tolist()]
    units = max(below for _, below in ratios)
    return np.array([above * (units // below) for above, below in ratios], object).reshape(-1, 3), units


def sort_around(whole, start, end, fan):
    """Triangles at an edge as they follow each other around it, counterclockwise against its direction."""
    arms = whole[[third for third, *_ in fan]] - whole[start]
    normals = cross(whole[end] - whole[start], arms)
    turns = np.sign(normals @ arms.T)  # 1: from the one to the other it is less than half a turn
    halves = [{1: 1, -1: 3}.get(turn, 0 if ahead > 0 else 2) for turn, ahead in zip(turns[0], normals @ normals[0])]
    order = functools.cmp_to_key(lambda i, j: halves[i] - halves[j] or -turns[i, j])
    return [fan[k] for k in sorted(range(len(fan)), key=order)]


def common_part(one, other):
    """The corners of what two triangles have in common: the other is cut by the plane and the edges of the one."""
    normal, part = cross(one[1] - one[0], one[2] - one[0]), [tuple(p) for p in other]
    for way, foot in [(normal, one[0]), (-normal, one[0])] + [(cross(normal, one[k - 2] - one[k]), one[k]) for k in range(3)]:
        heights, cut = [(np.array(p, object) - foot) @ way for p in part], []
        for p, q, here, there in zip(part, part[1:] + part[:1], heights, heights[1:] + heights[:1]):
            cut += [p] if here >= 0 else []
            cut += [tuple(a + Fraction(here, here - there) * (b - a) for a, b in zip(p, q))] if here * there < 0 else []
        part = list(dict.fromkeys(cut))
    return part


def check_edges(m, whole, problems):
    """Returns the pairs of sides, 2 t before a triangle t and 2 t + 1 behind it, of one body that face each other at an edge."""
    fans, body, links = collections.defaultdict(list), m.sides.ravel().tolist(), []
    for t, corners in enumerate(m.T.tolist()):
        for k in range(3):
            a, b = corners[k], corners[k - 2]
            fans[min(a, b), max(a, b)].append((corners[k - 1], t, a < b))
    for (start, end), fan in fans.items():
        middle = (m.V[start] + m.V[end]) / 2
        only = fan[0][1]
        if len(fan) == 1 and not (m.types[m.S[only]] == FAULT and body[2 * only] == body[2 * only + 1] != -1):  # unless a fault dies out in a body
            add(problems, ONE_TRIANGLE, middle, m.names[m.S[only]])
            continue
        fan = sort_around(whole, start, end, fan) if len(fan) > 2 else fan
        for (_, t, forward), (_, u, other) in zip(fan, fan[1:] + fan[:1]):
            here, there = 2 * t + (not forward), 2 * u + other
            if body[here] == body[there]:
                links.append((here, there))
            else:
                add(problems, OTHER_BODY, middle, "%d of %s, %d of %s" % (body[here], m.names[m.S[t]], body[there], m.names[m.S[u]]))
    return links


def pairs_of_boxes(low, high, block=256):
    """Pairs of boxes that meet, in blocks."""
    order = np.argsort(low[:, 0])
    low, high = low[order], high[order]
    for first in range(0, len(order), block):
        last = np.searchsorted(low[:, 0], high[first:first + block, 0].max(), side="right")
        i, j = np.nonzero(((low[first:first + block, None] <= high[None, first:last]) &
                           (high[first:first + block, None] >= low[None, first:last])).all(2))
        yield order[first + i[i < j]], order[first + j[i < j]]


def side_of(V, P, v, axis):
    """On which side of triangles' planes vertices lie; with an axis, of their first edges in a view along it; in doubt, no number."""
    B, C, D = V[P[:, 1]] - V[P[:, 0]], V[P[:, 2]] - V[P[:, 0]], V[v] - V[P[:, 0]]
    if axis is None:
        left, right = B[:, [1, 2, 0]] * C[:, [2, 0, 1]], B[:, [2, 0, 1]] * C[:, [1, 2, 0]]
        value, size = ((left - right) * D).sum(1), ((np.abs(left) + np.abs(right)) * np.abs(D)).sum(1)
    else:
        left, right = B[:, axis - 2] * D[:, axis - 1], B[:, axis - 1] * D[:, axis - 2]
        value, size = left - right, np.abs(left) + np.abs(right)
    return np.where(np.abs(value) > 1e-15 * size + 1e-200, np.sign(value), np.nan)  # above Shewchuk's bounds, and underflow


def surely_apart(V, A, B):
    """Whether pairs of triangles surely have nothing in common but common corners and the edge between two of these: whether the
    plane of one, or a plane through an edge of it along an axis, has all other corners of the other on a side without its own.
    """
    apart = np.zeros(len(A), bool)
    for axis, edge, swapped in [(None, 0, 0), (None, 0, 1)] + [(a, e, s) for a in (2, 0, 1) for e in range(3) for s in (0, 1)]:
        left = np.flatnonzero(~apart)
        P, Q = (B[left], A[left]) if swapped else (A[left], B[left])
        P = np.roll(P, -edge, 1)
        common = (Q[:, :, None] == P[:, None, :]).any(2)
        sides = np.stack([side_of(V, P, v, axis) for v in Q.T], 1)
        side = ((sides > 0) | common).all(1) * 1 - ((sides < 0) | common).all(1)
        own = 0 if axis is None else np.where((Q == P[:, 2:]).any(1), np.nan, side_of(V, P, P[:, 2], axis))
        apart[left] = (side != 0) & (own * side <= 0)
    return apart


def check_pairs(m, whole, units, problems):
    """No two triangles have anything in common but common corners and edges."""
    corners = m.V[m.T]
    for i, j in pairs_of_boxes(corners.min(1), corners.max(1)):
        unsure = ~surely_apart(m.V, m.T[i], m.T[j])
        for t, u in zip(i[unsure].tolist(), j[unsure].tolist()):
            part, common = common_part(whole[m.T[t]], whole[m.T[u]]), [tuple(whole[v]) for v in m.T[t] if v in m.T[u]]
            more = [p for p in part if p not in common]
            if more or len(common) == 3:
                kind = "touch" if len(part) == 1 else "pierce or touch along a line" if len(part) == 2 else "overlap" if more else "coincide"
                add(problems, "triangles that " + kind, [float(Fraction(sum(x), units * len(part))) for x in zip(*part)],
                    "%d of %s, %d of %s" % (t, m.names[m.S[t]], u, m.names[m.S[u]]))


def turns_around(m, place, sides):
    """How often sides, as of check_edges, go around a place: the sum of their solid angles."""
    a, b, c = np.moveaxis(m.V[m.T[sides // 2]] - place, 1, 0)
    x, y, z = (np.linalg.norm(v, axis=1) for v in (a, b, c))
    flat = x * y * z + (a * b).sum(1) * z + (b * c).sum(1) * x + (c * a).sum(1) * y
    return (np.where(sides % 2, 2, -2) * np.arctan2((a * cross(b, c)).sum(1), flat)).sum() / (4 * math.pi)


def check_bodies(m, links, problems):
    """Returns the volumes of the bodies: positive, those of the file, and in sum that of the box; each body is one piece."""
    middle, box, bodies = m.box.mean(0), volume_of_walls(m), m.sides.ravel()
    a, b, c = np.moveaxis(m.V[m.T] - middle, 1, 0)
    parts = np.outer((a * cross(b, c)).sum(1) / 6, (-1, 1)).ravel()  # by side
    volumes = np.array([math.fsum(parts[bodies == body]) for body in range(len(m.layer))])
    for words, all_of in (("bodies", volumes), ("the file", m.volume)):
        if not abs(math.fsum(all_of) / box - 1) <= 1e-12:
            add(problems, "a box that is not filled", middle, "%+.3g of it by %s" % (math.fsum(all_of) / box - 1, words))
    shells = joined(len(bodies), links)
    for body, volume in enumerate(volumes):
        sides = np.flatnonzero(bodies == body)
        place = m.V[m.T[sides // 2]].mean((0, 1)) if len(sides) else middle
        if not volume > 0:
            add(problems, "a volume that is not positive", place, "%.6g of body %d" % (volume, body))
        if not abs(volume - m.volume[body]) <= 1e-9 * box:
            add(problems, NOT_IN_FILE, place, "%.12g of body %d, which has %.12g there" % (volume, body, m.volume[body]))
        own = {shell: math.fsum(parts[shells == shell]) for shell in np.unique(shells[sides]).tolist()}
        for shell in sorted(own, key=own.get)[:-1]:  # all but the outer one are around holes in what the others bound
            place = m.V[m.T[shell // 2, 0]]
            if own[shell] > 0 or round(turns_around(m, place, sides[shells[sides] != shell])) != 1:
                add(problems, "a body in pieces", place, "body %d, one of a volume of %.6g" % (body, own[shell]))
    return volumes


def check_surfaces(m, problems):
    """Horizon i has layer i before it and i + 1 behind it; walls, top and base have the outside on one side and lie in the box."""
    kinds, layers, corners = m.types[m.S], np.append(m.layer, -1)[m.sides], m.V[m.T]
    numbers, tolerance = (np.cumsum(m.types == HORIZON) - 1)[m.S], 1e-9 * np.linalg.norm(m.box[1] - m.box[0])
    ends = (np.abs(corners[:, :, None, 2] - m.box[:, 2]) <= tolerance).all(1).any(1)
    firsts, ways = walls_of(m)
    to = corners[:, :, None, :2] - firsts  # by triangle, corner, wall
    long, parts = np.linalg.norm(ways, axis=1), (to * ways).sum(-1) / (ways ** 2).sum(1)
    on = (np.abs(to[..., 0] * ways[:, 1] - to[..., 1] * ways[:, 0]) <= tolerance * long) & (np.abs(parts - 0.5) <= 0.5 + tolerance / long)
    crossed = (to[..., 1] < 0) != (to[..., 1] < ways[:, 1])
    with np.errstate(divide="ignore", invalid="ignore"):
        crossed &= to[..., 0] < ways[:, 0] * to[..., 1] / ways[:, 1]
    out = (crossed.sum(-1) % 2 == 0) & ~on.any(-1) | (corners[..., 2] < m.box[0, 2] - tolerance) | (corners[..., 2] > m.box[1, 2] + tolerance)
    for kind, wrong in {
            "a horizon between wrong layers": (kinds == HORIZON) & (layers != np.stack([numbers, numbers + 1], 1)).any(1),
            "one body on both sides": (m.sides[:, 0] == m.sides[:, 1]) & (kinds != FAULT),
            "the outside at a wrong surface": (m.sides == -1).sum(1) != (kinds >= WALL),
            "a wall that is not in the box": (kinds == WALL) & ~on.all(1).any(1) | (kinds == END) & ~ends,
            "a triangle out of the box": out.any(1)}.items():
        for t in np.flatnonzero(wrong).tolist():
            add(problems, kind, corners[t].mean(0), "%s between layers %d and %d" % (m.names[m.S[t]], *layers[t]))


def check(m):
    """The problems of a model, and how many percent the volumes of its layers are off the truth."""
    problems, (whole, units) = collections.defaultdict(list), whole_numbers(m.V)
    normals = cross(whole[m.T[:, 1]] - whole[m.T[:, 0]], whole[m.T[:, 2]] - whole[m.T[:, 0]])
    for t in np.flatnonzero((normals == 0).all(1)).tolist():
        add(problems, "a triangle without an area", m.V[m.T[t, 0]], "%d of %s" % (t, m.names[m.S[t]]))
    links = check_edges(m, whole, problems)
    check_pairs(m, whole, units, problems)
    layers = np.bincount(m.layer, check_bodies(m, links, problems), len(m.truth))
    check_surfaces(m, problems)
    off = 100 * np.abs(layers / m.truth - 1).max() if len(m.truth) else math.nan
    if m.guessed == 0 and len(m.truth) and not off <= 1:
        add(problems, "volumes of layers off the truth", m.box.mean(0), "by %.3g %%" % off)
    return problems, off


def run_tool(name, path):
    """What another program, in a process of its own, has against a model. It may crash, hang and write files."""
    command = [sys.executable, pathlib.Path(__file__).resolve(), "--tool", name, pathlib.Path(path).resolve()]
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=300, check=False)
    told = [line for line in done.stdout.splitlines() if line.startswith("TOLD")]
    return told[0][5:] if told else "failed with code %d: %s" % (done.returncode, done.stdout[-300:].strip())


def broken(m):
    """Models broken on purpose, each with its name and what has to be reported."""
    kinds = [set(m.types[m.S[(m.T == v).any(1)]].tolist()) for v in range(len(m.V))]
    cut, inner = kinds.index({HORIZON, FAULT}), min(range(len(kinds)), key=lambda v: (FAULT in kinds[v], HORIZON not in kinds[v], len(kinds[v])))
    torn = copy.deepcopy(m)
    torn.V = np.vstack([m.V, m.V[cut] + 1e-4 * (m.box[1] - m.box[0])])
    torn.T[(m.T == cut) & (m.types[m.S] == HORIZON)[:, None]] = len(m.V)
    yield "a vertex torn in one sheet", torn, ONE_TRIANGLE
    pulled, faults = copy.deepcopy(m), m.V[m.T[m.types[m.S] == FAULT]].mean(1)
    pulled.V[inner] += 1.2 * (faults[np.linalg.norm(faults - m.V[inner], axis=1).argmin()] - m.V[inner])
    yield "a vertex pulled through another sheet", pulled, "triangles that pierce or touch along a line"
    for at in range(0, len(m.T), max(1, len(m.T) // 5)):
        one = copy.deepcopy(m)
        one.T, one.S, one.sides = (np.delete(part, at, 0) for part in (m.T, m.S, m.sides))
        yield "triangle %d removed" % at, one, ONE_TRIANGLE
    exchanged, turned, twice = (copy.deepcopy(m) for _ in range(3))
    exchanged.sides = np.append(np.r_[1, 0, 2:len(m.layer)], -1)[m.sides]
    yield "two bodies' numbers exchanged", exchanged, NOT_IN_FILE
    turned.T[0] = m.T[0, ::-1]
    yield "a triangle turned round", turned, OTHER_BODY
    twice.T, twice.S, twice.sides = (np.concatenate([part, part[:1]]) for part in (m.T, m.S, m.sides))
    yield "a triangle twice", twice, "triangles that coincide"


def check_itself(path):
    """Whether the model has no problems, and the broken ones have theirs."""
    m = read(path)
    failures = ["the model itself: %s" % ", ".join(kinds) for kinds in [check(m)[0]] if kinds]
    for name, one, kind in broken(m):
        found = check(one)[0]
        print("%s: %s" % (name, ", ".join("%s (%d)" % (words, len(places)) for words, places in found.items()) or "nothing"))
        failures += [] if kind in found else ["%s: without \"%s\"" % (name, kind)]
    print("\n".join(failures) or "all are reported")
    return 1 if failures else 0


def main():
    if sys.argv[1] == "--tool":
        print("\nTOLD %.600s" % " ".join(TOOLS[sys.argv[2]][0](read(sys.argv[3])).split()), flush=True)
        return 0
    if sys.argv[1] == "--self":
        return check_itself(sys.argv[2])
    tools = [name for name, (_, modules) in TOOLS.items() if all(map(importlib.util.find_spec, modules))]
    print("".join("skipped: %s, which needs the modules %s\n" % (name, ", ".join(TOOLS[name][1])) for name in TOOLS if name not in tools), end="")
    wrong = 0
    files = [file for given in sys.argv[1:] for file in (sorted(pathlib.Path(given).glob("*.txt")) if pathlib.Path(given).is_dir() else [given])]
    for number, path in enumerate(map(str, files)):
        try:
            m = read(path)
        except (KeyError, IndexError, RuntimeError, StopIteration, TypeError, ValueError, OSError) as error:
            print("%s: no sealed model: %r" % (path, error))
            wrong += 1
            continue
        problems, off = check(m)
        asked = tools if number % 10 == 0 else []
        if (m.sides[:, 0] == m.sides[:, 1]).any():  # OpenGeode takes faults that die out from .ml (sealed_test.py), not from .msh
            asked = [name for name in asked if name != "OpenGeode"]
        for name, words in [(name, run_tool(name, path)) for name in asked]:
            if words:
                add(problems, "a model that %s refuses" % name, m.box.mean(0), words)
        wrong += bool(problems)
        print("%s: %s; %d bodies, %d triangles, layers %.3f %% off%s" % (
            path, "problems" if problems else "sealed", len(m.layer), len(m.T), off, "".join(", " + name for name in asked)), flush=True)
        for kind, places in problems.items():
            print("  %s, %d times, %s" % (kind, len(places), places[0]))
    return 1 if wrong or not files else 0


if __name__ == "__main__":
    sys.exit(main())
