// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaultWarnings.h"

#include "Common/Horizon/PlaneGeometry.h"
#include "FaultStage.h"

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
constexpr const char* BesideCause = "x and y beside the horizon: are they exchanged, or of another coordinate system?";

/// Up to a column beyond the horizon is not beside.
bool IsBeside(const PlaneBox& box, double x, double y)
{
  return !(x >= double(box.Least.X) - 1.0 && x <= double(box.Greatest.X) + 1.0 && y >= double(box.Least.Y) - 1.0 &&
    y <= double(box.Greatest.Y) + 1.0);
}

/// Of the length of a line, seen from above.
double PartInside(const PlaneBox& box, const FaultPolyline& line)
{
  const std::array<double, 2> least = { double(box.Least.X) - 1.0, double(box.Least.Y) - 1.0 };
  const std::array<double, 2> most = { double(box.Greatest.X) + 1.0, double(box.Greatest.Y) + 1.0 };
  double all = 0.0;
  double inside = 0.0;
  for (std::size_t n = 1; n < line.size(); ++n)
  {
    const std::array<double, 2> start = { line[n - 1].X, line[n - 1].Y };
    const std::array<double, 2> step = { line[n].X - line[n - 1].X, line[n].Y - line[n - 1].Y };
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
  return all > 0.0 ? inside / all : IsBeside(box, line[0].X, line[0].Y) ? 0.0 : 1.0;
}

/// Why a sheet cuts nothing.
std::string CauseOf(const FaultSheet& sheet, const LatticePoints& points)
{
  const PlaneBox box(points.Column);
  bool isBeside = true;
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const std::optional<SpacePoint>& place : sheet.Places)
  {
    if (place)
    {
      isBeside = isBeside && IsBeside(box, place->X, place->Y);
      least = std::min(least, place->Z);
      most = std::max(most, place->Z);
    }
  }
  if (isBeside)
  {
    return BesideCause;
  }
  const auto [lowest, highest] = std::minmax_element(points.Height.begin(), points.Height.end());
  if (most < *lowest || least > *highest)
  {
    const Lattice& lattice = points.Lattice;
    const double step = (lattice.ToWorld(Eigen::Vector3d::UnitZ()) - lattice.ToWorld(Eigen::Vector3d::Zero())).norm();
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text.precision(4);
    text << "z " << step * (most < *lowest ? *lowest - most : least - *highest)
         << " away from that of the horizon: is it of another unit or direction?";
    return text.str();
  }
  return "sticks that end before the horizon";
}
}

//----------------------------------------------------------------------------------------------------------------------
std::string ListFaults(const std::vector<std::string>& names)
{
  std::string text;
  for (std::size_t n = 0; n < std::min(MostNamed, names.size()); ++n)
  {
    text += (n > 0 ? ", " : "") + names[n];
  }
  return names.size() > MostNamed ? text + " and " + std::to_string(names.size() - MostNamed) + " more" : text;
}

//----------------------------------------------------------------------------------------------------------------------
IdleLines FindIdleSticks(const std::vector<FaultStick>& sticks, const std::vector<FaultSheet>& sheets,
  const std::vector<std::size_t>& traces, bool areExtended, const LatticePoints& points)
{
  IdleLines found;
  found.Given = sticks.size();
  found.Sheets = sheets.size();
  std::map<std::string, std::int64_t> alone; // numbers of sticks in no sheet
  for (const FaultStick& stick : sticks)
  {
    ++alone[stick.Fault];
  }
  for (std::size_t n = 0; n < sheets.size(); ++n)
  {
    alone[sheets[n].Fault] -= std::int64_t(sheets[n].Sticks) - (areExtended ? 2 : 0);
    if (traces[n] == 0)
    {
      found.Uncut.push_back(NameOf(sheets, n));
      found.Cause = found.Cause.empty() ? CauseOf(sheets[n], points) : found.Cause;
    }
  }
  for (const auto& [name, number] : alone)
  {
    found.SticksAlone += std::size_t(number);
    if (number > 0 && !name.empty())
    {
      found.FaultsAlone.push_back(name);
    }
  }
  if (found.SticksAlone > 0 && found.Cause.empty())
  {
    found.Cause = "sticks that form no surface";
  }
  return found;
}

//----------------------------------------------------------------------------------------------------------------------
IdleLines FindIdleLines(
  const std::vector<FaultStick>& lines, const std::vector<FaultPolyline>& onMap, const LatticePoints& points)
{
  IdleLines found;
  found.Given = lines.size();
  const PlaneBox box(points.Column);
  for (std::size_t n = 0; n < onMap.size(); ++n)
  {
    if (!onMap[n].empty() && PartInside(box, onMap[n]) <= 0.5)
    {
      found.Beside.push_back(lines[n].Fault.empty() ? "line " + std::to_string(n + 1) : lines[n].Fault);
      found.Cause = BesideCause;
    }
  }
  return found;
}

//----------------------------------------------------------------------------------------------------------------------
void IdleLines::KeepCommon(const IdleLines& other)
{
  for (const auto names : { &IdleLines::Uncut, &IdleLines::Beside })
  {
    std::vector<std::string>& own = this->*names;
    const std::vector<std::string>& others = other.*names;
    own.erase(
      std::remove_if(own.begin(), own.end(),
        [&others](const std::string& name) { return std::find(others.begin(), others.end(), name) == others.end(); }),
      own.end());
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> IdleLines::Warnings() const
{
  std::vector<std::string> warnings;
  if (this->SticksAlone > 0)
  {
    const std::string of = this->FaultsAlone.empty() ? "" : " (" + ListFaults(this->FaultsAlone) + ")";
    warnings.push_back(std::to_string(this->SticksAlone) + " of " + std::to_string(this->Given) + " fault sticks" + of +
      " form no surface, expected at least two adjacent sticks of two points for each fault");
  }
  if (!this->Uncut.empty())
  {
    warnings.push_back(std::to_string(this->Uncut.size()) + " of " + std::to_string(this->Sheets) + " faults (" +
      ListFaults(this->Uncut) + ") cut nothing: " + this->Cause);
  }
  if (!this->Beside.empty())
  {
    warnings.push_back(std::to_string(this->Beside.size()) + " of " + std::to_string(this->Given) + " fault lines (" +
      ListFaults(this->Beside) + ") lie at least half outside the horizon");
  }
  return warnings;
}

//----------------------------------------------------------------------------------------------------------------------
GivenFaults::GivenFaults(std::vector<NamedHorizon> blocks)
  : Blocks(std::move(blocks))
  , Sticks(ReadFaultSticks(this->Blocks))
{
}

//----------------------------------------------------------------------------------------------------------------------
void GivenFaults::Add(const IdleLines& idle, bool cut)
{
  this->DoCut = this->DoCut || cut;
  this->Idle ? this->Idle->KeepCommon(idle) : void(this->Idle = idle);
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> GivenFaults::Warnings() const
{
  if (!this->Idle || this->Sticks.empty() || this->DoCut)
  {
    return this->Idle ? this->Idle->Warnings() : std::vector<std::string>();
  }
  std::vector<std::string> warnings;
  warnings.push_back("none of " + std::to_string(this->Sticks.size()) +
    " fault polylines passes between columns of a horizon, expected lines in the coordinates of its points" +
    (this->Idle->Cause.empty() ? "" : ": " + this->Idle->Cause));
  return warnings;
}
}
