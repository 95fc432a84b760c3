// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsGxfHeader_h
#define SeismicHorizonsGxfHeader_h

#include "Common/Survey/HorizonGrid.h"
#include "GridLayout.h"
#include "GridText.h"

#include <map>
#include <string>

namespace SeismicHorizons
{
struct GxfHeader
{
  std::string Name;
  SurveyDescription Survey;
  SurveyLattice Lattice;
  StorageOrder Order;
  NullRule IsNull;
  int GroupSize = 0; // Characters of a compressed value; 0 for plain numbers.
  double Scale = 1.0;
  double Offset = 0.0;
};

GxfHeader ReadGxfHeader(GridText& text);
}

#endif
