// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the columns of a table hold, by their names.

#ifndef SeismicHorizonsColumnNames_h
#define SeismicHorizonsColumnNames_h

#include "TextLayout.h"

#include <string>
#include <string_view>
#include <vector>

namespace SeismicHorizons
{
/// The column of a name as programs write it over a column: "Easting (m)" is X, "IL" an inline, "Depth" a z. Any other
/// is that of an attribute.
TextColumn ColumnOfName(std::string_view name);

/// The unit of length or time that a name ends with: "ms" of "TWT (ms)" and "TWT_ms", "m" of "X [m]". Empty without
/// one.
std::string_view UnitOfName(std::string_view name);

/// "time" of "TWT" or "Time", "depth" of "TVDSS" or "Depth"; else empty.
std::string_view DomainOfName(std::string_view name);

/// The columns that a user names, separated by commas, or where there is none by blanks; "-" leaves one out. Throws
/// InputError where a role is there twice, and where z or the place is missing.
std::vector<TextColumn> ParseColumnList(const std::string& list);

/// Makes columns complete and free of doubles: of several of one role the first has it, and the others become
/// attributes, whose names get a number where they are the same; where there is no z, the first attribute is it; x
/// without y, and an inline without crossline, are attributes.
void SettleRoles(std::vector<TextColumn>& columns);

/// Throws InputError where z or the place is missing; the message names the columns there are.
void CheckRoles(const std::vector<TextColumn>& columns);

/// "X, Y, Z, Amplitude".
std::string ListNames(const std::vector<TextColumn>& columns);
}

#endif
