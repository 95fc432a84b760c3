// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsTextHeader_h
#define SeismicHorizonsTextHeader_h

#include "NameLine.h"
#include "TextLayout.h"

#include <string_view>
#include <vector>

namespace SeismicHorizons
{
/// Columns is empty without names. HeaderLines is the index of the first line after the header.
TextLayout ReadTextHeader(const TextLines& lines);
}

#endif
