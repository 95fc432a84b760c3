// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHorizonCellSimplification.h"

//------------------------------------------------------------------------------
vtkHorizonCellSimplification::vtkHorizonCellSimplification(int cellSize)
  : CellSize(cellSize)
{
}

//------------------------------------------------------------------------------
vtkHorizonCellSimplification::~vtkHorizonCellSimplification() = default;
