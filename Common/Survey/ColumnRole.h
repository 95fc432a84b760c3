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

const char* RoleWord(ColumnRole role);

/// Recognises names such as "Easting (m)" for X, "IL" for Inline, "Depth" for Z and "-" for Ignored, or words within
/// names: "HORIZON_TWT" is Z, "POINT_X" X, "Formation" a name; "THICKNESS_TWT" and unknown names are attributes.
ColumnRole RoleOfName(std::string_view name);

ColumnRole RoleOfExactName(std::string_view name);

/// Amplitudes and line numbers are never z.
bool IsNeverZ(std::string_view name);

/// Throws InputError, which ends with `remedy`, if no name is exactly a z and the names differ.
std::size_t ChooseZ(const std::vector<std::string>& names, const char* remedy);
}

#endif
