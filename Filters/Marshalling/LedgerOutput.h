// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The ledger that a stage gives its output: of all columns that were read, those included that earlier stages left out.

#ifndef SeismicHorizonsLedgerOutput_h
#define SeismicHorizonsLedgerOutput_h

#include "Common/CoveredColumns.h"
#include "LatticePoints.h"

class vtkPolyData;

namespace SeismicHorizons
{
/// What is made of the points of a horizon covers these columns. Where an earlier stage has merged or dropped points,
/// its ledger is adapted, as their columns are not known any more; without one there is none.
void WriteLedger(const LatticePoints& points, const CoveredColumns& covered, vtkPolyData* output);

/// The output has some of the points of the input, or more: its ledger, unless the stage has written one. That of loops
/// and meshes goes on from stage to stage as it is.
void WriteLedgerOfPoints(vtkPolyData* input, vtkPolyData* output);
}

#endif
