// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaultWarnings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <locale>
#include <map>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
constexpr std::size_t MostNamed = 5;

/// "F1, F2 and 3 more"; lines without a name are numbered.
std::string List(const std::vector<std::string>& names)
{
  std::string text;
  for (std::size_t n = 0; n < std::min(MostNamed, names.size()); ++n)
  {
    text += (n > 0 ? ", " : "") + names[n];
  }
  return names.size() > MostNamed ? text + " and " + std::to_string(names.size() - MostNamed) + " more" : text;
}

std::string NameOr(const std::string& name, const char* otherwise, std::size_t number)
{
  return name.empty() ? otherwise + std::to_string(number + 1) : name;
}
}

//----------------------------------------------------------------------------------------------------------------------
FaultWarnings::FaultWarnings(const LatticePoints& points)
  : Points(points)
  , Least(points.Column[0])
  , Most(points.Column[0])
{
  for (std::size_t n = 0; n < points.Column.size(); ++n)
  {
    const PlanePoint column = points.Column[n];
    this->Least = { std::min(this->Least.X, column.X), std::min(this->Least.Y, column.Y) };
    this->Most = { std::max(this->Most.X, column.X), std::max(this->Most.Y, column.Y) };
  }
  const auto [lowest, highest] = std::minmax_element(points.Height.begin(), points.Height.end());
  this->Lowest = *lowest;
  this->Highest = *highest;
}

//----------------------------------------------------------------------------------------------------------------------
bool FaultWarnings::IsBeside(double x, double y) const
{
  return !(x >= double(this->Least.X) - 1.0 && x <= double(this->Most.X) + 1.0 && y >= double(this->Least.Y) - 1.0 &&
    y <= double(this->Most.Y) + 1.0);
}

//----------------------------------------------------------------------------------------------------------------------
double FaultWarnings::PartInside(const FaultPolyline& line) const
{
  double all = 0.0;
  double inside = 0.0;
  for (std::size_t n = 1; n < line.size(); ++n)
  {
    const std::array<double, 2> start = { line[n - 1].X, line[n - 1].Y };
    const std::array<double, 2> step = { line[n].X - line[n - 1].X, line[n].Y - line[n - 1].Y };
    const std::array<double, 2> least = { double(this->Least.X) - 1.0, double(this->Least.Y) - 1.0 };
    const std::array<double, 2> most = { double(this->Most.X) + 1.0, double(this->Most.Y) + 1.0 };
    double enters = 0.0; // parts of the way
    double leaves = 1.0;
    for (std::size_t axis = 0; axis < start.size(); ++axis)
    {
      const double a = (least[axis] - start[axis]) / step[axis];
      const double b = (most[axis] - start[axis]) / step[axis];
      const bool isIn = start[axis] >= least[axis] && start[axis] <= most[axis];
      enters = step[axis] == 0.0 ? (isIn ? enters : 1.0) : std::max(enters, std::min(a, b));
      leaves = step[axis] == 0.0 ? leaves : std::min(leaves, std::max(a, b));
    }
    const double length = std::hypot(step[0], step[1]);
    all += length;
    inside += length * std::max(0.0, leaves - enters);
  }
  return all > 0.0 ? inside / all : this->IsBeside(line[0].X, line[0].Y) ? 0.0 : 1.0;
}

//----------------------------------------------------------------------------------------------------------------------
std::string FaultWarnings::CauseOf(const FaultSheet& sheet) const
{
  bool isBeside = true;
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const std::optional<SpacePoint>& place : sheet.Places)
  {
    if (place)
    {
      isBeside = isBeside && this->IsBeside(place->X, place->Y);
      least = std::min(least, place->Z);
      most = std::max(most, place->Z);
    }
  }
  if (isBeside)
  {
    return "x and y beside the horizon: are they exchanged, or of another coordinate system?";
  }
  if (most < this->Lowest || least > this->Highest)
  {
    const Lattice& lattice = this->Points.Lattice;
    const double step = (lattice.ToWorld(Eigen::Vector3d::UnitZ()) - lattice.ToWorld(Eigen::Vector3d::Zero())).norm();
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(4);
    text << "z " << step * (most < this->Lowest ? this->Lowest - most : least - this->Highest)
         << " away from that of the horizon: is it of another unit or direction?";
    return text.str();
  }
  return "sticks that end before the horizon";
}

//----------------------------------------------------------------------------------------------------------------------
void FaultWarnings::AddSticks(const std::vector<FaultStick>& sticks, const std::vector<FaultSheet>& sheets,
  const std::vector<std::size_t>& traces, bool areExtended)
{
  std::map<std::string, std::int64_t> alone; // numbers of sticks in no sheet
  for (const FaultStick& stick : sticks)
  {
    ++alone[stick.Fault];
  }
  std::vector<std::string> idle;
  for (std::size_t n = 0; n < sheets.size(); ++n)
  {
    alone[sheets[n].Fault] -= std::int64_t(sheets[n].Sticks) - (areExtended ? 2 : 0);
    if (traces[n] == 0)
    {
      idle.push_back(NameOr(sheets[n].Fault, "fault ", n));
      this->Cause = this->Cause.empty() ? this->CauseOf(sheets[n]) : this->Cause;
    }
  }
  std::int64_t left = 0;
  std::vector<std::string> names;
  for (const auto& [name, number] : alone)
  {
    left += number;
    if (number > 0 && !name.empty())
    {
      names.push_back(name);
    }
  }
  if (left > 0)
  {
    const std::string of = names.empty() ? "" : " (" + List(names) + ")";
    this->Warnings.push_back(std::to_string(left) + " of " + std::to_string(sticks.size()) + " fault sticks" + of +
      " join no surface, expected two sticks of two points for each fault, beside each other");
    this->Cause = this->Cause.empty() ? "sticks that join no surface" : this->Cause;
  }
  if (!idle.empty())
  {
    this->Warnings.push_back(std::to_string(idle.size()) + " of " + std::to_string(sheets.size()) + " faults (" +
      List(idle) + ") cut nothing: " + this->Cause);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void FaultWarnings::AddLines(const std::vector<FaultStick>& lines, const std::vector<FaultPolyline>& onMap)
{
  std::vector<std::string> names;
  for (std::size_t n = 0; n < onMap.size(); ++n)
  {
    if (!onMap[n].empty() && this->PartInside(onMap[n]) <= 0.5)
    {
      names.push_back(NameOr(lines[n].Fault, "line ", n));
    }
  }
  if (!names.empty())
  {
    this->Cause = "x and y beside the horizon: are they exchanged, or of another coordinate system?";
    this->Warnings.push_back(std::to_string(names.size()) + " of " + std::to_string(lines.size()) + " fault lines (" +
      List(names) + ") are at least half beside the horizon");
  }
}
}
