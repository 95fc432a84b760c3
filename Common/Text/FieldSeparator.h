// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsFieldSeparator_h
#define SeismicHorizonsFieldSeparator_h

namespace SeismicHorizons
{
enum class FieldSeparator
{
  Blanks,
  Colons, ///< Blanks, tabs and colons.
  Tab,
  Comma,
  Semicolon
};
}

#endif
