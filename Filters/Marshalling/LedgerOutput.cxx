// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LedgerOutput.h"

#include "Common/Horizon/DataModel.h"
#include "Common/VTK/LedgerFields.h"
#include "HorizonPoints.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"

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
void WriteLedger(
  const LatticePoints& points, const KeptPoints& kept, const CoveredColumns& covered, vtkPolyData* output)
{
  vtkFieldData* const given = points.Horizon->GetFieldData();
  std::optional<Ledger> ledger = ReadLedger(given);
  if (!points.AreMerged && !given->HasArray(FieldArray::BoundaryDeviation))
  {
    // The ledger of a part may be of the whole horizon.
    const std::int64_t before = covered.ArePart() ? 0 : CountLeftOut(ledger, CountPoints(points.Horizon));
    ledger = covered.Account(points.Column, ReadFilled(points.Horizon), kept);
    (*ledger)[LedgerEntry::LeftOut] += before;
  }
  else if (ledger)
  {
    ledger->CoverOnly(covered.Count());
  }
  if (ledger)
  {
    WriteLedger(*ledger, output->GetFieldData());
  }
}

//----------------------------------------------------------------------------------------------------------------------
void WriteLedgerOfPoints(vtkPolyData* input, vtkPolyData* output)
{
  const char* const name = FieldArray::LedgerColumns;
  const bool isOfStage = output->GetFieldData()->GetArray(name) != input->GetFieldData()->GetArray(name);
  if (!isOfStage && output->GetNumberOfLines() == 0 && output->GetNumberOfPolys() == 0)
  {
    const Ledger visible = CountPoints(WithoutHiddenPoints(input));
    Ledger ledger = CountPoints(output);
    const std::int64_t read = visible[LedgerEntry::Known] + CountLeftOut(ReadLedger(input->GetFieldData()), visible);
    ledger[LedgerEntry::LeftOut] = std::max<std::int64_t>(0, read - ledger[LedgerEntry::Known]);
    WriteLedger(ledger, output->GetFieldData());
  }
}
}
