// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaultLineHorizon.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/Survey/SurveyFields.h"
#include "Common/Text/FileErrors.h"
#include "Common/Text/InputFile.h"

#include <algorithm>
#include <cstdint>
#include <locale>
#include <memory>
#include <numeric>
#include <set>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
bool AreNegative(const std::vector<SpacePoint>& places)
{
  return std::none_of(places.begin(), places.end(), [](const SpacePoint& place) { return place.Z > 0.0; }) &&
    std::any_of(places.begin(), places.end(), [](const SpacePoint& place) { return place.Z < 0.0; });
}

std::string DescribeLines(const FaultLineFile& file, bool isUp)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(7);
  std::set<std::string> faults(file.Names.begin(), file.Names.end());
  faults.erase("");
  text << file.Columns << (file.Columns.empty() ? "" : ": ");
  if (!faults.empty())
  {
    text << faults.size() << (faults.size() == 1 ? " fault, " : " faults, ");
  }
  const auto [least, most] = std::minmax_element(
    file.Places.begin(), file.Places.end(), [](const SpacePoint& a, const SpacePoint& b) { return a.Z < b.Z; });
  text << file.Ends.size() << (file.Ends.size() == 1 ? " line, z " : " lines, z ") << least->Z << " to " << most->Z
       << (isUp ? " up" : " down");
  const auto addLeftOut = [&text](std::size_t number, const char* one, const char* many)
  {
    if (number > 0)
    {
      text << ", " << number << (number == 1 ? one : many) << " left out";
    }
  };
  addLeftOut(file.WithoutZ, " point without z", " points without z");
  addLeftOut(file.SinglePoints, " line of a single point", " lines of a single point");
  return text.str();
}

/// Numbers lines without one, where there are names.
void NameLines(const std::string& fault, FaultLineFile& file)
{
  for (std::size_t line = 0; line < file.Ends.size(); ++line)
  {
    file.Names[line] = file.Names[line].empty() ? fault : file.Names[line];
    file.Sticks[line] = file.Sticks[line].empty() ? std::to_string(line + 1) : file.Sticks[line];
  }
}

/// Adds the lines of another file, with z upwards.
void Append(const FaultLineFile& file, bool isUp, FaultLineFile& all)
{
  const std::size_t first = all.Places.size();
  for (const SpacePoint& place : file.Places)
  {
    all.Places.push_back({ place.X, place.Y, isUp ? place.Z : -place.Z });
  }
  std::transform(
    file.Ends.begin(), file.Ends.end(), std::back_inserter(all.Ends), [first](std::size_t end) { return first + end; });
  all.Names.insert(all.Names.end(), file.Names.begin(), file.Names.end());
  all.Sticks.insert(all.Sticks.end(), file.Sticks.begin(), file.Sticks.end());
}

/// Lines have their points one after the other.
Cells MakeFaultCells(const FaultLineFile& file)
{
  Cells cells = { NewArray<std::int64_t>("", std::int64_t(file.Ends.size()) + 1),
    NewArray<std::int64_t>("", std::int64_t(file.Places.size())) };
  auto* const offsets = cells.Offsets.As<std::int64_t>();
  offsets[0] = 0;
  std::copy(file.Ends.begin(), file.Ends.end(), offsets + 1);
  auto* const points = cells.Points.As<std::int64_t>();
  std::iota(points, points + file.Places.size(), std::int64_t(0));
  return cells;
}

Horizon MakeLines(const FaultLineFile& file)
{
  Horizon lines;
  lines.Places = NewArray<double>("Points", std::int64_t(file.Places.size()), 3);
  auto* coordinate = lines.Places.As<double>();
  for (const SpacePoint& place : file.Places)
  {
    *coordinate++ = place.X;
    *coordinate++ = place.Y;
    *coordinate++ = place.Z;
  }
  lines.Lines = MakeFaultCells(file);
  const auto areSaid = [](const std::vector<std::string>& texts)
  { return std::any_of(texts.begin(), texts.end(), [](const std::string& text) { return !text.empty(); }); };
  if (areSaid(file.Names) || areSaid(file.Sticks))
  {
    lines.CellData.Add({ CellArray::FaultName, file.Names });
    lines.CellData.Add({ CellArray::FaultStick, file.Sticks });
  }
  return lines;
}
}

//----------------------------------------------------------------------------------------------------------------------
FaultLineData LoadFaultLines(const std::vector<std::string>& paths, const FaultTextOptions& options,
  std::optional<VerticalDirection> direction, const Monitor& monitor)
{
  FaultLineData data;
  FaultLineFile all;
  const bool areSeveral = paths.size() > 1;
  for (std::size_t n = 0; n < paths.size(); ++n)
  {
    const std::string& path = paths[n];
    FaultLineFile file = PrefixFileErrors(path.c_str(),
      [&]()
      {
        return ReadFaultLines(*OpenInputFile(path), options,
          monitor.Step(double(n) / double(paths.size()), double(n + 1) / double(paths.size())));
      });
    const bool isUp = file.IsUpright ||
      (!file.SaysDirection && (direction ? *direction == VerticalDirection::Up : AreNegative(file.Places)));
    data.Description +=
      (n > 0 ? "\n" : "") + (areSeveral ? StemOf(path) + ": " : std::string()) + DescribeLines(file, isUp);
    if (areSeveral)
    {
      NameLines(StemOf(path), file);
    }
    if (n == 0)
    {
      all.Survey = file.Survey;
      all.IsUpright = isUp;
    }
    const std::string &first = all.Survey.VerticalUnit, &own = file.Survey.VerticalUnit;
    if (!first.empty() && !own.empty() && first != own)
    {
      throw InputError(path + ": z in " + own + ", expected " + first + " as in " + paths.front());
    }
    Append(file, isUp, all);
  }
  data.Lines = MakeLines(all);
  AddValue<int>(data.Lines.FieldData, FieldArray::VerticalDirection,
    int(all.IsUpright ? VerticalDirection::Up : VerticalDirection::Down));
  AddSurveyFields(all.Survey, data.Lines.FieldData);
  return data;
}
}
