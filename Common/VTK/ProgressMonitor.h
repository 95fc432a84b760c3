// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Connects the monitor of the algorithms with progress and abort of a VTK algorithm.

#ifndef SeismicHorizonsProgressMonitor_h
#define SeismicHorizonsProgressMonitor_h

#include "Common/Monitor.h"
#include "VersionDifferences.h"

#include "vtkAlgorithm.h"

namespace SeismicHorizons
{
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
