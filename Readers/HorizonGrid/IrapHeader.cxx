// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "IrapHeader.h"

#include "Common/Base/Errors.h"
#include "Common/Text/TextNumbers.h"
#include "GridLayout.h"
#include "HeaderFields.h"

#include <cmath>
#include <string>

namespace SeismicHorizons
{
namespace
{

std::string PlaceText(const Eigen::Vector2d& place)
{
  return '(' + ShortestText(place.x()) + ", " + ShortestText(place.y()) + ')';
}
}

//----------------------------------------------------------------------------------------------------------------------
SurveyLattice IrapLattice(const IrapHeader& header)
{
  const double step = std::min(std::fabs(header.Steps[0]), std::fabs(header.Steps[1]));
  if (header.Degrees != 0.0 && (header.Centre - header.Origin).cwiseAbs().maxCoeff() > LargestNodeShift * step)
  {
    throw InputError(
      "a rotation around " + PlaceText(header.Centre) + ", expected the origin, " + PlaceText(header.Origin));
  }
  return TurnedLattice(header.Columns, header.Origin, header.Steps, header.Degrees);
}
}
