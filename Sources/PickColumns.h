// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsPickColumns_h
#define SeismicHorizonsPickColumns_h

#include "Common/Survey/ColumnRole.h"
#include "Common/Survey/NullValues.h"
#include "Common/Survey/PickTable.h"

#include <map>
#include <string>

class vtkDataObject;

namespace SeismicHorizons
{
/// Array names by role; roles not listed are found by the usual names.
using ColumnChoice = std::map<ColumnRole, std::string>;

/// Coordinates of points are used unless an array is chosen for x, y or z. Ghost points are skipped. Throws InputError
/// without a chosen array, z or places, and on infinite places.
PickTable MakePickTable(vtkDataObject* data, const ColumnChoice& choice, const NullValues& nulls);
}

#endif
