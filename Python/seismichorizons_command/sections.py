# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The sections of a report, from the values of a run (see figures.py)."""

from . import album as albums
from . import heights, ledger
from .charts import histogram
from .markup import Markup, data_uri, fill, join
from .progress import amount_text

# This column appears only if a mesh has fault triangles.
FAULT_COLUMN = ("Fault triangles", "that close faults, and that nothing else counts", lambda h: h["fault_triangles"], "{:,}")
# The columns of the table: title, explanation, value of a horizon (None if it has none), format.
COLUMNS = (
    ("Points in", "points that were read", lambda h: h["points_in"], "{:,}"),
    ("Points out", "points of the mesh", lambda h: h["points_out"], "{:,}"),
    ("Patches", "connected parts", lambda h: h["patches"], "{:,}"),
    ("Triangles", "of the mesh", lambda h: h["triangles"], "{:,}"),
    FAULT_COLUMN,
    ("Vertical error", "the largest, of points under the mesh, in vertical indices or the unit beside it",
     lambda h: _vertical(h, "largest"), "{:.3f}"),
    ("Outside", "points outside the outlines of the mesh", lambda h: h["points_outside"], "{:,}"),
    ("Bridged", "columns without a point that the mesh covers", lambda h: _columns(h, "bridged"), "{:,}"),
    ("Left out", "columns with a point that the mesh does not cover", lambda h: _columns(h, "left_out"), "{:,}"),
    ("Hausdorff distance", "no place is farther in space, both ways, in lattice units", lambda h: _error(h, "largest"),
     "{:.3f}"),
    ("Mean distance", "in space, both ways, in lattice units", lambda h: _error(h, "mean"), "{:.3f}"),
    ("Smallest angle", "of a triangle, as seen from above, in degrees", lambda h: h["angles"] and h["angles"]["smallest"],
     "{:.1f}\u00b0"),
    ("Time", "of all stages, in seconds", lambda h: h["seconds"]["total"], "{:.2f} s"))
LAYER_COLUMNS = (
    ("Volume", "to the outermost columns", lambda own: own["volume"], "{:.6g}"),
    ("Area", "seen from above", lambda own: own["area"], "{:.6g}"),
    ("Smallest thickness", "vertical", lambda own: own["thickness_least"], "{:.4g}"),
    ("Mean thickness", "vertical", lambda own: own["thickness_mean"], "{:.4g}"),
    ("Largest thickness", "vertical", lambda own: own["thickness_largest"], "{:.4g}"),
    ("Crossings", "columns where its horizons cross", lambda own: own["crossings"], "{:,}"),
    ("Deepest crossing", "of these", lambda own: own["deepest_crossing"], "{:.4g}"),
    ("Volume at faults", "of the strip between both sides of faults, which layers leave out",
     lambda own: own["volume_at_faults"], "{:.4g}"),
    ("Volume left out", "where horizons have no points", lambda own: own["volume_without"], "{:.4g}"),
    ("Volume not known", "in columns that are filled, bridged or extrapolated", lambda own: sum(
        own["volume_" + name] for name in ("filled", "bridged", "extrapolated")), "{:.4g}"))
ERROR_ROWS = (("Hausdorff distance, at most", "largest"), ("largest found", "largest_found"), ("mean", "mean"),
              ("root mean square", "rms"), ("median", "median"), ("90th percentile", "percentile_90"),
              ("95th percentile", "percentile_95"), ("99th percentile", "percentile_99"), ("outlines, on the map", "outline"))
STAGE_NAMES = {"despiked": "despiking", "torn": "faults", "filled": "hole filling", "simplified": "outline"}
PREPARED = {"despiked": "removed spikes", "torn": "faulted links", "filled": "filled points"}
MOST_OPEN_FILES = 3
METER = "vtkHorizonSurfaceDistance"
FROM_HERE_FILTERED = 15  # smallest number of rows with a search field


def _vertical(horizon, name):
    return horizon["vertical_error"] and _in_unit(horizon, horizon["vertical_error"][name])


def _in_unit(horizon, height):
    """Converts a height in vertical indices to the unit of reported errors."""
    reported = horizon["told_in"]
    return height if height is None else heights.Height.of(height * reported["per_index"], reported["unit"] or "")


