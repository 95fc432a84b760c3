// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsSurveyDescription_h
#define SeismicHorizonsSurveyDescription_h

#include <string>

namespace SeismicHorizons
{
/// What a file, or its user, says of its coordinates. Texts are empty where nothing is said: nothing is guessed.
struct SurveyDescription
{
  std::string VerticalUnit; // "ms", "s", "m" or "ft"; anything else as the file has it
  std::string VerticalDomain; // "time" or "depth"
  std::string HorizontalUnit; // "m" or "ft"; anything else as the file has it
  std::string CoordinateSystem; // its name, passed through
  bool IsUpright = false; // z counts upwards for certain, as elevations do
};
}

#endif
