// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How many processors a process of ParaView uses that has loaded the plugin.

#ifndef Processors_h
#define Processors_h

/// Takes all of them, where VTK was built to take one and nobody has said otherwise in the environment
/// (VTK_SMP_BACKEND_IN_USE; VTK_SMP_MAX_THREADS takes fewer). One of several processes stays with its own processor.
void UseAllProcessors();

#endif
