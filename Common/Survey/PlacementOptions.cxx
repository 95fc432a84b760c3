// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlacementOptions.h"

#include "Common/Base/Errors.h"

#include <cmath>
#include <sstream>

namespace SeismicHorizons
{
namespace
{
void CheckCorner(const CornerPoint& corner)
{
  const Eigen::Vector4d numbers(corner.Inline, corner.Crossline, corner.X, corner.Y);
  if (!numbers.allFinite())
  {
    throw InputError("corner point " + ToText(numbers) + ", expected finite numbers");
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
void CheckPlacement(const PlacementOptions& options)
{
  if (!(options.Tolerance > 0.0 && options.Tolerance < 0.5))
  {
    std::ostringstream text;
    text << "LatticeTolerance " << options.Tolerance << ", expected more than 0 and less than 0.5 columns";
    throw InputError(text.str());
  }
  if (options.Source == LatticeSource::CornerPoints)
  {
    for (const CornerPoint& corner : options.Corners)
    {
      CheckCorner(corner);
    }
  }
  if (options.Source == LatticeSource::OriginAndSteps)
  {
    LatticeFrame frame;
    frame.Lattice.Origin = options.Origin;
    frame.Lattice.ColumnStep = options.ColumnStep;
    frame.Lattice.RowStep = options.RowStep;
    frame.Check();
  }
}
}
