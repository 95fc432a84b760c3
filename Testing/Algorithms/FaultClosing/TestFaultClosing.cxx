// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ClosedFaults.h"
#include "Tools/Check.h"
int TestFaultClosing(int, char*[])
{
  return Check::Result();
}
