// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsTextLayout_h
#define SeismicHorizonsTextLayout_h

#include "Common/FieldSeparator.h"
#include "Common/Survey/ColumnRole.h"
#include "Common/Survey/NullValues.h"
#include "Common/Survey/SurveyDescription.h"

#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
struct TextColumn
{
  ColumnRole Role = ColumnRole::Ignored;
  std::string Name; // as the file has it
};

/// The kinds of files, by what writes them.
enum class TextKind
{
  Plain, ///< lines of columns, with or without names over them
  OpendTect,
  OpenWorks,
  EarthVision,
  PetrelPoints,
  RmsAttributes,
  Charisma,
  LatticeIndices, ///< a line "nx ny n", then n lines "i j z"
  Iesx ///< columns are places in the line, not fields
};

/// How a file of picks is to be read.
struct TextLayout
{
  TextKind Kind = TextKind::Plain;
  FieldSeparator Separator = FieldSeparator::Blanks;
  std::vector<TextColumn> Columns;
  bool HasLineOfNames = false; // a line of words, which is no comment, stands right above the picks
  /// That line, and those up to the picks, as with units; where they come again, as in files that were put together,
  /// they are left out.
  std::vector<std::string> NamesLines;
  std::string Doubt; // what users should know of columns that were guessed
  bool HasDecimalCommas = false; // in place of points
  bool IsGuessed = false; // the columns are known by their values alone
  std::int64_t HeaderLines = 0; // before the first pick
  std::int64_t Picks = -1; // how many a file says it has; -1 where it says nothing
  std::string HorizonName; // of the whole file; empty where there is none
  SurveyDescription Survey;
  NullValues Nulls;

  /// The number of the column with a role, or -1.
  int Find(ColumnRole role) const;

  /// Whether columns say where picks are.
  bool HasPlaces() const
  {
    return (this->Find(ColumnRole::X) >= 0 && this->Find(ColumnRole::Y) >= 0) ||
      (this->Find(ColumnRole::Inline) >= 0 && this->Find(ColumnRole::Crossline) >= 0);
  }

  /// Whether picks come with the names of their horizons.
  bool HasNames() const { return this->Kind == TextKind::Iesx || this->Find(ColumnRole::HorizonName) >= 0; }

  /// For people: "OpendTect, separated by tabs: Inline, Crossline, Z, Amplitude".
  std::string Describe() const;
};
}

#endif
