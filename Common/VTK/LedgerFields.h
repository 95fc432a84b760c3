// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The ledger (Common/Ledger.h) in the field data of a dataset.

#ifndef SeismicHorizonsLedgerFields_h
#define SeismicHorizonsLedgerFields_h

#include "Common/Ledger.h"

#include <optional>
#include <vector>

class vtkFieldData;
class vtkPolyData;

namespace SeismicHorizons
{
/// The value of the array Filled at each point, as read for the ledger; empty without the array.
std::vector<unsigned char> ReadFilled(vtkPolyData* points);

/// The ledger of points alone.
Ledger CountPoints(vtkPolyData* points);

/// None where there is none.
std::optional<Ledger> ReadLedger(vtkFieldData* data);

/// Adds the columns, and their areas by the lattice of the same field data, if any.
void WriteLedger(const Ledger& ledger, vtkFieldData* data);
}

#endif
