// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef PluginStart_h
#define PluginStart_h

/// Has an effect if VTK was built for one thread and the environment sets no backend (VTK_SMP_BACKEND_IN_USE;
/// VTK_SMP_MAX_THREADS limits the threads). Of several processes each keeps to one processor.
void UseAllProcessors();

/// Updates information properties of a stage after each run. ParaView reads them before a run, and would show the
/// previous results.
void KeepResultsFresh();

/// Reads old property names from state files, with a warning; new names take precedence. An alias in the XML would set
/// its default whenever a proxy is created.
void ReadRenamedProperties();

#endif
