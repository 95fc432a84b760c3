// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PipelineRequest.h"

#include "ProgressMonitor.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <new>
#include <stdexcept>
#include <utility>

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

/// Whether a rank has a problem that none before it has.
bool IsFirst(const std::vector<std::string>& problems, int rank)
{
  const auto own = problems.begin() + rank;
  return !own->empty() && std::find(problems.begin(), own, *own) == own;
}

/// Whether an extent has points, and all of them are in another.
bool IsWithin(const int* part, const std::array<int, 6>& whole)
{
  bool isWithin = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int first = part[2 * axis];
    const int last = part[2 * axis + 1];
    isWithin = isWithin && first <= last && first >= whole[2 * axis] && last <= whole[2 * axis + 1];
  }
  return isWithin;
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
    // A stage upstream that was stopped leaves nothing, which is no wrong input.
    problem = IsAborted(algorithm) ? std::string() : error.what();
  }
  catch (const std::bad_alloc&)
  {
    problem = noMemory;
  }
  catch (const std::length_error&) // more than any memory could hold
  {
    problem = noMemory;
  }
  if (!ranks.Any(!isDone))
  {
    return 1;
  }
  Empty(outputs);
  problem = problem.empty() || subject.empty() ? problem : subject + ": " + problem;
  const std::vector<std::string> problems = ranks.Gather(problem);
  if (IsFirst(problems, ranks.Own()))
  {
    vtkErrorWithObjectMacro(algorithm, << problem);
  }
  return std::all_of(problems.begin(), problems.end(), [](const std::string& other) { return other.empty(); });
}

//----------------------------------------------------------------------------------------------------------------------
bool IsForTime(vtkInformation* request)
{
  return request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_TIME_DEPENDENT_INFORMATION()) != 0;
}

//----------------------------------------------------------------------------------------------------------------------
RequestWork TellLater(vtkInformation* request, RequestWork work)
{
  if (!IsForTime(request))
  {
    return work;
  }
  return [work = std::move(work)](std::string& subject, const Monitor& monitor)
  {
    try
    {
      work(subject, monitor);
    }
    catch (const InputError&)
    {
      return; // the data will not come either, and that says why
    }
  };
}

//----------------------------------------------------------------------------------------------------------------------
void AnnounceExtent(const std::array<int, 6>& extent, vtkInformation* outputInformation)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (outputInformation->Has(Pipeline::UPDATE_EXTENT()))
  {
    const int* const asked = outputInformation->Get(Pipeline::UPDATE_EXTENT());
    const int* const told = outputInformation->Get(Pipeline::WHOLE_EXTENT());
    const bool wasWhole = !told || std::equal(told, told + 6, asked);
    if (wasWhole || !IsWithin(asked, extent))
    {
      outputInformation->Set(Pipeline::UPDATE_EXTENT(), extent.data(), 6);
    }
  }
  outputInformation->Set(Pipeline::WHOLE_EXTENT(), extent.data(), 6);
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
