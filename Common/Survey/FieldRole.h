// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsFieldRole_h
#define SeismicHorizonsFieldRole_h

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace SeismicHorizons
{
enum class FieldRole
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

const char* RoleWord(FieldRole role);

/// Recognises names such as "Easting (m)" for X, "IL" for Inline, "Depth" for Z, "-" and "_" for Ignored, or words within
/// names: "HORIZON_TWT" is Z, "POINT_X" X, "Formation" a name; "THICKNESS_TWT" and unknown names are attributes.
FieldRole RoleOfName(std::string_view name);

FieldRole RoleOfExactName(std::string_view name);

/// Amplitudes and line numbers are never z.
bool IsNeverZ(std::string_view name);

/// Throws InputError, which ends with `remedy`, if no name is exactly a z and the names differ.
std::size_t ChooseZ(const std::vector<std::string>& names, const char* remedy);
}

#endif
