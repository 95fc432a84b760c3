// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How fuzz targets say what does not hold: libFuzzer keeps the input of a program that aborts.

#ifndef SeismicHorizonsRequire_h
#define SeismicHorizonsRequire_h

#include "Common/Base/Errors.h"

#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>

namespace Fuzz
{
inline void Require(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "PROPERTY " << what << std::endl;
    std::abort();
  }
}

/// For checkers that give what is wrong, or an empty text.
inline void RequireNothing(const std::string& wrong, const std::string& where)
{
  Require(wrong.empty(), where + ": " + wrong);
}

/// What `work` gives, or nothing when it refuses its input, which it has to do just when that is not valid.
template <typename Work>
auto RunOn(bool isValid, const std::string& name, Work&& work) -> std::optional<decltype(work())>
{
  try
  {
    std::optional<decltype(work())> result = work();
    Require(isValid, name + ": took options out of range");
    return result;
  }
  catch (const SeismicHorizons::InputError& error)
  {
    Require(!isValid, name + ": refused, " + error.what());
    return {};
  }
}
}

#endif
