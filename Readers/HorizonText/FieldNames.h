// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsFieldNames_h
#define SeismicHorizonsFieldNames_h

#include "TextLayout.h"

#include <string>
#include <string_view>
#include <vector>

namespace SeismicHorizons
{
/// Recognises names above fields: "Easting (m)" is X, "IL" an inline, "Depth" a z. Any other name is an attribute.
TextColumn ColumnOfName(std::string_view name);

/// Returns "ms" for "TWT (ms)" and "TWT_ms", "m" for "X [m]".
std::string_view UnitOfName(std::string_view name);

/// Returns "time", "depth" or an empty text.
std::string_view DomainOfName(std::string_view name);

/// Names are separated by commas, or else by blanks; "-" ignores a field. Throws InputError if a role is repeated, or z
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
