// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CutData.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataArray.h"
#include "Common/Horizon/DataModel.h"
#include "HorizonData.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace SeismicHorizons
{
namespace
{
LatticeLink ReadLink(const DataArray* const links, std::int64_t n, const std::array<int, 3>& dimensions)
{
  const std::array<double, 3> link = { links->At(n, 0), links->At(n, 1), links->At(n, 2) };
  const std::array<int, 3> end = { dimensions[0], dimensions[1], 2 };
  for (std::size_t component = 0; component < link.size(); ++component)
  {
    const double value = link[component];
    if (!(value >= 0.0 && value < end[component] && value == double(int(value))))
    {
      std::ostringstream text;
      text << "faulted link " << n << " (" << link[0] << ", " << link[1] << ", " << link[2]
           << "), expected a column of the lattice, i from 0 to " << end[0] - 1 << " and j from 0 to " << end[1] - 1
           << ", and a side, 0 or 1";
      throw InputError(text.str());
    }
  }
  return { { std::int32_t(link[0]), std::int32_t(link[1]) }, link[2] == 1.0 ? LinkSide::North : LinkSide::East };
}
}

//----------------------------------------------------------------------------------------------------------------------
const DataArray* FindFaultedLinks(const ArrayTable& data)
{
  const DataArray* const links = FindNumbers(data, FieldArray::FaultedLinks);
  return links ? links : FindNumbers(data, FieldArray::OldFaultedLinks);
}

//----------------------------------------------------------------------------------------------------------------------
void RemoveFaultedLinks(ArrayTable& data)
{
  for (const char* const name : { FieldArray::FaultedLinks, FieldArray::FaultThrow, FieldArray::FaultLine,
         FieldArray::FaultNames, FieldArray::OldFaultedLinks, FieldArray::OldFaultThrow, FieldArray::OldFaultLine })
  {
    data.Remove(name);
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<LatticeLink> ReadFaultedLinks(const Horizon& horizon)
{
  const DataArray* const array = FindFaultedLinks(horizon.FieldData);
  if (!array || array->Tuples() == 0)
  {
    return {};
  }
  if (array->Components() != 3)
  {
    throw InputError("field data array " + array->Name + " with " + std::to_string(array->Components()) +
      " components, expected 3: i, j and the side");
  }
  const std::array<int, 3> dimensions = ReadLatticeDimensions(horizon);
  std::vector<LatticeLink> links;
  for (std::int64_t n = 0; n < array->Tuples(); ++n)
  {
    links.push_back(ReadLink(array, n, dimensions));
  }
  return links;
}

//----------------------------------------------------------------------------------------------------------------------
std::optional<LinkCuts> FindCuts(const Horizon& horizon, const PlaneBox& columns)
{
  std::vector<LatticeLink> links = ReadFaultedLinks(horizon);
  links.erase(std::remove_if(links.begin(), links.end(),
                [&columns](const LatticeLink& link) { return !columns.Contains(link.Column); }),
    links.end());
  return CutLinks(links);
}

//----------------------------------------------------------------------------------------------------------------------
std::shared_ptr<const LinkCuts> ShareCuts(const Horizon& horizon, const PlaneBox& columns)
{
  std::optional<LinkCuts> cuts = FindCuts(horizon, columns);
  return cuts ? std::make_shared<const LinkCuts>(std::move(*cuts)) : nullptr;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<std::string> NamesOf(const FaultLines& lines)
{
  std::vector<std::string> names;
  for (std::size_t line = 0; line < lines.Size(); ++line)
  {
    names.push_back(lines.Fault(line).empty() ? "fault " + std::to_string(line + 1) : lines.Fault(line));
  }
  return names;
}

//----------------------------------------------------------------------------------------------------------------------
void WriteCuts(const FaultLines& lines, ArrayTable& data)
{
  RemoveFaultedLinks(data);
  const std::vector<LinkOfLine> sorted = SortLinks(lines);
  DataArray links = NewArray<int>(FieldArray::FaultedLinks, std::int64_t(sorted.size()), 3);
  for (std::size_t n = 0; n < sorted.size(); ++n)
  {
    const LatticeLink& link = lines[sorted[n].Link].Place;
    const std::array<int, 3> tuple = { link.Column.X, link.Column.Y, int(link.Side) };
    std::copy(tuple.begin(), tuple.end(), links.As<int>() + 3 * n);
  }
  data.Add(std::move(links));
  AddArray<double>(
    data, FieldArray::FaultThrow, sorted, [&lines](const LinkOfLine& item) { return lines[item.Link].Throw; });
  AddArray<int>(data, FieldArray::FaultLine, sorted, [](const LinkOfLine& item) { return int(item.Line); });
  data.Add({ FieldArray::FaultNames, NamesOf(lines) });
}
}
