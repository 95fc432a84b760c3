// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How much more a horizon rises across each link than around it, and how large that is by noise alone.

#ifndef SeismicHorizonsLinkDeviations_h
#define SeismicHorizonsLinkDeviations_h

#include "ColumnHeights.h"
#include "Common/Monitor.h"
#include "Common/RawVector.h"

namespace SeismicHorizons
{
/// By link: the height beyond it minus that before it, less the median of such differences across the links of the same
/// side within three columns, which is the dip. Nan where one of the two columns is missing.
RawVector<float> FindDeviations(const ColumnHeights& heights, const Monitor& monitor);

/// The standard deviation of noise in deviations: 1.4826 times the median of their sizes. Of whole heights that is the
/// median of groups, which lies between the whole numbers, and the result at least what rounding does to differences.
/// Of others, where the median is next to nothing, as in data that were smoothed or rounded, the mean of small sizes
/// tells.
double MeasureNoise(const RawVector<float>& deviations, bool areHeightsWhole);
}

#endif
