# SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The ledger of all columns of a horizon, as described in the section Ledger of Documentation/DataModel.md."""

ENTRIES = ("known", "filled", "bridged", "extrapolated", "left_out")  # the components of the arrays
HEADS = dict(zip(ENTRIES, ("known", "filled", "bridged", "extrapolated", "left out")))
WARNING_FRACTION = 0.001  # fraction of the covered area, as LedgerWarningFraction in Common/Ledger.h


def read(dataset):
    """Returns columns and areas by entry, as {"columns": {"known": ...}, "area": {...}}; None for a dataset without a
    ledger."""
    data = dataset.GetFieldData()
    columns, area = (data.GetArray(name) for name in ("LedgerColumns", "LedgerArea"))
    if columns is None:
        return None
    return {"columns": {entry: int(columns.GetComponent(0, n)) for n, entry in enumerate(ENTRIES)},
            "area": area and {entry: area.GetComponent(0, n) for n, entry in enumerate(ENTRIES)}}


def covered(ledger):
    """Returns the number of columns that the result covers."""
    return sum(number for entry, number in ledger["columns"].items() if entry != "left_out")


def warning(ledger):
    """Returns the text of a warning, or None."""
    if ledger is None or not any(ledger["columns"].values()):
        return None
    if not covered(ledger):
        return "all %d points are left out, as there is no area between them" % ledger["columns"]["left_out"]
    parts = {entry: 100.0 * number / covered(ledger) for entry, number in ledger["columns"].items()}
    found = ["%.2g %% is %s" % (parts[entry], HEADS[entry]) for entry in ("filled", "bridged", "extrapolated")
             if parts[entry] > 100.0 * WARNING_FRACTION]
    if parts["left_out"] > 100.0 * WARNING_FRACTION:
        found.append("points on another %.2g %% are left out" % parts["left_out"])
    return "of the covered area " + ", ".join(found) if found else None


def amount(ledger, entry):
    """Returns the columns of an entry and their area as a text."""
    area = ledger["area"]
    return "%d" % ledger["columns"][entry] + ("" if area is None else " (%.4g)" % area[entry])
