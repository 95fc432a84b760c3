// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsFaultLineHorizon_h
#define SeismicHorizonsFaultLineHorizon_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Horizon.h"
#include "Common/Survey/LatticeFrame.h"
#include "FaultLineFile.h"

#include <optional>
#include <string>
#include <vector>

namespace SeismicHorizons
{
struct FaultLineData
{
  Horizon Lines; // a polyline per line of the files
  /// What each file was taken for, in a line: "X, Y, Z, Stick, Node: 6 faults, 155 lines, z 1535 to 1948 down".
  std::string Description;
};

/// Without a direction, z of a file increases upwards if none is positive. Files may say theirs. Lines without a name get
/// that of their file if there are several. Errors name the file.
FaultLineData LoadFaultLines(const std::vector<std::string>& paths, const FaultTextOptions& options,
  std::optional<VerticalDirection> direction, const Monitor& monitor);
}

#endif
