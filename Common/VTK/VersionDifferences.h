// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What versions of VTK have under different names, or not at all (Documentation/Versions.md): nothing else asks for the
// version.

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
/// True when the user asked `algorithm`, or one upstream of it, to stop.
inline bool IsAborted(vtkAlgorithm* algorithm)
{
  // CheckAbort, which VTK 9.1 does not have, also looks upstream. It misses a flag that was set without
  // SetAbortExecuteAndUpdateTime, so that the flag is looked at as well.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220831)
  if (algorithm->CheckAbort())
  {
    return true;
  }
#endif
  return algorithm->GetAbortExecute() != 0;
}

/// Sets whether VTK takes the output for that of a request that was stopped: it asks for it again then.
inline void MarkAborted([[maybe_unused]] vtkAlgorithm* algorithm, [[maybe_unused]] bool isAborted)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220831)
  algorithm->SetAbortOutput(isAborted);
#endif
}

/// The name of a type of cells, as vtkHexahedron.
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
