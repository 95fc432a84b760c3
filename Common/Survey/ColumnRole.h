// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsColumnRole_h
#define SeismicHorizonsColumnRole_h

#include <string_view>

namespace SeismicHorizons
{
/// What a column of a table holds.
enum class ColumnRole
{
  X,
  Y,
  Z,
  Inline,
  Crossline,
  HorizonName,
  Attribute,
  Ignored
};

/// The word for a role, as users write it: "X", "Inline", "Name"; "-" for what is ignored.
const char* RoleWord(ColumnRole role);

/// The role of a column by its name, as programs write it over a column: that of "Easting (m)" is X, of "IL" Inline, of
/// "Depth" Z, of "-" Ignored, and of anything else Attribute.
ColumnRole RoleOfName(std::string_view name);
}

#endif
