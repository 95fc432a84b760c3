// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LatticeFrame.h"

#include "Common/Base/Errors.h"
#include "Common/Horizon/Lattice.h"

#include <cmath>
#include <sstream>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
std::string ToText(const Eigen::VectorXd& vector)
{
  std::ostringstream text;
  text.precision(10); // Coordinates of surveys are millions of metres.
  for (Eigen::Index component = 0; component < vector.size(); ++component)
  {
    text << (component == 0 ? "(" : ", ") << vector[component];
  }
  text << ')';
  return text.str();
}

//----------------------------------------------------------------------------------------------------------------------
LatticeMatrix LatticeFrame::ToWorld() const
{
  const int sign = static_cast<int>(this->Direction);
  const auto& [columns, origin, columnStep, rowStep, lines] = this->Lattice;
  return { columnStep.x(), rowStep.x(), 0.0, origin.x(), //
    columnStep.y(), rowStep.y(), 0.0, origin.y(), //
    0.0, 0.0, sign * this->Sampling.Step, sign * this->Sampling.First, //
    0.0, 0.0, 0.0, 1.0 };
}

//----------------------------------------------------------------------------------------------------------------------
void LatticeFrame::Check() const
{
  const Eigen::Vector2d& columnStep = this->Lattice.ColumnStep;
  const Eigen::Vector2d& rowStep = this->Lattice.RowStep;
  const double z = static_cast<int>(this->Direction) * this->Sampling.First + 0.0; // Avoids -0.
  const Eigen::Vector3d origin(this->Lattice.Origin.x(), this->Lattice.Origin.y(), z);
  if (!origin.allFinite())
  {
    throw InputError("Origin " + ToText(origin) + ", expected finite numbers");
  }
  if (!columnStep.allFinite() || !rowStep.allFinite() || AreParallel(columnStep, rowStep))
  {
    throw InputError("ColumnStep " + ToText(columnStep) + " and RowStep " + ToText(rowStep) +
      ", expected finite vectors that are not parallel");
  }
  if (!std::isfinite(this->Sampling.Step) || this->Sampling.Step == 0.0)
  {
    throw InputError("VerticalStep " + ToText(Eigen::VectorXd::Constant(1, this->Sampling.Step)) +
      ", expected a finite number other than 0");
  }
}

//----------------------------------------------------------------------------------------------------------------------
LatticeFrame MakeLatticeFrame(
  const std::array<int, 3>& size, const Eigen::Matrix4d& toWorld, VerticalDirection direction)
{
  const int sign = static_cast<int>(direction);
  LatticeFrame frame;
  frame.Lattice.Columns = { size[0], size[1] };
  frame.Lattice.Origin = toWorld.block<2, 1>(0, 3);
  frame.Lattice.ColumnStep = toWorld.block<2, 1>(0, 0);
  frame.Lattice.RowStep = toWorld.block<2, 1>(0, 1);
  frame.Sampling = { sign * toWorld(2, 3), sign * toWorld(2, 2), size[2] };
  frame.Direction = direction;
  return frame;
}
}
