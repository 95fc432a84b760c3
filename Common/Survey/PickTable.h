// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsPickTable_h
#define SeismicHorizonsPickTable_h

#include "SurveyDescription.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
struct PickAttribute
{
  std::string Name;
  std::vector<double> Values;
};

/// From this pick on the lines of the file are consecutive.
struct PickLine
{
  std::size_t Pick; // from 0
  std::int64_t Line; // from 1
};

/// World coordinates are empty if only line numbers are known, and these if only world coordinates are.
struct PickPlaces
{
  std::vector<double> X, Y;
  std::vector<double> Inline, Crossline;

  std::size_t Size() const { return std::max(this->X.size(), this->Inline.size()); }
  bool HasPlaces() const { return !this->X.empty() && !this->Y.empty(); }
  bool HasLines() const { return !this->Inline.empty() && !this->Crossline.empty(); }
};

/// Picks before their columns are known, as parallel arrays.
struct PickTable : PickPlaces
{
  SurveyDescription Survey;
  std::vector<std::string> Names; // At least one horizon.
  std::vector<int> Horizon; // Horizon per pick; empty for a single one.
  std::vector<double> Z; // In the unit and with the sign of the file, or nan.
  std::vector<PickAttribute> Attributes;
  std::vector<PickLine> Lines; // Sorted; empty unless the picks come from a text file.
  std::vector<std::size_t> Dropped; // Numbers of picks that were here, in order.
  std::vector<std::string> Warnings;
  std::int64_t OtherLines = 0; // Left out by the choice of lines.
  bool AreRows = false; // Line numbers are columns and rows of a matrix, which has no places.
  bool AreLinesGuessed = false; // Unnamed fields were guessed to be line numbers.

  std::size_t Size() const { return this->Z.size(); }
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
