// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsColumnRole_h
#define SeismicHorizonsColumnRole_h

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

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
/// "Depth" Z, of "-" Ignored. Otherwise its words tell: "HORIZON_TWT" is Z, "POINT_X" X, "Formation" the name of a
/// horizon, "THICKNESS_TWT" an attribute as is anything else.
ColumnRole RoleOfName(std::string_view name);

/// The same by names that leave no doubt; Attribute where words alone would tell.
ColumnRole RoleOfExactName(std::string_view name);

/// Whether a name is that of something else than z for certain, such as an amplitude or the number of a line.
bool IsNeverZ(std::string_view name);

/// Which of some names that mean Z it is: the one that is just that. Throws InputError, which says what to set, where
/// there is none and they differ.
std::size_t ChooseZ(const std::vector<std::string>& names, const char* remedy);
}

#endif
