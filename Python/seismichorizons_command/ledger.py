# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The ledger of all columns of a horizon, as described in the section Ledger of Documentation/DataModel.md."""

from .data import values

ENTRIES = ("known", "filled", "bridged", "extrapolated", "left_out")  # the components of the arrays
HEADS = dict(zip(ENTRIES, ("known", "filled", "bridged", "extrapolated", "left out")))
WARNING_FRACTION = 0.001  # fraction of the covered area, as LedgerWarningFraction in Common/Horizon/Ledger.h


def read(dataset):
    """Returns columns and areas by entry, as {"columns": {"known": ...}, "area": {...}}; None for a dataset without a
    ledger."""
    columns, area = (values(dataset, name) for name in ("LedgerColumns", "LedgerArea"))
    if not columns:
        return None
    return {"columns": dict(zip(ENTRIES, map(int, columns))), "area": dict(zip(ENTRIES, area)) or None}


def covered(ledger):
    """Returns the number of columns that the result covers."""
    return sum(number for entry, number in ledger["columns"].items() if entry != "left_out")


def warning(ledger):
    """Returns the text of a warning, or None."""
    if ledger is None or not any(ledger["columns"].values()):
        return None
    if not covered(ledger):
        return "all %d points are left out, as there is no area between them" % ledger["columns"]["left_out"]
    columns = ledger["columns"]
    found = {entry: number / covered(ledger) for entry, number in columns.items() if entry != "known"}
    found = {entry: part for entry, part in found.items() if part > WARNING_FRACTION}
    texts = []
    if found.keys() - {"left_out"}:
        texts.append("of the covered area, " + " and ".join("%s is %s" % (_percent(part), HEADS[entry])
                                                            for entry, part in found.items() if entry != "left_out"))
    if "left_out" in found:
        texts.append("%s of the points are left out" % _percent(columns["left_out"] / (columns["known"] + columns["left_out"])))
    return "; ".join(texts) or None


def _percent(part):
    """Returns two digits of a fraction, without an exponent."""
    return "%.*f %%" % (0 if part > 0.095 else 1 if part > 0.0095 else 2, 100.0 * part)


def amount(ledger, entry):
    """Returns the columns of an entry and their area as a text."""
    area = ledger["area"]
    return "%d" % ledger["columns"][entry] + ("" if area is None else " (%.4g)" % area[entry])
