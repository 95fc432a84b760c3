// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsPickArrays_h
#define SeismicHorizonsPickArrays_h

#include "Common/Horizon/DataArray.h"
#include "Common/Survey/FieldRole.h"
#include "Common/Survey/NullValues.h"
#include "Common/Survey/PickTable.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace SeismicHorizons
{
/// A table, or the points of a dataset.
struct PickArrays
{
  ArrayTable Arrays;
  std::optional<DataArray> Points; // coordinates
  std::int64_t Rows = 0;
};

/// Array names by role; roles not listed are found by the usual names.
using ColumnChoice = std::map<FieldRole, std::string>;

/// Coordinates of points are used unless an array is chosen for x, y or z. Ghost points are skipped. Throws InputError
/// without a chosen array, z or places, and on infinite places.
PickTable MakePickTable(const PickArrays& picks, const ColumnChoice& choice, const NullValues& nulls);
}

#endif
