// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkLatticeHorizonWriter.h"

#include "Writers/HorizonSampling.h"

//----------------------------------------------------------------------------------------------------------------------
SeismicHorizons::WrittenSense vtkLatticeHorizonWriter::Sense() const
{
  return static_cast<SeismicHorizons::WrittenSense>(this->VerticalPositive);
}
