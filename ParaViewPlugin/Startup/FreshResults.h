// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef FreshResults_h
#define FreshResults_h

/// Updates information properties of a stage after each run. ParaView reads them before a run, and would show the
/// previous results.
void KeepResultsFresh();

#endif
