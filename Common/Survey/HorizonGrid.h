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
/// A horizon with a z for each column of a lattice, as gridding programs have it.
struct HorizonGrid
{
  std::string Name; // empty where there is none
  std::string Format; // of its file, for people; empty where there is none
  SurveyDescription Survey;
  SurveyLattice Lattice;
  std::vector<double> Z; // of column (i, j) at i + j * Columns[0], in the file's unit and sign; nan where there is none
  std::vector<PickAttribute> Attributes; // in the same order
};

/// A horizon with a z for some columns of a lattice, which may be few of many.
struct HorizonColumns
{
  std::string Name;
  SurveyDescription Survey;
  SurveyLattice Lattice;
  ColumnTiles Tiles;
  std::vector<double> Z; // by place in the tiles, nan where there is none
  std::vector<PickAttribute> Attributes; // in the same order
};
}

#endif
