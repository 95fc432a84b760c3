// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LedgerFields.h"

#include "Common/Horizon/DataModel.h"
#include "DataArrays.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace SeismicHorizons
{
namespace
{
void NameEntries(vtkFieldData* data, const char* name)
{
  for (std::size_t entry = 0; entry < LedgerEntries; ++entry)
  {
    data->GetAbstractArray(name)->SetComponentName(vtkIdType(entry), LedgerNames[entry]);
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<unsigned char> ReadFilled(vtkPolyData* points)
{
  std::vector<unsigned char> filled;
  if (vtkDataArray* const array = points->GetPointData()->GetArray(PointArray::Filled))
  {
    filled.resize(std::size_t(array->GetNumberOfTuples()));
    for (std::size_t point = 0; point < filled.size(); ++point)
    {
      const double value = array->GetComponent(vtkIdType(point), 0);
      filled[point] = value >= 1.5 ? 2 : value >= 0.5 ? 1 : 0; // nan counts as not filled.
    }
  }
  return filled;
}

//----------------------------------------------------------------------------------------------------------------------
Ledger CountPoints(vtkPolyData* points)
{
  Ledger ledger;
  ledger[LedgerEntry::Known] = points->GetNumberOfPoints();
  for (const unsigned char filled : ReadFilled(points))
  {
    --ledger[LedgerEntry::Known];
    ++ledger[EntryOf(filled)];
  }
  return ledger;
}

//----------------------------------------------------------------------------------------------------------------------
std::optional<Ledger> ReadLedger(vtkFieldData* data)
{
  vtkDataArray* const array = data->GetArray(FieldArray::LedgerColumns);
  if (!array || array->GetNumberOfValues() != vtkIdType(LedgerEntries))
  {
    return std::nullopt;
  }
  Ledger ledger;
  for (std::size_t entry = 0; entry < LedgerEntries; ++entry)
  {
    ledger.Columns[entry] = std::int64_t(array->GetComponent(0, int(entry)));
  }
  return ledger;
}

//----------------------------------------------------------------------------------------------------------------------
void WriteLedger(const Ledger& ledger, vtkFieldData* data)
{
  AddTuple<vtkIdTypeArray>(data, FieldArray::LedgerColumns, ledger.Columns);
  NameEntries(data, FieldArray::LedgerColumns);
  vtkDataArray* const map = data->GetArray(FieldArray::LatticeToWorld);
  if (map && map->GetNumberOfValues() == 16)
  {
    const auto value = [map](int n)
    { return map->GetComponent(n / map->GetNumberOfComponents(), n % map->GetNumberOfComponents()); };
    const double bin = std::abs(value(0) * value(5) - value(1) * value(4));
    std::array<double, LedgerEntries> areas;
    std::transform(ledger.Columns.begin(), ledger.Columns.end(), areas.begin(),
      [bin](std::int64_t columns) { return double(columns) * bin; });
    AddTuple<vtkDoubleArray>(data, FieldArray::LedgerArea, areas);
    NameEntries(data, FieldArray::LedgerArea);
  }
}
}
