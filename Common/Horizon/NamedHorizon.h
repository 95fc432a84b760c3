// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsNamedHorizon_h
#define SeismicHorizonsNamedHorizon_h

#include "Horizon.h"

#include <cstdint>
#include <string>
#include <vector>

namespace SeismicHorizons
{
struct NamedHorizon
{
  std::string Name; // for messages and files
  Horizon Data;
};

std::vector<std::string> NamesOf(const std::vector<NamedHorizon>& horizons);

std::string HorizonName(std::int64_t surfaceId);

/// Repeated names get " (2)", " (3)" and so on.
std::vector<std::string> MakeDistinct(std::vector<std::string> names);
}

#endif
