// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The links of a horizon's lattice that faults cut, in its field data (Documentation/DataModel.md).

#ifndef SeismicHorizonsCutData_h
#define SeismicHorizonsCutData_h

#include "Common/LinkCuts.h"
#include "Faults/FaultLines.h"

#include <memory>
#include <optional>
#include <vector>

class vtkDataArray;
class vtkDataObject;
class vtkFieldData;

namespace SeismicHorizons
{
/// The field data array FaultedLinks, or that of version 0.2; null where there is none.
vtkDataArray* FindFaultedLinks(vtkFieldData* data);

/// Takes the arrays of faulted links out, also those of version 0.2.
void RemoveFaultedLinks(vtkFieldData* data);

/// The links that this array lists. Throws InputError as FindCuts.
std::vector<LatticeLink> ReadFaultedLinks(vtkDataObject* horizon);

/// The cuts among some columns that the field data array FaultedLinks lists, in their own bounding box; nothing where
/// there is no such array, or none of them in it. Cuts far from the horizon, which may be a small part of its lattice,
/// would only take memory. Throws InputError on an array of other than three whole numbers a link, on columns outside
/// the lattice of the horizon, and on sides other than 0 and 1.
std::optional<LinkCuts> FindCuts(vtkDataObject* horizon, const PlaneBox& columns);

/// The same for a horizon that keeps them, or null.
std::shared_ptr<const LinkCuts> ShareCuts(vtkDataObject* horizon, const PlaneBox& columns);

/// Writes the links of fault lines as FaultedLinks, FaultThrow and FaultLine, in place of those there are. A link of
/// several lines is that of the first.
void WriteCuts(const FaultLines& lines, vtkFieldData* data);
}

#endif
