// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PipelineRequest.h"

#include "ProgressMonitor.h"

#include "vtkDataObject.h"

#include <new>
#include <stdexcept>

namespace SeismicHorizons
{
namespace
{
void Empty(const std::vector<vtkDataObject*>& outputs)
{
  for (vtkDataObject* output : outputs)
  {
    if (output)
    {
      output->Initialize();
    }
  }
}
}

//----------------------------------------------------------------------------------------------------------------------
int RunRequest(vtkAlgorithm* algorithm, const std::vector<vtkDataObject*>& outputs, const std::string& noMemory,
  const RequestWork& work, const Ranks& ranks)
{
  std::string subject;
  std::string problem;
  bool isDone = false;
  try
  {
    work(subject, MakeMonitor(algorithm));
    isDone = true;
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
  if (ranks.Any(!isDone))
  {
    Empty(outputs);
  }
  if (problem.empty())
  {
    return 1;
  }
  vtkErrorWithObjectMacro(algorithm, << subject << (subject.empty() ? "" : ": ") << problem);
  return 0;
}

//----------------------------------------------------------------------------------------------------------------------
void RunPart(vtkAlgorithm* algorithm, bool mayLeaveOut, const std::string& subject,
  const std::vector<vtkDataObject*>& outputs, const std::function<void()>& work)
{
  try
  {
    work();
  }
  catch (const InputError& error)
  {
    if (!mayLeaveOut)
    {
      throw;
    }
    Empty(outputs);
    vtkWarningWithObjectMacro(
      algorithm, << (subject.empty() ? "a horizon" : subject) << " is left out: " << error.what());
  }
}
}
