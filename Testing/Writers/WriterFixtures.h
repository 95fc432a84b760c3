// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Picks to write, and the comparison with the horizon that is read again.

#ifndef SeismicHorizonsWriterFixtures_h
#define SeismicHorizonsWriterFixtures_h

#include "Readers/FileFixtures.h"
#include "Tools/Check.h"

#include "vtkHorizonTextReader.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace WriterFixtures
{
using namespace FileFixtures;

/// The folder for files of this test.
inline std::string Folder;

/// Picks of a turned survey, inlines 100 to 110 in steps of 2 and crosslines 7 to 12, on a plane; of `missing` inside
/// there is none.
inline std::string MakePicks(const std::string& name, bool isComplete)
{
  std::string text;
  for (int j = 0; j < 6; ++j)
  {
    for (int i = 0; i < 6; ++i)
    {
      if (isComplete || i != 3 || j != 2)
      {
        const double x = 604321.25 + 12.0 * i - 9.0 * j;
        const double y = 6079543.5 + 9.0 * i + 12.0 * j;
        const double z = 1500.0 + 2.0 * i + 0.5 * j;
        text += name + '\t' + std::to_string(100 + 2 * j) + '\t' + std::to_string(7 + i) + '\t' + std::to_string(x) +
          '\t' + std::to_string(y) + '\t' + std::to_string(z) + '\t' + std::to_string(i * j) + '\n';
      }
    }
  }
  return text;
}

inline vtkSmartPointer<vtkHorizonTextReader> ReadPicks(const std::string& text)
{
  auto reader = vtkSmartPointer<vtkHorizonTextReader>::New();
  reader->SetFileName(WriteText(Folder + "/picks.dat", text).c_str());
  reader->Update();
  return reader;
}

/// The points of two horizons are at the same places, in the same order.
inline void CheckSamePlaces(vtkPolyData* a, vtkPolyData* b, double nearness)
{
  CHECK_EQUAL(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  for (vtkIdType point = 0; point < std::min(a->GetNumberOfPoints(), b->GetNumberOfPoints()); ++point)
  {
    const double* const place = a->GetPoint(point);
    double other[3];
    b->GetPoint(point, other);
    CHECK(std::hypot(place[0] - other[0], place[1] - other[1]) < nearness);
    CHECK(std::abs(place[2] - other[2]) < 1e-9);
  }
}

inline void CheckSamePoints(vtkPolyData* a, vtkPolyData* b)
{
  CheckSamePlaces(a, b, 1e-6);
}
}

#endif
