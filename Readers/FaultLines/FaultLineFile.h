// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Reads fault traces, polygons and sticks from text files of other programs: GOCAD PLine, ZMAP+ points and polygons,
// CPS-3 lines, Charisma sticks, and lines of x y z (Documentation/FaultLinesReader.md). The format is recognised by
// content. All throw InputError, whose text starts with the number of the line, as "line 17: ".

#ifndef SeismicHorizonsFaultLineFile_h
#define SeismicHorizonsFaultLineFile_h

#include "Common/Monitor.h"
#include "Common/Types.h"

#include <cstddef>
#include <istream>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// Polylines, each with the name that the file gives it, or an empty one.
class FaultLineFile
{
public:
  std::vector<SpacePoint> Places;
  std::vector<std::size_t> Ends; // of each polyline in the places
  std::vector<std::string> Names;
  bool IsUpright = false; // whether z counts upwards for certain, as the format says where it counts to

  /// Appends to the polyline that is being built.
  void Append(const SpacePoint& place) { this->Places.push_back(place); }

  /// Ends that polyline. One of a single place is left out.
  void Close(const std::string& name)
  {
    const std::size_t start = this->Ends.empty() ? 0 : this->Ends.back();
    if (this->Places.size() - start < 2)
    {
      this->Places.resize(start);
      return;
    }
    this->Ends.push_back(this->Places.size());
    this->Names.push_back(name);
  }
};

/// Whether a file has fault lines for certain, by its beginning: marks of its format, and lines of them.
bool BeginsAsFaultLines(std::istream& stream);

/// Reads a file. `bufferSize` is how many bytes are held at a time.
FaultLineFile ReadFaultLines(
  std::istream& stream, const Monitor& monitor = Monitor(), std::size_t bufferSize = 1024 * 1024);
}

#endif
