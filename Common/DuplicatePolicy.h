// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsDuplicatePolicy_h
#define SeismicHorizonsDuplicatePolicy_h

namespace SeismicHorizons
{
/// Which voxel or point is kept when a horizon has several in one column; or that all are, or their mean.
enum class DuplicatePolicy
{
  StrongestAmplitude, ///< the largest absolute amplitude; of equal ones the topmost
  Topmost,
  Lowest,
  Sheets, ///< all, on sheets that are horizons of their own (ColumnSheets.h)
  Mean ///< that of z and of attributes, each over the values that there are
};
}

#endif
