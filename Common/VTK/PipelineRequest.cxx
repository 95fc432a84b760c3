// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PipelineRequest.h"

#include "ProgressMonitor.h"

#include "vtkDataObject.h"

#include <new>
#include <stdexcept>

namespace SeismicHorizons
{
//----------------------------------------------------------------------------------------------------------------------
int RunRequest(vtkAlgorithm* algorithm, const std::vector<vtkDataObject*>& outputs, const std::string& noMemory,
  const RequestWork& work)
{
  std::string subject;
  std::string problem;
  try
  {
    work(subject, MakeMonitor(algorithm));
    return 1;
  }
  catch (const Aborted&)
  {
  }
  catch (const InputError& error)
  {
    problem = error.what();
  }
  catch (const std::bad_alloc&)
  {
    problem = noMemory;
  }
  catch (const std::length_error&) // more than any memory could hold
  {
    problem = noMemory;
  }
  for (vtkDataObject* output : outputs)
  {
    if (output)
    {
      output->Initialize();
    }
  }
  if (problem.empty())
  {
    return 1;
  }
  vtkErrorWithObjectMacro(algorithm, << subject << (subject.empty() ? "" : ": ") << problem);
  return 0;
}
}
