// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsCutoffOutput_h
#define SeismicHorizonsCutoffOutput_h

#include "Common/Horizon/Horizon.h"
#include "CutoffStage.h"

#include <string>
#include <vector>

namespace SeismicHorizons
{
struct CutoffStageResult
{
  std::vector<std::string> FaultNames;
  std::vector<Horizon> Cutoffs; // by horizon
  std::vector<Horizon> Polygons; // by horizon
  Horizon Faults;
  Horizon Juxtaposition;
  Horizon Diagrams; // side by side: distance along strike, and height
  ArrayTable Figures; // a row per horizon and fault that cuts it
  ArrayTable Areas; // a row per fault and pair of layers
  std::string Report;
};

/// `fields` is the field data of all outputs.
CutoffStageResult WriteCutoffs(const CutoffModelData& model, const ArrayTable& fields);
}

#endif
