// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What stages tell about their last run, in panels and scripts.

#ifndef FreshResults_h
#define FreshResults_h

/// Reads the results of a stage after each of its runs. ParaView itself reads information properties before a source
/// runs, and would show those of the run before.
void KeepResultsFresh();

#endif
