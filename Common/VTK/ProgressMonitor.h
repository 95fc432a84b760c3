// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Connects the monitor of the algorithms with progress and abort of a VTK algorithm.

#ifndef SeismicHorizonsProgressMonitor_h
#define SeismicHorizonsProgressMonitor_h

#include "Common/Monitor.h"
#include "vtkAlgorithm.h"
#include "vtkVersionMacros.h"

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

/// A monitor that reports to `algorithm`, which must outlive it, and stops when `algorithm` is aborted.
inline Monitor MakeMonitor(vtkAlgorithm* algorithm)
{
  return Monitor(
    [algorithm](double part)
    {
      algorithm->UpdateProgress(part);
      return !IsAborted(algorithm);
    });
}
}

#endif
