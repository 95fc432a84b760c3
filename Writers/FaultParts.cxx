// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FaultParts.h"

#include "Common/Horizon/DataModel.h"

#include <algorithm>
#include <array>
#include <map>

namespace SeismicHorizons
{
namespace
{
Cells Take(const Cells& cells, std::int64_t before, const std::vector<std::int64_t>& chosen)
{
  HeapArray<std::int64_t> offsets = { 0 };
  HeapArray<std::int64_t> points;
  for (const std::int64_t number : chosen)
  {
    const std::int64_t cell = number - before;
    for (std::int64_t n = 0; cell >= 0 && cell < cells.Size() && n < cells.Length(cell); ++n)
    {
      points.push_back(cells.At(cell, n));
    }
    if (cell >= 0 && cell < cells.Size())
    {
      offsets.push_back(std::int64_t(points.size()));
    }
  }
  return { DataArray::Take(offsets), DataArray::Take(points) };
}

/// Names are those of the cells behind the given text.
Horizon TakeCells(const Horizon& all, const std::vector<std::int64_t>& chosen, const std::string& before)
{
  Horizon part = all;
  part.Vertices = Cells();
  part.Lines = Take(all.Lines, all.Vertices.Size(), chosen);
  part.Polygons = Take(all.Polygons, all.Vertices.Size() + all.Lines.Size(), chosen);
  part.CellData = ArrayTable();
  std::vector<std::string> names;
  std::vector<std::string> sticks;
  for (const std::int64_t cell : chosen)
  {
    names.push_back(before + TextOfCell(all, NamesOfLines(all), cell));
    sticks.push_back(TextOfCell(all, CellArray::FaultStick, cell));
  }
  part.CellData.Add({ CellArray::FaultName, std::move(names) });
  part.CellData.Add({ CellArray::FaultStick, std::move(sticks) });
  return part;
}
}

//----------------------------------------------------------------------------------------------------------------------
std::string TextOfCell(const Horizon& lines, const char* array, std::int64_t cell)
{
  const DataArray* const texts = lines.CellData.Find(array);
  return texts && texts->IsText() ? texts->Texts()[std::size_t(cell)] : std::string();
}

//----------------------------------------------------------------------------------------------------------------------
const char* NamesOfLines(const Horizon& lines)
{
  return lines.CellData.Has(CellArray::IndexContour) ? CellArray::Label : CellArray::FaultName;
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<NamedHorizon> SplitByFault(const std::vector<NamedHorizon>& all)
{
  std::vector<NamedHorizon> parts;
  for (const NamedHorizon& whole : all)
  {
    const DataArray* const names = whole.Data.CellData.Find(NamesOfLines(whole.Data));
    if (!names || !names->IsText())
    {
      parts.push_back(whole);
      continue;
    }
    std::vector<std::string> faults; // in the order of their first cells
    std::map<std::string, std::vector<std::int64_t>> cells;
    for (std::int64_t cell = whole.Data.Vertices.Size(); cell < whole.Data.NumberOfCells(); ++cell)
    {
      const std::string& fault = names->Texts()[std::size_t(cell)];
      std::vector<std::int64_t>& own = cells[fault];
      if (own.empty())
      {
        faults.push_back(fault);
      }
      own.push_back(cell);
    }
    // Levels are the same in all horizons, and a fault has cutoffs in each.
    const bool isOfHorizon =
      std::string(NamesOfLines(whole.Data)) == CellArray::Label || whole.Data.PointData.Has(PointArray::Heave);
    const bool isOfMany = all.size() > 1 && isOfHorizon;
    const std::string before = isOfMany ? whole.Name + " " : std::string();
    for (const std::string& fault : faults)
    {
      parts.push_back({ fault.empty() ? whole.Name : before + fault, TakeCells(whole.Data, cells[fault], before) });
    }
  }
  return parts;
}
}
