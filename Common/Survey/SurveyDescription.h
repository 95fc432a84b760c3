// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSurveyDescription_h
#define SeismicHorizonsSurveyDescription_h

#include <string>

namespace SeismicHorizons
{
/// Unknown texts are empty; nothing is guessed.
struct SurveyDescription
{
  std::string VerticalUnit; // "ms", "s", "m", "ft", or the text of the file.
  std::string VerticalDomain; // "time" or "depth"
  std::string HorizontalUnit; // "m", "ft", or the text of the file
  std::string CoordinateSystem;
  bool IsUpright = false; // z increases upwards for certain.
};
}

#endif
