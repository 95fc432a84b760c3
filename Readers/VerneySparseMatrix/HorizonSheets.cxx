// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "HorizonSheets.h"

#include "Common/ColumnSheets.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace SeismicHorizons
{
namespace
{
void CopyVoxel(const HorizonVoxels& from, std::size_t voxel, HorizonVoxels& to)
{
  to.I.push_back(from.I[voxel]);
  to.J.push_back(from.J[voxel]);
  to.K.push_back(from.K[voxel]);
  to.Thickness.push_back(from.Thickness[voxel]);
  to.Amplitude.push_back(from.Amplitude[voxel]);
  to.RealZ.push_back(from.RealZ[voxel]);
}
}

//----------------------------------------------------------------------------------------------------------------------
std::vector<HorizonVoxels> SplitIntoSheets(HorizonVoxels voxels)
{
  const std::vector<int> sheetOf =
    FindSheets(voxels.I.begin(), voxels.J.begin(), std::vector<double>(voxels.K.begin(), voxels.K.end()));
  std::vector<HorizonVoxels> sheets;
  if (std::all_of(sheetOf.begin(), sheetOf.end(), [](int sheet) { return sheet == 0; }))
  {
    sheets.push_back(std::move(voxels));
    return sheets;
  }
  sheets.resize(std::size_t(*std::max_element(sheetOf.begin(), sheetOf.end())) + 1);
  for (HorizonVoxels& sheet : sheets)
  {
    sheet.SurfaceId = voxels.SurfaceId;
  }
  for (std::size_t voxel = 0; voxel < sheetOf.size(); ++voxel)
  {
    if (sheetOf[voxel] < 0)
    {
      ++sheets.front().DroppedDuplicates;
    }
    else
    {
      CopyVoxel(voxels, voxel, sheets[std::size_t(sheetOf[voxel])]);
    }
  }
  return sheets;
}
}
