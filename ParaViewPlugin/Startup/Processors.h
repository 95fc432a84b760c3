// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef Processors_h
#define Processors_h

/// Has an effect if VTK was built for one thread and the environment sets no backend (VTK_SMP_BACKEND_IN_USE;
/// VTK_SMP_MAX_THREADS limits the threads). Of several processes each keeps to one processor.
void UseAllProcessors();

#endif
