// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LedgerFields.h"

#include "DataModel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace SeismicHorizons
{
namespace
{
template <typename T>
void AddEntries(ArrayTable& data, const char* name, const std::array<T, LedgerEntries>& values)
{
  AddTuple<T>(data, name, values).ComponentNames.assign(LedgerNames.begin(), LedgerNames.end());
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<unsigned char> ReadFilled(const Horizon& points)
{
  std::vector<unsigned char> filled;
  if (const DataArray* const array = points.PointData.Find(PointArray::Filled))
  {
    filled.resize(std::size_t(array->Tuples()));
    for (std::size_t point = 0; point < filled.size(); ++point)
    {
      const double value = array->At(std::int64_t(point));
      filled[point] = value >= 1.5 ? 2 : value >= 0.5 ? 1 : 0; // nan counts as not filled.
    }
  }
  return filled;
}

//----------------------------------------------------------------------------------------------------------------------
Ledger CountPoints(const Horizon& points)
{
  Ledger ledger;
  ledger[LedgerEntry::Known] = points.NumberOfPoints();
  for (const unsigned char filled : ReadFilled(points))
  {
    --ledger[LedgerEntry::Known];
    ++ledger[EntryOf(filled)];
  }
  return ledger;
}

//----------------------------------------------------------------------------------------------------------------------
std::optional<Ledger> ReadLedger(const ArrayTable& data)
{
  const DataArray* const array = data.Find(FieldArray::LedgerColumns);
  if (!array || array->Size() != std::int64_t(LedgerEntries))
  {
    return std::nullopt;
  }
  Ledger ledger;
  for (std::size_t entry = 0; entry < LedgerEntries; ++entry)
  {
    ledger.Columns[entry] = std::int64_t(array->Value(std::int64_t(entry)));
  }
  return ledger;
}

//----------------------------------------------------------------------------------------------------------------------
void WriteLedger(const Ledger& ledger, ArrayTable& data)
{
  AddEntries<std::int64_t>(data, FieldArray::LedgerColumns, ledger.Columns);
  const DataArray* const map = data.Find(FieldArray::LatticeToWorld);
  if (map && map->Size() == 16)
  {
    const double bin = std::abs(map->Value(0) * map->Value(5) - map->Value(1) * map->Value(4));
    std::array<double, LedgerEntries> areas;
    std::transform(ledger.Columns.begin(), ledger.Columns.end(), areas.begin(),
      [bin](std::int64_t columns) { return double(columns) * bin; });
    AddEntries<double>(data, FieldArray::LedgerArea, areas);
  }
}
}
