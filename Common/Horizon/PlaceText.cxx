// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlaceText.h"

#include <cmath>
#include <sstream>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
std::string PlaceText(const Eigen::Vector3d& world)
{
  std::ostringstream text;
  text.precision(10); // Coordinates of surveys are millions of metres.
  const double z = std::fabs(world.z());
  text << '(' << world.x() << ", " << world.y() << ") and " << z;
  if (z > 0.0)
  {
    text << (world.z() < 0.0 ? " down" : " up");
  }
  return text.str();
}
}
