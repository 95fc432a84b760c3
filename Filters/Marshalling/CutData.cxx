// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CutData.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "HorizonData.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"

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
LatticeLink ReadLink(vtkDataArray* links, vtkIdType n, const std::array<int, 3>& dimensions)
{
  const std::array<double, 3> link = { links->GetComponent(n, 0), links->GetComponent(n, 1),
    links->GetComponent(n, 2) };
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
vtkDataArray* FindFaultedLinks(vtkFieldData* data)
{
  vtkDataArray* const links = FindNumbers(data, FieldArray::FaultedLinks);
  return links ? links : FindNumbers(data, FieldArray::OldFaultedLinks);
}

//----------------------------------------------------------------------------------------------------------------------
void RemoveFaultedLinks(vtkFieldData* data)
{
  for (const char* const name : { FieldArray::FaultedLinks, FieldArray::FaultThrow, FieldArray::FaultLine,
         FieldArray::OldFaultedLinks, FieldArray::OldFaultThrow, FieldArray::OldFaultLine })
  {
    data->RemoveArray(name);
  }
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<LatticeLink> ReadFaultedLinks(vtkDataObject* horizon)
{
  vtkDataArray* const array = FindFaultedLinks(horizon->GetFieldData());
  if (!array || array->GetNumberOfTuples() == 0)
  {
    return {};
  }
  if (array->GetNumberOfComponents() != 3)
  {
    throw InputError("field data array " + std::string(array->GetName()) + " with " +
      std::to_string(array->GetNumberOfComponents()) + " components, expected 3: i, j and the side");
  }
  const std::array<int, 3> dimensions = ReadLatticeDimensions(horizon);
  std::vector<LatticeLink> links;
  for (vtkIdType n = 0; n < array->GetNumberOfTuples(); ++n)
  {
    links.push_back(ReadLink(array, n, dimensions));
  }
  return links;
}

//----------------------------------------------------------------------------------------------------------------------
std::optional<LinkCuts> FindCuts(vtkDataObject* horizon, const PlaneBox& columns)
{
  std::vector<LatticeLink> links = ReadFaultedLinks(horizon);
  links.erase(std::remove_if(links.begin(), links.end(),
                [&columns](const LatticeLink& link) { return !columns.Contains(link.Column); }),
    links.end());
  return CutLinks(links);
}

//----------------------------------------------------------------------------------------------------------------------
std::shared_ptr<const LinkCuts> ShareCuts(vtkDataObject* horizon, const PlaneBox& columns)
{
  std::optional<LinkCuts> cuts = FindCuts(horizon, columns);
  return cuts ? std::make_shared<const LinkCuts>(std::move(*cuts)) : nullptr;
}

//----------------------------------------------------------------------------------------------------------------------
void WriteCuts(const FaultLines& lines, vtkFieldData* data)
{
  RemoveFaultedLinks(data);
  const std::vector<LinkOfLine> sorted = SortLinks(lines);
  auto links = NewArray<vtkIntArray>(FieldArray::FaultedLinks, vtkIdType(sorted.size()), 3);
  for (std::size_t n = 0; n < sorted.size(); ++n)
  {
    const LatticeLink& link = lines[sorted[n].Link].Place;
    const std::array<int, 3> tuple = { link.Column.X, link.Column.Y, int(link.Side) };
    links->SetTypedTuple(vtkIdType(n), tuple.data());
  }
  data->AddArray(links);
  AddArray<vtkDoubleArray>(
    data, FieldArray::FaultThrow, sorted, [&lines](const LinkOfLine& item) { return lines[item.Link].Throw; });
  AddArray<vtkIntArray>(data, FieldArray::FaultLine, sorted, [](const LinkOfLine& item) { return int(item.Line); });
}
}