def _with_unit(text, height):
    return " ".join(filter(None, (text, getattr(height, "unit", ""))))


def _columns(horizon, entry):
    return horizon["ledger"] and horizon["ledger"]["columns"][entry]


def _error(horizon, name):
    return horizon["error"] and horizon["error"]["lattice"][name]


def count(number, noun):
    return "{:,} {}{}".format(number, noun, "" if number == 1 else "s")


def horizons_of(run):
    """Returns all horizons in order, as (file, horizon)."""
    return [(file, horizon) for file in run["files"] for horizon in file["horizons"]]


def tiles(run):
    horizons = [horizon for _, horizon in horizons_of(run)]
    before, after = (sum(h[name] for h in horizons) for name in ("points_in", "points_out"))
    shown = [("Horizons", "{:,}".format(len(horizons))), ("Points in", "{:,}".format(before)),
             ("Points out", "{:,}".format(after)),
             ("Reduction", "%.1f %%" % (100.0 * (before - after) / before) if before else "-"),
             ("Triangles", "{:,}".format(sum(h["triangles"] for h in horizons)))]
    closing = sum(h["fault_triangles"] for h in horizons)
    if closing:
        shown.append((FAULT_COLUMN[0], "{:,}".format(closing)))
    for name, value_of in (("Vertical error", _vertical), ("Hausdorff distance", _error)):
        known = [value_of(horizon, "largest") for horizon in horizons if value_of(horizon, "largest") is not None]
        if known:
            shown.append((name, _with_unit("%.3f" % max(known), max(known))))
    return join(fill("tile", name=name, value=value) for name, value in shown)


def links(has_horizons, has_meshes, has_layers):
    """Returns links to the sections of the report."""
    shown = [("files", "Input", True), ("horizons", "Horizons", has_horizons), ("layers", "Layers", has_layers),
             ("meshes", "Meshes", has_meshes),
             ("details", "Horizon by horizon", has_horizons), ("parameters", "Parameters", True),
             ("again", "Repeat this run", True)]
    return join(fill("link", id=place, text=text) for place, text, is_there in shown if is_there)


def problems(run):
    """Returns errors and warnings; empty if there are none."""
    found = [("error", "Failed.", run["error"])] if run["error"] else []
    for file in run["files"]:
        if file["error"]:
            found.append(("error", "Failed." if file["status"] != "done" else "Error.", file["error"]))
        found += [("warning", "Warning.", text) for text in file["warnings"]]
    if not found:
        return Markup()
    return fill("problems", problems=join(fill("problem", kind=kind, word=word, text=text) for kind, word, text in found))


def facts(pairs):
    """Returns names and values; pairs without a value are omitted."""
    return join(fill("fact", name=name, value=value) for name, value in pairs if value not in (None, ""))


def files(run):
    """Returns a card for each file, expanded if there are few."""
    is_open = fill("open") if len(run["files"]) <= MOST_OPEN_FILES else None
    return join(_file_card(file, is_open) for file in run["files"])


def _file_card(file, is_open):
    words = [file["format"], None if file["bytes"] is None else amount_text(file["bytes"], "B"),
             count(len(file["horizons"]), "horizon") if file["status"] == "done" else "failed"]
    return fill("file", label=file["label"], open=is_open, short=", ".join(filter(None, words)), facts=facts([
        ("File", file["path"]), ("Size", None if file["bytes"] is None else _bytes(file["bytes"])),
        ("Format", file["format"]),
        ("Interpreted as", fill("lines", lines="\n".join(file["description"])) if file["description"] else None),
        ("Horizons", _horizons_read(file)), *_survey(file["survey"] or {}),
        ("Time to read", None if file["seconds_reading"] is None else "%.2f s" % file["seconds_reading"]),
        ("Results", ", ".join(file["results"][:8]) + (
            " and %d more" % (len(file["results"]) - 8) if len(file["results"]) > 8 else ""))]))


def _bytes(size):
    return "{:,} bytes".format(size) + (" (%s)" % amount_text(size, "B") if size >= 1e6 else "")


def _horizons_read(file):
    done, known = len(file["horizons"]), file["horizons_in_file"]
    return None if known is None else "%d" % done if done == known else "%d of %d" % (done, known)


