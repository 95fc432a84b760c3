// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsStageReport_h
#define SeismicHorizonsStageReport_h

#include "Common/Horizon/Horizon.h"

#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Calls stage(), which returns warnings, after the outputs got the field data of the input, without figures of meshes.
/// Unless points are left, or with a mesh that the stage does not take, the stage is not called. Throws InputError.
std::vector<std::string> RunStage(const Horizon& input, bool takesMeshes, std::vector<Horizon>& outputs,
  const std::function<std::vector<std::string>()>& stage);

constexpr const char* StoppedReport = "stopped before the end: nothing was made\n";

/// Numbers have four digits, in any locale.
std::ostringstream MakeReportStream();

/// Lines of text: points before and after, and the figures that the stage has written.
std::string ReportStage(const std::string& name, const Horizon& input, const Horizon& output);

/// The same in short, as a row for Tabulate: its cells, with tabs between them.
std::string ReportRow(const std::string& name, const Horizon& input, const Horizon& output);

/// Returns rows as a table with a head, without columns that are empty or 0 in all of them, and then their warnings.
std::string Tabulate(const std::vector<std::string>& rows);
}

#endif
