# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Sentences and tables of the page that follow from the figures."""

from statistics import median

from text import table

from . import reported
from .study import OURS

MESHERS = {"BP": "ball pivoting"}


def ratio(value):
    return "%.0f" % value if value >= 20.0 else "%.2g" % value


def listing(parts):
    return parts[0] if len(parts) == 1 else ", ".join(parts[:-1]) + " and " + parts[-1]


class Against:
    """A method compared with ours at equal vertices: medians over its surfaces. Errors are multiplied by the number of
    vertices, because the error of a good mesh is inversely proportional to it; this corrects for small differences."""

    def __init__(self, partner, pairs):
        self.partner = partner
        self.vertices = median(p.worth.vertices / o.worth.vertices for p, o in pairs)
        self.largest = median(per_vertex(p, o, "largest") for p, o in pairs)
        self.mean = median(per_vertex(p, o, "mean") for p, o in pairs)
        self.outline = median(p.worth.outline for p, _ in pairs)
        self.our_outline = median(o.worth.outline for _, o in pairs)
        self.seconds = median(p.seconds / o.seconds for p, o in pairs)

    def row(self):
        return [self.partner, "%.2f" % self.vertices, ratio(self.mean), ratio(self.largest), "%.1f" % self.outline,
                ratio(self.seconds)]


def per_vertex(partner, ours, name):
    def product(measured):
        return getattr(measured.worth, name) * measured.worth.vertices

    return product(partner) / product(ours)


def partners(found, name):
    """Returns all compared methods in the order of the tables."""
    names = dict.fromkeys(partner for s in found for partner in s.equal[name] if partner != OURS)
    return [Against(partner, [(s.equal[name][partner], s.equal[name][OURS]) for s in found if partner in s.equal[name]])
            for partner in names]


def partner_table(found, name):
    ours = [s.equal[name][OURS] for s in found]
    own = [OURS, "1", "1", "1", "%.1f" % median(o.worth.outline for o in ours), "1"]
    heads = ["mesh", "vertices / ours", "mean error x vertices / ours", "largest error x vertices / ours",
             "outline, columns", "time / ours"]
    return table(heads, [own] + [against.row() for against in partners(found, name)])


def best_sentence(found, name):
    """Returns a sentence on the other method with the smallest error per vertex."""
    against = partners(found, name)
    mean, largest, nearest = (min(against, key=lambda a, what=what: getattr(a, what))
                              for what in ("mean", "largest", "outline"))
    return "of the other methods, **%s** has the smallest mean error (%s times ours), **%s** the smallest largest " \
        "error (%s times), and **%s** the nearest outline (%.1f columns off, ours %.1f)." % (
            mean.partner, ratio(mean.mean), largest.partner, ratio(largest.largest), nearest.partner, nearest.outline,
            nearest.our_outline)


class AgainstThesis:
    """Medians of here / thesis over (surface, thesis, here)."""

    def __init__(self, what, pairs):
        self.what = what
        self.left = median((here.points / s.points) / (points / s.size) for s, (points, *_), here in pairs)
        self.largest = median(here.worth.largest / thesis[2] for _, thesis, here in pairs)
        self.mean = median(here.worth.mean / thesis[3] for _, thesis, here in pairs)
        self.speed = median(thesis[1] / (1000.0 * here.seconds) for _, thesis, here in pairs)

    def row(self):
        return [self.what] + [ratio(value) for value in (self.left, self.largest, self.mean, self.speed)]


def thesis_comparisons(found):
    comparisons = [AgainstThesis("rough, s = %d" % size, [
        (s, reported.ROUGH[s.size][size], s.rough[size]) for s in found]) for size in (3, 6, 8)]
    for name, title in (("alone", "alone"), ("after", "after rough with s = 3")):
        for n, flatness in enumerate(reported.FLATNESS):
            pairs = []
            for s in found:
                points, alone, after, largest, mean = reported.ELABORATE[s.size][n]
                pairs.append((s, (points, alone if name == "alone" else after, largest, mean), getattr(s, name)[n]))
            comparisons.append(AgainstThesis("elaborate, s = 8, flatness %.2f, %s" % (flatness, title), pairs))
    for size in (3, 6, 8):
        comparisons.append(AgainstThesis("elaborate, s = 10, after rough with s = %d" % size, [
            (s, reported.GLOBAL[size][s.size][n], s.both[size][n]) for s in found for n in range(3)]))
    return comparisons


def thesis_table(found):
    return table(["here / thesis", "points left", "largest error", "mean error", "speed"],
                 [c.row() for c in thesis_comparisons(found)])


def thesis_sentence(found):
    """Returns a sentence with the range of that table."""
    comparisons = thesis_comparisons(found)
    spans = []
    for name in ("left", "largest", "mean", "speed"):
        values = [getattr(c, name) for c in comparisons]
        spans.append("%s to %s" % (ratio(min(values)), ratio(max(values))))
    return "Ratios here / thesis, medians by method ([table](#what-is-different-from-the-thesis)): points left %s, " \
        "largest error %s, mean error %s, speed %s." % tuple(spans)


def outline_sentence(found):
    """Returns a sentence on a result of the thesis to which nothing was fitted."""
    s = found[0]
    return "The outline of the surface of %d points then has %d points, in figure 3.23 %d." % (
        s.size, s.outline, reported.OUTLINE[s.size])


def contradiction_sentence():
    """Returns a sentence on a contradiction: a cell of 6 with b boundary points keeps at most b + 3 points as four cells of
    3, and any other cell at most 4 instead of 1, so never more than four times as many."""
    sizes = ["%d" % size for size, rough in sorted(reported.ROUGH.items()) if rough[3][0] > 4 * rough[6][0]]
    return "No surface can fit all three values of s. A cell of 6 is four cells of 3, so s = 3 leaves at most four " \
        "times as many points as s = 6. In the thesis, it leaves more on the surfaces of %s points." % listing(sizes)


def cluster_sentence(found):
    """Returns a sentence on how close MeshLab's results are here and in the thesis, which shows the effect of surfaces and
    machine."""
    pairs = [(s, reported.CLUSTER[s.size][size], s.cluster[size]) for s in found for size in s.cluster]
    if not pairs:
        return "MeshLab was not run."
    c = AgainstThesis("", pairs)
    return "The same ratios for MeshLab's merging, with one program there and here: points left %s, largest error %s, " \
        "mean error %s, speed %s." % (ratio(c.left), ratio(c.largest), ratio(c.mean), ratio(c.speed))


def left_out(pace):
    if not pace.left_out:
        return "None was left out.\n"
    parts = ["%s on %s points" % (MESHERS.get(name, name), listing(["%d" % n for n in sorted(sizes)]))
             for name, sizes in pace.left_out.items()]
    return "Left out because a run was expected to need more than %g s: %s.\n" % (pace.most_seconds, "; ".join(parts))
