// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsFieldSeparator_h
#define SeismicHorizonsFieldSeparator_h

namespace SeismicHorizons
{
/// How the fields of a line are told apart.
enum class FieldSeparator
{
  Blanks, ///< any number of blanks and tabs
  Colons, ///< the same, or colons
  Tab,
  Comma,
  Semicolon
};
}

#endif
