// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads fault traces, polygons and sticks: GOCAD PLine, ZMAP+ points and polygons, CPS-3 lines, Charisma sticks, and
// lines of x y z (Documentation/FaultLines.md). The format is recognised by content. Errors are InputError, with
// the number of the line: "line 17: ".

#ifndef SeismicHorizonsFaultLineFile_h
#define SeismicHorizonsFaultLineFile_h

#include "Common/Base/Monitor.h"
#include "Common/Horizon/Types.h"
#include "Common/Survey/SurveyDescription.h"
#include "FaultColumns.h"

#include <cstddef>
#include <istream>
#include <string>
#include <vector>

namespace SeismicHorizons
{
class FaultLineFile
{
public:
  std::vector<SpacePoint> Places;
  std::vector<std::size_t> Ends; // The index in Places after the last point of each polyline.
  std::vector<std::string> Names; // of the fault of each polyline; empty if unknown
  std::vector<std::string> Sticks; // the number of each polyline in its fault; empty if unknown
  std::string Columns; // of a table
  std::size_t WithoutZ = 0; // points of a table that were left out
  std::size_t SinglePoints = 0; // lines of one point, which were left out
  SurveyDescription Survey;
  bool IsUpright = false; // The file says that z increases upwards.
  bool SaysDirection = false; // z increases downwards for certain unless it IsUpright.

  void Append(const SpacePoint& place) { this->Places.push_back(place); }

  /// A polyline of a single point is dropped.
  void Close(const std::string& name, const std::string& stick = std::string())
  {
    const std::size_t start = this->Ends.empty() ? 0 : this->Ends.back();
    if (this->Places.size() - start < 2)
    {
      this->SinglePoints += this->Places.size() - start;
      this->Places.resize(start);
      return;
    }
    this->Ends.push_back(this->Places.size());
    this->Names.push_back(name);
    this->Sticks.push_back(stick);
  }
};

/// Requires marks of a format in the beginning of the file, and a polyline.
bool BeginsAsFaultLines(std::istream& stream);

/// Whether a table has a column that tells lines apart, by its name or, without names, by its values. May be picks.
bool IsFaultTable(std::istream& stream);

/// Options are of tables.
FaultLineFile ReadFaultLines(std::istream& stream, const FaultTextOptions& options = {},
  const Monitor& monitor = Monitor(), std::size_t bufferSize = 1024 * 1024);
}

#endif
