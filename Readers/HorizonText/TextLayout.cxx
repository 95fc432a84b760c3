// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextLayout.h"

#include "FieldNames.h"

#include <algorithm>
#include <array>

namespace SeismicHorizons
{
namespace
{
constexpr std::array<const char*, 9> KindNames = { "plain text", "OpendTect", "OpenWorks", "EarthVision",
  "Petrel points with attributes", "RMS attributes", "Charisma", "lattice indices", "IESX" };
constexpr std::array<const char*, 5> SeparatorNames = { "blanks", "blanks and colons", "tabs", "commas", "semicolons" };
}

//----------------------------------------------------------------------------------------------------------------------
int TextLayout::Find(FieldRole role) const
{
  const auto found = std::find_if(
    this->Columns.begin(), this->Columns.end(), [role](const TextColumn& column) { return column.Role == role; });
  return found == this->Columns.end() ? -1 : int(found - this->Columns.begin());
}

//----------------------------------------------------------------------------------------------------------------------
std::string TextLayout::Describe() const
{
  std::string text = KindNames[std::size_t(this->Kind)];
  if (this->Kind != TextKind::Iesx)
  {
    text += std::string(", separated by ") + SeparatorNames[std::size_t(this->Separator)];
  }
  return text + ": " + ListNames(this->Columns);
}
}
