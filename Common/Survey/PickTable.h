// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsPickTable_h
#define SeismicHorizonsPickTable_h

#include "SurveyDescription.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
/// A number for each point; nan where there is none.
struct PickAttribute
{
  std::string Name;
  std::vector<double> Values;
};

/// From a pick on, each stands in the line of its file that follows that of the one before.
struct PickLine
{
  std::size_t Pick; // from 0
  std::int64_t Line; // from 1
};

/// Points of horizons before it is known on which columns they stand, as parallel arrays.
struct PickTable
{
  SurveyDescription Survey;
  std::vector<std::string> Names; // of the horizons; at least one
  std::vector<int> Horizon; // of each pick the number of its horizon; empty where there is only one
  std::vector<double> X, Y; // in the world; empty where only line numbers are known
  std::vector<double> Inline, Crossline; // empty where only places in the world are known
  std::vector<double> Z; // in the unit and with the sign of the file; nan where there is none
  std::vector<PickAttribute> Attributes;
  std::vector<PickLine> Lines; // in the order of picks, as they were read; empty where these are of no file of lines
  std::vector<std::string> Doubts; // what users should know about the file
  bool AreLinesGuessed = false; // inlines and crosslines have no names, but look like these

  std::size_t Size() const { return this->Z.size(); }
  bool HasPlaces() const { return !this->X.empty() && !this->Y.empty(); }
  bool HasLines() const { return !this->Inline.empty() && !this->Crossline.empty(); }

  /// How many picks each horizon has.
  std::vector<std::int64_t> CountPicks() const
  {
    std::vector<std::int64_t> counts(this->Names.size(), 0);
    counts.front() = this->Horizon.empty() ? std::int64_t(this->Size()) : 0;
    for (const int horizon : this->Horizon)
    {
      ++counts[std::size_t(horizon)];
    }
    return counts;
  }
};
}

#endif
