// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextFields.h"

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
bool IsEndMark(std::string_view line)
{
  const std::string_view word = Trim(line);
  return word == "EOB" || word == "EOD" || word == "EOF";
}
}
