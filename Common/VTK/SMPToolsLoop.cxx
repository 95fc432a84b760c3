// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Common/Base/Parallel.h"

#include <vtkSMPTools.h>

namespace SeismicHorizons
{
namespace Detail
{
//----------------------------------------------------------------------------------------------------------------------
int MostThreads()
{
  return vtkSMPTools::GetEstimatedNumberOfThreads();
}

//----------------------------------------------------------------------------------------------------------------------
void RunOnThreads(std::int64_t size, std::int64_t grain, const std::function<void(std::int64_t, std::int64_t)>& range)
{
  const auto run = [&range](vtkIdType first, vtkIdType last) { range(first, last); };
  vtkSMPTools::For(0, vtkIdType(size), vtkIdType(grain), run);
}
}
}