def _survey(survey):
    """Returns the facts about the lattice and its coordinates."""
    lattice, lines = survey.get("lattice"), survey.get("line_numbers")
    pairs = [("Lattice", lattice and "{:,} \u00d7 {:,} columns, {:,} vertical indices".format(*lattice["columns"])),
             ("Origin", lattice and "(%.10g, %.10g, %.10g)" % tuple(lattice["origin"])),
             ("Lattice", lattice and "(%.7g, %.7g) from column to column, (%.7g, %.7g) from row to row, %.7g from index to "
              "index" % (*lattice["column_step"], *lattice["row_step"], lattice["vertical_step"])),
             ("Lines", lines and "inlines from %(first_inline)g in steps of %(inline_step)g, crosslines from "
              "%(first_crossline)g in steps of %(crossline_step)g" % lines),
             ("Coordinate system", survey.get("coordinate_system")),
             ("Units", _units(survey))]
    dropped = [("dropped_duplicates", "duplicates in a column"), ("dropped_nulls", "no value")]
    left = ["%s (%s)" % (count(survey[key], "point"), why) for key, why in dropped if survey.get(key)]
    return pairs + [("Left out", ", ".join(left))]


def _world_units(survey):
    """Returns the units of distances in space, where z has the unit of the file."""
    along, up = survey.get("horizontal_unit"), survey.get("vertical_unit")
    if along == up:
        return along or "world units"
    return "%s, z in %s" % (along or "unit of x and y", up or "that of the file")


def _units(survey):
    """Returns the units; unknown ones are also shown, because results depend on them."""
    if not survey:
        return None
    vertical = " ".join(filter(None, (survey["vertical_domain"], survey["vertical_unit"]
                                      and "in %s" % survey["vertical_unit"])))
    direction = survey["vertical_direction"]
    return "x and y: %s; z: %s%s" % (survey["horizontal_unit"] or "not stated", vertical or "not stated",
                                     ", increasing %swards" % direction if direction else "")


def horizon_table(run, album):
    pairs = horizons_of(run)
    if not pairs:
        return Markup()
    many = len(run["files"]) > 1
    has_closed = any(horizon["fault_triangles"] for _, horizon in pairs)
    columns = [column for column in COLUMNS if has_closed or column != FAULT_COLUMN]
    rows = []
    for number, (file, horizon) in enumerate(pairs):
        image = album.entries[number].thumbnail if album else None
        thumbnail = fill("thumbnail", uri=data_uri(image, "image/jpeg"), width=albums.THUMBNAIL_SIZE[0],
                         height=albums.THUMBNAIL_SIZE[1]) if image else None
        rows.append(fill("row", number=number, name=horizon["name"], thumbnail=thumbnail,
                         file=fill("of_file", label=file["label"]) if many else None,
                         cells=join(_cell(value(horizon), form) for _, _, value, form in columns)))
    heads = [fill("head", kind="name", text="Horizon", meaning="its name")]
    heads += [fill("head", kind="number", text=text, meaning=meaning) for text, meaning, _, _ in columns]
    return fill("horizons", heads=join(heads), rows=join(rows), note=_about_distances(run),
                filter=fill("filter") if len(pairs) > FROM_HERE_FILTERED else None)


def layers(run, album):
    """Returns the volumes between the horizons of each file with layers."""
    having = [file for file in run["files"] if file["layers"]]
    if not having:
        return Markup()
    heads = [fill("plain_head", kind="name", text="Layer", meaning="from its top to its base")]
    heads += [fill("plain_head", kind="number", text=text, meaning=meaning) for text, meaning, _, _ in LAYER_COLUMNS]
    pictures = [entry.pictures for entry in album.layers] if album else [[]] * len(having)
    return fill("layers", tables=join(_layer_table(file, join(heads), own) for file, own in zip(having, pictures)))


def _layer_table(file, heads, pictures):
    unit = file["layers"][0]["volume_unit"]
    vertical = (file["survey"] or {}).get("vertical_unit")
    shown = [_picture(picture, "%s of %s: %s" % (picture.title, file["label"], picture.caption), "%.3g", vertical)
             for picture in pictures]
    return fill("layer_table", label=file["label"], unit="Volumes in %s. " % unit if unit else None, heads=heads,
                rows=join(fill("layer_row", name=own["name"], cells=join(
                    _cell(value(own), form) for _, _, value, form in LAYER_COLUMNS)) for own in file["layers"]),
                pictures=fill("pictures", pictures=join(shown)) if shown else None)


