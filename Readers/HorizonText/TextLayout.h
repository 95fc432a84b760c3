// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsTextLayout_h
#define SeismicHorizonsTextLayout_h

#include "Common/Survey/FieldRole.h"
#include "Common/Survey/NullValues.h"
#include "Common/Survey/SurveyDescription.h"
#include "Common/Text/FieldSeparator.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace SeismicHorizons
{
struct TextColumn
{
  FieldRole Role = FieldRole::Ignored;
  std::string Name;
};

enum class TextKind
{
  Plain,
  OpendTect,
  OpenWorks,
  EarthVision,
  PetrelPoints,
  RmsAttributes,
  Charisma,
  LatticeIndices, ///< A line "nx ny n", then n lines "i j z".
  Iesx, ///< Fields have fixed positions.
  Matrix, ///< Rows of heights alone.
  VSet ///< Points of GOCAD.
};

struct TextLayout
{
  TextKind Kind = TextKind::Plain;
  FieldSeparator Separator = FieldSeparator::Blanks;
  std::vector<TextColumn> Columns;
  int WhereColumn = -1; // Lines with other values in this column are left out; -1 for none.
  std::string WhereValue;
  bool HasLineOfNames = false; // A line of words that is not a comment precedes the picks.
  /// Lines from the names to the picks. Concatenated files repeat them, and they are skipped.
  std::vector<std::string> NamesLines;
  std::vector<std::string> Units; // Stated apart from the names, one for each.
  std::string Doubt; // warning about guessed fields
  bool HasDecimalCommas = false;
  bool IsGuessed = false; // Fields are known by their values alone.
  std::int64_t HeaderLines = 0; // lines before the first pick
  std::int64_t Picks = -1; // Number stated in the header, or -1.
  std::string HorizonName;
  SurveyDescription Survey;
  NullValues Nulls;
  bool AreNullsUsual = false; // The user did not choose them.

  int Find(FieldRole role) const;

  /// Reads "COLUMN=VALUE" with the name of one of the columns. Throws InputError if there is no such column.
  void ChooseLines(const std::string& where, const std::vector<TextColumn>& columns);

  bool IsChosen(std::string_view line) const;

  /// Fields behind the last one that is used may be missing.
  std::size_t CountUsed(bool withAttributes = true) const;

  bool HasPlaces() const
  {
    return (this->Find(FieldRole::X) >= 0 && this->Find(FieldRole::Y) >= 0) ||
      (this->Find(FieldRole::Inline) >= 0 && this->Find(FieldRole::Crossline) >= 0);
  }

  bool HasNames() const
  {
    return this->Kind == TextKind::Iesx || this->Kind == TextKind::VSet || this->Find(FieldRole::HorizonName) >= 0;
  }

  std::string Describe(std::int64_t otherLines = 0) const;
};

// ---- Names of fields ---------------------------------------------------------------------------------------------
/// Recognises names above fields: "Easting (m)" is X, "IL" an inline, "Depth" a z. Any other name is an attribute.
TextColumn ColumnOfName(std::string_view name);

/// Returns "ms" for "TWT (ms)" and "TWT_ms", "m" for "X [m]".
std::string_view UnitOfName(std::string_view name);

/// Returns "time", "depth" or an empty text.
std::string_view DomainOfName(std::string_view name);

/// Sets the unit and domain of z, unless they are known, by its name, or by a unit that is given apart from it.
void DescribeZ(SurveyDescription& survey, std::string_view name, std::string_view unit = {});

/// Names are separated by commas, or else by blanks; "-" or "_" ignores a field. Throws InputError if a role is repeated, or z
/// or the place is missing.
std::vector<TextColumn> ParseColumnList(const std::string& list);

/// The first field of a role keeps it; others become attributes with unique names. Without z the first attribute
/// becomes z. x without y and inline without crossline become attributes.
void SettleRoles(std::vector<TextColumn>& columns);

/// Throws InputError if z or the place is missing.
void CheckRoles(const std::vector<TextColumn>& columns);

std::string ListNames(const std::vector<TextColumn>& columns);
}

#endif
