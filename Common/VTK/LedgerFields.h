// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsLedgerFields_h
#define SeismicHorizonsLedgerFields_h

#include "Common/Horizon/Ledger.h"

#include <optional>
#include <vector>

class vtkFieldData;
class vtkPolyData;

namespace SeismicHorizons
{
/// Empty without the array Filled.
std::vector<unsigned char> ReadFilled(vtkPolyData* points);

Ledger CountPoints(vtkPolyData* points);

std::optional<Ledger> ReadLedger(vtkFieldData* data);

/// Adds areas if the field data have a lattice.
void WriteLedger(const Ledger& ledger, vtkFieldData* data);
}

#endif
