// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#ifndef SeismicHorizonsArrayRanges_h
#define SeismicHorizonsArrayRanges_h

class vtkDataArray;

namespace SeismicHorizons
{
/// Finds the ranges of a large array in one pass on all threads, and stores them where VTK keeps those that it has found:
/// ParaView asks for six of each array, and VTK's passes take longer than most stages. Arrays with infinite
/// values are left to VTK, as are small ones, and those whose ranges are known.
void FindRanges(vtkDataArray* array);
}

#endif
