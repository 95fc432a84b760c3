// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsDuplicatePolicy_h
#define SeismicHorizonsDuplicatePolicy_h

namespace SeismicHorizons
{
enum class DuplicatePolicy
{
  StrongestAmplitude, ///< The largest absolute amplitude; the topmost if equal.
  Topmost,
  Lowest,
  Sheets, ///< All, as separate horizons (ColumnSheets.h).
  Mean ///< Means of z and of each attribute, without null values.
};
}

#endif
