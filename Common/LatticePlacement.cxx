// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LatticePlacement.h"

#include "Errors.h"
#include "Lattice.h"

#include <cmath>
#include <sstream>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
std::string ToText(const Eigen::VectorXd& vector)
{
  std::ostringstream text;
  text.precision(10); // places of surveys are millions of metres
  for (Eigen::Index component = 0; component < vector.size(); ++component)
  {
    text << (component == 0 ? "(" : ", ") << vector[component];
  }
  text << ')';
  return text.str();
}

//----------------------------------------------------------------------------------------------------------------------
void LatticePlacement::Check() const
{
  if (!this->Origin.allFinite())
  {
    throw InputError("Origin " + ToText(this->Origin) + ", expected finite numbers");
  }
  if (!this->ColumnStep.allFinite() || !this->RowStep.allFinite() || AreParallel(this->ColumnStep, this->RowStep))
  {
    throw InputError("ColumnStep " + ToText(this->ColumnStep) + " and RowStep " + ToText(this->RowStep) +
      ", expected finite vectors that are not parallel");
  }
  if (!std::isfinite(this->VerticalStep) || this->VerticalStep == 0.0)
  {
    throw InputError("VerticalStep " + ToText(Eigen::VectorXd::Constant(1, this->VerticalStep)) +
      ", expected a finite number other than 0");
  }
}

//----------------------------------------------------------------------------------------------------------------------
LatticeMatrix LatticePlacement::ToWorld() const
{
  const double step = static_cast<int>(this->Direction) * this->VerticalStep;
  return { this->ColumnStep.x(), this->RowStep.x(), 0.0, this->Origin.x(), //
    this->ColumnStep.y(), this->RowStep.y(), 0.0, this->Origin.y(), //
    0.0, 0.0, step, this->Origin.z(), //
    0.0, 0.0, 0.0, 1.0 };
}
}
