// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkVerneySparseMatrixWriter.h"

#include "Common/Base/Errors.h"
#include "Common/Base/Monitor.h"
#include "Common/Horizon/DataModel.h"
#include "Common/VTK/DataArrays.h"
#include "HorizonMatrix.h"
#include "SparseMatrixPrinter.h"
#include "Writers/HorizonSampling.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <optional>
#include <set>
#include <sstream>

using namespace SeismicHorizons;

namespace
{
std::string ToText(const SparseMatrixSize& size)
{
  return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]);
}

int TakeFreeId(std::set<int>& ids)
{
  int id = 1;
  while (!ids.insert(id).second)
  {
    ++id;
  }
  return id;
}
}

vtkStandardNewMacro(vtkVerneySparseMatrixWriter);

//----------------------------------------------------------------------------------------------------------------------
void vtkVerneySparseMatrixWriter::PrintHorizons(
  const std::vector<NamedHorizon>& horizons, std::ostream& stream, const Monitor& monitor)
{
  SparseMatrix matrix;
  std::vector<std::optional<int>> given;
  std::set<int> ids;
  bool isUp = false;
  for (const NamedHorizon& horizon : horizons)
  {
    PrefixErrors(horizon.Name,
      [&]()
      {
        const SparseMatrixSize size = ReadMatrixSize(horizon.Data);
        CountColumns(size[0], size[1], horizon.Data->GetNumberOfPoints());
        matrix.Size = given.empty() ? size : matrix.Size;
        const std::array<double, 2> scale = ReadVerticalScale(horizon.Data);
        const std::array<double, 2> first = ReadVerticalScale(horizons.front().Data);
        if (scale != first)
        {
          std::ostringstream text;
          text << "vertical indices from " << scale[0] << " in steps of " << scale[1] << ", expected from " << first[0]
               << " in steps of " << first[1] << " as in " << horizons.front().Name
               << "; with VerticalStep, readers give all horizons the same";
          throw InputError(text.str());
        }
        if (size != matrix.Size)
        {
          throw InputError("a lattice of " + ToText(size) + " cells, expected " + ToText(matrix.Size) + " as in " +
            horizons.front().Name);
        }
        isUp = isUp || FirstValue(horizon.Data->GetFieldData(), FieldArray::VerticalDirection) > 0.0;
        given.push_back(ReadSurfaceId(horizon.Data));
        if (given.back())
        {
          ids.insert(*given.back());
        }
      });
  }
  for (std::size_t n = 0; n < horizons.size(); ++n)
  {
    monitor.Progress(0.5 * static_cast<double>(n) / static_cast<double>(horizons.size()));
    const int id = given[n] ? *given[n] : TakeFreeId(ids);
    PrefixErrors(horizons[n].Name, [&]() { matrix.Horizons.push_back(ReadVoxels(horizons[n].Data, id)); });
  }
  if (isUp)
  {
    vtkWarningMacro("elevations, which the format cannot tell from depths: read them with VerticalDirection Up");
  }
  PrintSparseMatrix(matrix, stream, monitor.Step(0.5, 1.0));
}
