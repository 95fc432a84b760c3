// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsCutData_h
#define SeismicHorizonsCutData_h

#include "Common/Horizon/Horizon.h"
#include "Common/Horizon/LinkCuts.h"
#include "Filters/Algorithms/Faults/FaultLines.h"

#include <memory>
#include <optional>
#include <vector>

namespace SeismicHorizons
{
/// Also finds the array of version 0.2; null without either.
const DataArray* FindFaultedLinks(const ArrayTable& data);

/// Also removes arrays of version 0.2.
void RemoveFaultedLinks(ArrayTable& data);

/// Throws InputError unless a link is a column of the lattice and a side, 0 (east) or 1 (north).
std::vector<LatticeLink> ReadFaultedLinks(const Horizon& horizon);

/// Reads only cuts at `columns`, or nothing: the horizon may be a small part of its lattice, and cuts take memory for
/// their bounding box. Throws InputError as ReadFaultedLinks.
std::optional<LinkCuts> FindCuts(const Horizon& horizon, const PlaneBox& columns);

std::shared_ptr<const LinkCuts> ShareCuts(const Horizon& horizon, const PlaneBox& columns);

/// The names of faults by line, or "fault 1" and so on if unknown.
std::vector<std::string> NamesOf(const FaultLines& lines);

/// Replaces FaultedLinks, FaultThrow, FaultLine and FaultNames. A link on several lines belongs to the first.
void WriteCuts(const FaultLines& lines, ArrayTable& data);
}

#endif
