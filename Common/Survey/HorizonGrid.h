// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsHorizonGrid_h
#define SeismicHorizonsHorizonGrid_h

#include "ColumnTiles.h"
#include "PickTable.h"
#include "SurveyDescription.h"
#include "SurveyLattice.h"

#include <string>
#include <vector>

namespace SeismicHorizons
{
struct HorizonGrid
{
  std::string Name;
  std::string Format;
  SurveyDescription Survey;
  SurveyLattice Lattice;
  std::vector<double> Z; // Z of column (i, j) at i + j * Columns[0], in the unit and with the sign of the file, or nan.
  std::vector<PickAttribute> Attributes;
};

/// A sparse horizon on a lattice.
struct HorizonColumns
{
  std::string Name;
  SurveyDescription Survey;
  SurveyLattice Lattice;
  ColumnTiles Tiles;
  std::vector<double> Z; // Indexed by ColumnTiles, or nan.
  std::vector<PickAttribute> Attributes;
};
}

#endif
