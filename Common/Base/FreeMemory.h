// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsFreeMemory_h
#define SeismicHorizonsFreeMemory_h

#include <cstdlib> // defines __GLIBC__
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace SeismicHorizons
{
/// Returns freed memory to the system, which std::free keeps between what is still in use.
inline void ReturnFreeMemory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}
}

#endif
