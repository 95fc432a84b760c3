// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Only this file depends on the version of VTK (Documentation/Install.md).

#ifndef SeismicHorizonsVersionDifferences_h
#define SeismicHorizonsVersionDifferences_h

#include "vtkAlgorithm.h"
#include "vtkVersionMacros.h"

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
#include "vtkCellTypeUtilities.h"
#else
#include "vtkCellTypes.h"
#endif

namespace SeismicHorizons
{
/// Includes algorithms upstream.
inline bool IsAborted(vtkAlgorithm* algorithm)
{
  // CheckAbort, new in VTK 9.2, looks upstream, but misses a flag that was set without SetAbortExecuteAndUpdateTime.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220831)
  if (algorithm->CheckAbort())
  {
    return true;
  }
#endif
  return algorithm->GetAbortExecute() != 0;
}

/// VTK requests the output of an aborted request again.
inline void MarkAborted([[maybe_unused]] vtkAlgorithm* algorithm, [[maybe_unused]] bool isAborted)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220831)
  algorithm->SetAbortOutput(isAborted);
#endif
}

inline const char* CellTypeName(int type)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  return vtkCellTypeUtilities::GetClassNameFromTypeId(type);
#else
  return vtkCellTypes::GetClassNameFromTypeId(type);
#endif
}
}

#endif