def _about_distances(run):
    """Returns the unit of distances, and the horizons without distances."""
    known = [horizon["error"] is not None for _, horizon in horizons_of(run)]
    note = "Distances are in lattice units, 1 being a step from column to column, or a vertical index."
    if all(known):
        return note
    if METER not in run["parameters"]:
        return "Distances were not measured."
    if not any(known):
        return "Distances were not measured: the horizons are larger than memory."
    return note + " They were measured for %d of %d horizons; the others are larger than memory." % (sum(known), len(known))


def _cell(value, form):
    if value is None:
        return fill("cell", value="", text="\u2013")
    return fill("cell", value="%.9g" % value, text=_with_unit(form.format(value), value))


def details(run, album):
    pairs = horizons_of(run)
    if not pairs:
        return Markup()
    drawn = sum(1 for entry in album.entries if entry.pictures)
    note = "No pictures were requested." if not album.with_pictures else (
        "Stages are shown for %s." % ("all horizons" if drawn == len(pairs) else
                                      "the %d horizons with the most points, of %d" % (drawn, len(pairs))))
    many = len(run["files"]) > 1
    return fill("details", note=note, horizons=join(
        _details(number, horizon, file["survey"] or {}, album.entries[number], file["label"] if many else None)
        for number, (file, horizon) in enumerate(pairs)))


def _details(number, horizon, survey, entry, label):
    largest = _vertical(horizon, "largest")
    distance = _error(horizon, "largest")
    units = {"lattice": "lattice units", "world": _world_units(survey)}
    unit = horizon["distances"] and units[horizon["distances"]["unit"]]
    words = [label, count(horizon["points_in"], "point"), count(horizon["triangles"], "triangle"),
             _with_unit("vertical error at most %.3g" % largest, largest) if largest is not None else
             None if distance is None else "error at most %.3g" % distance]
    return fill("horizon", number=number, name=horizon["name"], short=", ".join(filter(None, words)),
                charts=_charts(horizon, unit),
                turn=fill("turn", number=number) if entry.mesh else None,
                pictures=_pictures(horizon["name"], entry, unit), facts=_horizon_facts(horizon, survey),
                errors=_error_table(horizon["error"], units))


def _pictures(name, entry, unit):
    if not entry.pictures:
        return None
    return fill("pictures", pictures=join(_picture(picture, "%s of %s: %s; seen from above and aside, heights \u00d7 %g" % (
        picture.title, name, picture.caption, entry.exaggeration), "%.3g and more", unit) for picture in entry.pictures))


def _picture(picture, alt, last, unit):
    """Returns a picture, with its colour scale if it has one; `last` is the label of the last value."""
    width, height = albums.PICTURE_SIZE
    ends = picture.scale_ends
    scale = None if ends is None else fill("scale", first="%.3g" % ends[0], last=last % ends[1])
    caption = picture.caption if scale is None or not unit else "%s, %s" % (picture.caption, unit)
    return fill("picture", uri=data_uri(picture.jpeg, "image/jpeg"), width=width, height=height, alt=alt,
                title=picture.title, caption=caption, scale=scale)


def _charts(horizon, unit):
    shown = []
    if horizon["distances"]:
        shown.append(histogram("Distance of the horizon's points from the mesh", "fraction of the points",
                               horizon["distances"]["counts"], horizon["distances"]["farthest"], unit))
    if horizon["angles"]:
        shown.append(histogram("Smallest angle of the triangles", "fraction of the triangles, on the map",
                               horizon["angles"]["counts"], 60.0, "degrees"))
    return join(shown)


