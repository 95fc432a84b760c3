// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TracePlaces.h"

#include "Common/Horizon/Median.h"
#include "Common/Horizon/Types.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
// In multiples of the usual step.
constexpr double LongestStep = 10.0;
// Distance to the second neighbour, as a fraction of the path through the first (median).
constexpr double LeastAdvance = 0.7;

using Places = std::vector<Eigen::Vector2d>;

class TraceLine
{
public:
  std::size_t Strays = 0;

  explicit TraceLine(Places places)
    : All(std::move(places))
  {
    for (std::size_t column = 0; column < this->All.size(); ++column)
    {
      if (this->All[column].allFinite())
      {
        this->Columns.push_back(column);
      }
    }
  }

  bool DropStrays()
  {
    if (this->Columns.size() < 2 || !(this->UsualStep() > 0.0) || this->UsualAdvance() < LeastAdvance)
    {
      return false;
    }
    const double longest = LongestStep * this->UsualStep();
    std::vector<std::size_t> kept;
    std::size_t jumps = 0;
    for (std::size_t n = 0; n < this->Columns.size(); ++n)
    {
      const bool isBehind = n > 0 && this->Step(n - 1, n) <= longest;
      const bool isBefore = n + 1 < this->Columns.size() && this->Step(n, n + 1) <= longest;
      if (isBehind || isBefore)
      {
        kept.push_back(this->Columns[n]);
      }
      jumps += !isBehind && n > 0;
    }
    this->Strays = this->Columns.size() - kept.size();
    const bool isLine = double(jumps) <= std::max(2.0, 2.0 * MostStrays * double(this->Columns.size()));
    this->Columns = kept;
    return isLine && this->Columns.size() >= 2;
  }

  /// Missing places are on straight lines through the nearest two.
  Places Complete() const
  {
    Places places = this->All;
    std::size_t next = 0;
    for (std::size_t column = 0; column < places.size(); ++column)
    {
      while (next + 2 < this->Columns.size() && this->Columns[next + 1] <= column)
      {
        ++next;
      }
      const std::size_t a = this->Columns[next];
      const std::size_t b = this->Columns[next + 1];
      if (column != a && column != b)
      {
        const double part = (double(column) - double(a)) / double(b - a);
        places[column] = this->All[a] + part * (this->All[b] - this->All[a]);
      }
    }
    return places;
  }

private:
  double Step(std::size_t n, std::size_t m) const
  {
    return this->Distance(n, m) / double(this->Columns[m] - this->Columns[n]);
  }

  double Distance(std::size_t n, std::size_t m) const
  {
    return (this->All[this->Columns[m]] - this->All[this->Columns[n]]).norm();
  }

  double UsualStep() const
  {
    std::vector<double> steps;
    for (std::size_t n = 1; n < this->Columns.size(); ++n)
    {
      steps.push_back(this->Step(n - 1, n));
    }
    return UpperMedian(steps);
  }

  /// Returns 1 for a straight line, and about 0.5 for random places.
  double UsualAdvance() const
  {
    std::vector<double> parts = { 1.0 };
    for (std::size_t n = 2; n < this->Columns.size(); ++n)
    {
      const double way = this->Distance(n - 2, n - 1) + this->Distance(n - 1, n);
      parts.push_back(way > 0.0 ? this->Distance(n - 2, n) / way : 1.0);
    }
    return UpperMedian(parts);
  }

  const Places All;
  std::vector<std::size_t> Columns;
};

Places ListLinePlaces(const SEGYCube& cube, const LineNumbers& lines, const FieldPair& fields)
{
  Places places(cube.Traces.size(), Eigen::Vector2d(NoValue, NoValue));
  for (std::size_t column = 0; column < places.size(); ++column)
  {
    const std::int32_t trace = cube.Traces[column];
    if (trace >= 0 && HasPlace(lines, fields, trace))
    {
      places[column] = TracePlace(lines.Table, fields, trace);
    }
  }
  return places;
}

std::vector<FieldPair> ListLineCandidates(const SEGYCube& cube, const FieldPair& given)
{
  const FieldPair& chosen = given.First > 0 ? given : cube.PlaceFields;
  return chosen.First > 0 ? std::vector<FieldPair>{ chosen }
                          : std::vector<FieldPair>(PlacePairs.begin(), PlacePairs.end());
}
}

//----------------------------------------------------------------------------------------------------------------------
void PlaceAlongLine(SEGYCube& cube, const LineNumbers& lines, const FieldPair& given)
{
  for (const FieldPair& fields : ListLineCandidates(cube, given))
  {
    const bool isGiven = given.First > 0;
    if (!isGiven && (AreSame(lines.Table, fields) || AreLineNumbers(lines, fields)))
    {
      continue;
    }
    TraceLine line(ListLinePlaces(cube, lines, fields));
    if (AreFloats(lines, fields) || !line.DropStrays())
    {
      continue;
    }
    cube.Places = line.Complete();
    if (cube.PlaceFields.First == NoField)
    {
      cube.Warnings.push_back("the second output has the traces of the line at their true positions");
    }
    if (line.Strays > 0)
    {
      std::ostringstream text;
      text << line.Strays << " traces far from both neighbours in x and y (bytes " << fields.First << " and "
           << fields.Second << "): moved between them";
      cube.Warnings.push_back(text.str());
    }
    return;
  }
}
}
