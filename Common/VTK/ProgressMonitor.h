// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The one connection between the monitor of the algorithms and the progress and abort of a VTK algorithm.

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
  // VTK 9.1 has no CheckAbort. With it, a flag that was set without a new abort time counts all the same.
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