def _horizon_facts(horizon, survey):
    chosen = join((fill("value", name=name, value=_value(
        _in_unit(horizon, value) if "Chosen" + name in heights.FIGURES else value))
                   for name, value in horizon["chosen"].items()), "\n")
    seconds = join((fill("value", name=STAGE_NAMES.get(name, name), value="%.2f s" % value)
                    for name, value in horizon["seconds"].items()), "\n")
    before, after = horizon["outline_points_in"], horizon["outline_points"]
    bounds = horizon["bounds"]
    return facts([
        ("Points", "{:,} in, {:,} out".format(horizon["points_in"], horizon["points_out"])),
        ("Patches, holes", None if horizon["patches"] is None else "%d, %d" % (horizon["patches"], horizon["holes"] or 0)),
        ("Outlines", "{:,} with {:,} points".format(horizon["outlines"], after) + (
            "" if before is None else " of {:,}".format(before))),
        (FAULT_COLUMN[0], "{:,}".format(horizon["fault_triangles"]) if horizon["fault_triangles"] else None),
        *((PREPARED[name].capitalize(), "{:,}".format(number)) for name, number in horizon["prepared"].items()),
        ("Faults", _fault_texts(horizon)),
        ("Columns (area)", _ledger_text(horizon["ledger"])),
        ("Vertical error", horizon["vertical_error"] and _vertical_text(horizon, survey)),
        ("Automatic error", _automatic_text(horizon)),
        ("Chosen", chosen), ("Extent", bounds and "x %.10g to %.10g, y %.10g to %.10g, z %.10g to %.10g" % tuple(bounds)),
        ("Time", seconds), ("Files", ", ".join(horizon["results"]))])


def _fault_texts(horizon):
    """Returns a line for each fault, the one with the most links first."""
    def text(fault):
        if fault["throw_mean"] is None:
            return count(fault["links"], "link")
        mean, largest = (_in_unit(horizon, fault[name]) for name in ("throw_mean", "throw_largest"))
        return "%s, throw %.3g on average, at most %s" % (
            count(fault["links"], "link"), mean, _with_unit("%.3g" % largest, largest) if largest.unit else "%.3g vertical indices" % largest)

    found = sorted(horizon["faults"], key=lambda fault: -fault["links"])
    return found and join((fill("value", name=fault["name"], value=text(fault)) for fault in found), "\n")


def _ledger_text(own):
    """Returns the ledger entries that are not empty, one per line."""
    return own and join((fill("value", name=ledger.HEADS[entry], value=ledger.amount(own, entry))
                         for entry, number in own["columns"].items() if number), "\n")


def _vertical_text(horizon, survey):
    largest, mean, edges, outlines = (_vertical(horizon, name) for name in ("largest", "mean", "edges", "outlines"))
    unit = survey.get("vertical_unit")
    reported = largest.unit or "vertical indices" + (" (%.3g %s)" % (largest * horizon["vertical_step"], unit) if unit else "")
    text = "at most %.3g %s, %.3g on average; at outlines at most %.3g" % (largest, reported, mean, outlines)
    if edges > largest:  # without a bound
        text += ", at edges between points at most %.3g" % edges
    outside = horizon["points_outside"]
    return text + (", with %s outside" % count(outside, "point") if outside else "")


def _automatic_text(horizon):
    """Returns an automatic error and how it was chosen, or None."""
    for name, deviation in horizon["automatic_error"].items():
        if deviation is not None:
            error, noise = (_in_unit(horizon, value) for value in (horizon["chosen"]["MaximumError"], deviation))
            return "%.3g %s, six times the %s of %.3g" % (error, error.unit or "vertical indices", name, noise)
    return None


def _error_table(error, units):
    if not error:
        return None

    def text(unit, key):
        value = error[unit][key]
        # Differences due to rounding are shown as zero.
        return "\u2013" if value is None else "%.4g" % (0.0 if value < 1e-9 * error[unit]["largest"] else value)

    return fill("errors", world=units["world"], rows=join(
        fill("error", name=name, lattice=text("lattice", key), world=text("world", key)) for name, key in ERROR_ROWS))


def parameters(run):
    rows = []
    given = {**run["parameters"], "running": {name: value for name, value in run["running"].items() if value}}
    for name, values in given.items():
        if values:
            shown = join((fill("value", name=key, value=_value(value)) for key, value in values.items()), "\n")
        else:
            shown = "defaults"
        rows.append(fill("parameter", name=name, values=shown))
    return fill("parameters", rows=join(rows), note="Other parameters have their defaults, see the documentation. Values "
                "that were chosen automatically are listed with each horizon.")


def _value(value):
    if isinstance(value, (list, tuple)):
        return " ".join(map(_value, value))
    return _with_unit("%g" % value, value) if isinstance(value, float) else str(value)
