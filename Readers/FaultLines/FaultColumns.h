// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the columns of a table of fault lines are: named by the user or above the numbers, or else recognised by their
// values. Headers, separators and decimal commas are those of picks (Readers/HorizonText).

#ifndef SeismicHorizonsFaultColumns_h
#define SeismicHorizonsFaultColumns_h

#include "Common/Text/FieldSeparator.h"
#include "Readers/HorizonText/TextHeader.h"

#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
enum class FaultRole
{
  Ignored,
  X,
  Y,
  Z,
  Fault, ///< the name or number of the fault
  Stick, ///< equal along a line
  Node ///< grows along a line
};

struct FaultTextOptions
{
  std::string Columns; // names or roles, as of picks; empty to detect them
  std::string NullValues; // of z; points with these are left out
  int HeaderLines = 0; // skipped before any other header
};

struct FaultColumns
{
  FieldSeparator Separator = FieldSeparator::Blanks;
  std::vector<FaultRole> Roles; // of each field
  /// Fields after z are a name with blanks, and perhaps a number of the stick.
  bool EndInName = false;
  bool HasDecimalCommas = false;
  bool IsUpright = false; // z is an elevation by its name.
  bool SaysFaults = false; // A name of a column has the word fault or stick.
  std::int64_t HeaderLines = 0; // lines before the first point
  SurveyDescription Survey;

  int Find(FaultRole role) const;
  std::string Describe() const;
};

/// The lines are the beginning of a file, without those of other formats. Throws InputError if z or the place is
/// missing, or a list of columns does not fit.
FaultColumns FindFaultColumns(const TextLines& lines, const FaultTextOptions& options);

/// The mark of IRAP: three times 999.
bool IsEndOfPart(std::string_view line);

/// True for lines between fault lines: empty ones, ends of parts of IRAP, "->name" and ">".
bool SeparatesFaultLines(std::string_view line);
}

#endif
