// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Writes fault traces, polygons and sticks as their reader reads them (Documentation/FaultLines.md).

#ifndef SeismicHorizonsFaultLinesFile_h
#define SeismicHorizonsFaultLinesFile_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/NamedHorizon.h"
#include "Writers/HorizonSampling.h"

#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Whether these are lines of faults, by their cell data.
bool AreFaultLines(const Horizon& lines);

/// The extension says the format: .pl GOCAD PLine, .pol IRAP, a file for each fault, .csv and any other tables. Lines may
/// have cell data FaultName and FaultStick. `subject` becomes the file at work. Throws InputError without a line, and for
/// what the format cannot hold.
void WriteFaultLines(const std::string& path, const std::vector<NamedHorizon>& lines, WrittenSense sense,
  const Monitor& monitor, std::string& subject);
}

#endif
