// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LedgerOutput.h"

#include "Common/Horizon/DataModel.h"
#include "Common/Horizon/LedgerFields.h"
#include "HorizonPoints.h"

#include <algorithm>
#include <optional>

namespace SeismicHorizons
{
namespace
{
/// Counts columns that were read, but are not among the points.
std::int64_t CountLeftOut(const std::optional<Ledger>& before, const Ledger& points)
{
  return before ? std::max<std::int64_t>(0, before->Read() - points[LedgerEntry::Known]) : 0;
}
}

//----------------------------------------------------------------------------------------------------------------------
void PointLedger::Add(const Horizon& points, PlanePoints columns, const KeptPoints& kept)
{
  this->Counted.Add(this->Covered.Account(columns, ReadFilled(points), kept));
  this->Points.Add(CountPoints(points));
  if (const std::optional<Ledger> given = ReadLedger(points.FieldData))
  {
    this->Given = this->Given.value_or(Ledger());
    this->Given->Add(*given);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void PointLedger::Write(ArrayTable& figures) const
{
  Ledger ledger = this->Counted;
  this->Covered.Bridge(ledger);
  ledger[LedgerEntry::LeftOut] += CountLeftOut(this->Given, this->Points);
  WriteLedger(ledger, figures);
}

//----------------------------------------------------------------------------------------------------------------------
void WriteLedger(const LatticePoints& points, const KeptPoints& kept, const CoveredColumns& covered, Horizon& output)
{
  const ArrayTable& given = points.Horizon.FieldData;
  std::optional<Ledger> ledger = ReadLedger(given);
  if (!points.AreMerged && !given.Has(FieldArray::BoundaryDeviation))
  {
    PointLedger all(covered);
    all.Add(points.Horizon, points.Column, kept);
    all.Write(output.FieldData);
  }
  else if (ledger)
  {
    ledger->CoverOnly(covered.Count());
    WriteLedger(*ledger, output.FieldData);
  }
}

//----------------------------------------------------------------------------------------------------------------------
void WriteLedgerOfPoints(const Horizon& input, Horizon& output)
{
  const DataArray* const own = output.FieldData.Find(FieldArray::LedgerColumns);
  const DataArray* const given = input.FieldData.Find(FieldArray::LedgerColumns);
  const bool isOfStage = own && given ? !own->IsCopyOf(*given) : own != given;
  if (!isOfStage && output.Lines.Size() == 0 && output.Polygons.Size() == 0)
  {
    const Ledger visible = CountPoints(WithoutHiddenPoints(input));
    Ledger ledger = CountPoints(output);
    const std::int64_t read = visible[LedgerEntry::Known] + CountLeftOut(ReadLedger(input.FieldData), visible);
    ledger[LedgerEntry::LeftOut] = std::max<std::int64_t>(0, read - ledger[LedgerEntry::Known]);
    WriteLedger(ledger, output.FieldData);
  }
}
}
