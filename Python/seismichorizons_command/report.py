# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A report of a run as a single self-contained HTML page, which needs no network and no other file.

    run = record.Record(print, True, report.make_album(with_pictures=True))
    batch.run([path], folder, settings, True, run)
    report.write(run.as_values(), pathlib.Path("report.html"), run.album)
"""

import os
import shlex

from . import sections
from .album import MESH_BYTES, Album
from .markup import Markup, as_json, data_uri, fill, join, read, script_hash, script_safe
from .progress import duration_text
from .core import HorizonError
from .colors import FAULT_COLOR, FAULT_COLOR_BY_DISTANCE, LOW_TO_HIGH, NEAR_TO_FAR, rgb
from .writing import require_writable, write_file


def make_album(with_pictures):
    """Makes the album of a report; pictures need an X server."""
    return Album(with_pictures)


def check(path):
    """Raises HorizonError if no report can be written."""
    require_writable(path)
    if not os.access(path.parent, os.W_OK):
        raise HorizonError("%s cannot be written: %s is not a writable folder" % (path, path.parent))


def write(run, path, album):
    """Writes the page of a run (Record.as_values) and its album; the file appears when it is complete. Raises HorizonError."""
    write_file(make(run, album).encode("utf-8"), path)


def make(run, album):
    """Returns the text of the page."""
    codes = [read("page.js")]
    viewer = _viewer(run, album)
    if "viewer-data" in viewer:
        codes.append(read("viewer.js"))
    codes = [script_safe(code) for code in codes]
    pairs = sections.horizons_of(run)
    labels = [file["label"] for file in run["files"]]
    heading = labels[0] if len(labels) == 1 else sections.count(len(labels), "file")
    page = fill(
        "page", hashes=join((Markup(script_hash("\n" + code + "\n")) for code in codes), " "),
        version=run["versions"]["SeismicHorizons"], title="%s: report" % heading, heading=heading,
        style=Markup(read("page.css") + _ramps()), when=_when(run, len(pairs)), tiles=sections.tiles(run),
        links=sections.links(bool(pairs), bool(viewer), any(file["layers"] for file in run["files"])),
        problems=sections.problems(run), files=sections.files(run),
        horizons=sections.horizon_table(run, album), layers=sections.layers(run, album), viewer=viewer,
        details=sections.details(run, album),
        parameters=sections.parameters(run), folder=run["command"]["folder"],
        command=shlex.join(run["command"]["words"]),
        versions=", ".join("%s %s" % (name, text) for name, text in run["versions"].items() if text),
        notes=Markup("@notes@"), scripts=join(fill("script", code=Markup("\n" + code + "\n")) for code in codes))
    note = fill("note", text="This page is a single file of %.1f MB and loads nothing from a network. Made by "
                "SeismicHorizons %s." % (len(page.encode("utf-8")) / 1e6, run["versions"]["SeismicHorizons"]))
    # The replaced text occurs only once, because all other content is escaped or base64.
    return page.replace("<footer>\n@notes@", "<footer>\n" + note, 1)


def _when(run, horizons):
    return "%s in %s, on %s UTC" % (sections.count(horizons, "horizon"), duration_text(run["seconds"]),
                                    run["started"][:16].replace("T", ", "))


def _ramps():
    """Returns the colours of heights, distances and closed faults as CSS backgrounds."""
    low = ["#%s" % color for color in LOW_TO_HIGH]
    near = ["#%s %g%%" % (color, 100.0 * place) for place, color in NEAR_TO_FAR]
    return (":root { --low-to-high: linear-gradient(90deg, %s); --near-to-far: linear-gradient(90deg, %s); "
            "--fault: #%s; --fault-by-error: #%s; }\n" % (
                ", ".join(low), ", ".join(near), FAULT_COLOR, FAULT_COLOR_BY_DISTANCE))


def _viewer(run, album):
    """Returns the section of the interactive meshes."""
    pairs = sections.horizons_of(run)
    having = [number for number, entry in enumerate(album.entries) if entry.mesh]
    if not pairs:
        return Markup()
    if not having:
        return fill("no_viewer", reason="No mesh is small enough for this page, which has "
                    "room for %d MB." % (MESH_BYTES >> 20) if any(h["triangles"] for _, h in pairs) else
                    "There is no mesh with triangles.")
    left_out = sum(1 for number, (_, h) in enumerate(pairs) if h["triangles"] and number not in having)
    note = "At full resolution, in world coordinates. " + (
        "%s omitted, as a report holds at most %d MB of meshes." % (
            "1 mesh is" if left_out == 1 else "%d meshes are" % left_out, MESH_BYTES >> 20) if left_out else "")
    by_error = any(album.entries[number].mesh.error_on for number in having)
    return fill("viewer", note=note, choices=join((_choices(run, having), _body_choices(run, album))),
                manifest=as_json(_manifest(run, album, having)),
                by_error=fill("by_error") if by_error else None,
                fault_color=fill("fault_color") if any(album.entries[n].mesh.fault_triangles for n in having) else None,
                meshes=join((fill("mesh", number=number, content=_base64(mesh.content)) for number, mesh in (
                    *((number, album.entries[number].mesh) for number in having), *_bodies(album).items())), "\n"))


def _bodies(album):
    """Returns the interactive bodies of layers by their IDs in the page."""
    return {"layer-%d-%d" % (place, number): mesh for place, entry in enumerate(album.layers)
            for number, mesh in enumerate(entry.bodies.values())}


def _body_choices(run, album):
    having = [file for file in run["files"] if file["layers"]]
    return join(fill("choices", label="Layers of %s" % file["label"], all=None, options=join(
        fill("choice", value="layer-%d-%d" % (place, number), text=name) for number, name in enumerate(entry.bodies)))
        for place, (file, entry) in enumerate(zip(having, album.layers)) if entry.bodies)


def _base64(content):
    return Markup(data_uri(content, "").partition(",")[2])


def _numbers_by_file(run, having):
    """Returns for each file the numbers of its horizons with an interactive mesh."""
    number, groups = 0, []
    for file in run["files"]:
        last = number + len(file["horizons"])
        groups.append([n for n in range(number, last) if n in having])
        number = last
    return groups


def _choices(run, having):
    names = [horizon["name"] for _, horizon in sections.horizons_of(run)]
    shown = []
    for place, (file, numbers) in enumerate(zip(run["files"], _numbers_by_file(run, having))):
        everything = fill("choice", value="file-%d" % place, text="All %d" % len(numbers)) if len(numbers) > 1 else None
        shown.append(fill("choices", label=file["label"], all=everything, options=join(
            fill("choice", value=number, text=names[number]) for number in numbers)) if numbers else Markup())
    return join(shown)


def _manifest(run, album, having):
    """Returns the description of the meshes for the script of the page."""
    pairs = sections.horizons_of(run)
    units = {h["distances"]["unit"] for _, h in pairs if h["distances"]}
    unit_of = {number: (pairs[number][0]["survey"] or {}).get("vertical_unit") for number in having}
    meshes = {number: {
        "center": mesh.center, "points": mesh.points, "triangles": mesh.triangles, "fault_triangles": mesh.fault_triangles,
        "error_on": mesh.error_on, "farthest": mesh.farthest, "unit": unit_of.get(number)} for number, mesh in (
            *((number, album.entries[number].mesh) for number in having), *_bodies(album).items())}
    return {"meshes": meshes, "files": [[str(n) for n in group] for group in _numbers_by_file(run, having)],
            "unit": "%s units" % next(iter(units), "lattice"),
            "low_to_high": [(n / (len(LOW_TO_HIGH) - 1), *rgb(color)) for n, color in enumerate(LOW_TO_HIGH)],
            "near_to_far": [(place, *rgb(color)) for place, color in NEAR_TO_FAR],
            "fault_colors": {"height": rgb(FAULT_COLOR), "error": rgb(FAULT_COLOR_BY_DISTANCE)}}
