// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PipelineRequest.h"

#include "Common/Survey/ImageFrame.h"
#include "Common/Text/FileErrors.h"
#include "VersionDifferences.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <stdexcept>
#include <system_error>
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

struct Outcome
{
  bool IsDone = false;
  std::string Problem; // empty if done or stopped
  unsigned long Code = vtkErrorCode::UnknownError;
};

unsigned long CodeOf(const InputError& error)
{
  const auto* const ofFile = dynamic_cast<const FileError*>(&error);
  if (!ofFile)
  {
    return vtkErrorCode::UnknownError;
  }
  switch (ofFile->Problem())
  {
    case FileProblem::NoName:
      return vtkErrorCode::NoFileNameError;
    case FileProblem::NotFound:
      return vtkErrorCode::FileNotFoundError;
    case FileProblem::CannotOpen:
      return vtkErrorCode::CannotOpenFileError;
    case FileProblem::CutOff:
      return vtkErrorCode::PrematureEndOfFileError;
    case FileProblem::WrongContent:
      return vtkErrorCode::FileFormatError;
    case FileProblem::NoRoom:
      return vtkErrorCode::OutOfDiskSpaceError;
  }
  return vtkErrorCode::UnknownError;
}

Monitor MakeMonitor(vtkAlgorithm* algorithm)
{
  return Monitor(
    [algorithm](double part)
    {
      algorithm->UpdateProgress(part);
      return !IsAborted(algorithm);
    });
}

Outcome Run(vtkAlgorithm* algorithm, const std::string& noMemory, const RequestWork& work, std::string& subject)
{
  try
  {
    work(subject, MakeMonitor(algorithm));
    return { true, {}, vtkErrorCode::NoError };
  }
  catch (const Aborted&)
  {
    return {};
  }
  catch (const InputError& error)
  {
    // A stopped stage upstream leaves empty data, which are no wrong input.
    return IsAborted(algorithm) ? Outcome() : Outcome{ false, error.what(), CodeOf(error) };
  }
  catch (const std::bad_alloc&)
  {
    return { false, noMemory };
  }
  catch (const std::length_error&) // The size exceeds any memory.
  {
    return { false, noMemory };
  }
  catch (const std::system_error& error) // A thread cannot start, or a file vanished.
  {
    return { false,
      "the system reports \"" + std::string(error.what()) + "\", expected enough threads and files for this" };
  }
  catch (const std::exception& error)
  {
    return { false, "internal error \"" + std::string(error.what()) + "\", expected none: please report it" };
  }
}

vtkCommand* OtherErrors();

/// Is called for one error.
void TellOtherError(vtkObject* executive, unsigned long event, void*, void* text)
{
  executive->RemoveObservers(event, OtherErrors());
  const auto* const message = static_cast<const char*>(text);
  if (message && !std::strstr(message, "returned failure for request"))
  {
    vtkOutputWindow::GetInstance()->DisplayErrorText(message);
  }
}

vtkCommand* OtherErrors()
{
  static const vtkSmartPointer<vtkCallbackCommand> command = []()
  {
    auto made = vtkSmartPointer<vtkCallbackCommand>::New();
    made->SetCallback(TellOtherError);
    return made;
  }();
  return command;
}

/// VTK reports a second error, that the algorithm has failed, which is of no use to anyone.
void KeepOneError(vtkAlgorithm* algorithm)
{
  if (!algorithm->GetExecutive()->HasObserver(vtkCommand::ErrorEvent, OtherErrors()))
  {
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, OtherErrors());
  }
}

bool IsFirst(const std::vector<std::string>& problems, int rank)
{
  const auto own = problems.begin() + rank;
  return !own->empty() && std::find(problems.begin(), own, *own) == own;
}

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
  const RequestWork& work, const Ranks& ranks, unsigned long* errorCode)
{
  std::string subject;
  const Outcome outcome = Run(algorithm, noMemory, work, subject);
  const bool areAllDone = !ranks.Any(!outcome.IsDone);
  if (errorCode)
  {
    *errorCode = outcome.IsDone && !areAllDone ? Outcome().Code : outcome.Code;
  }
  if (areAllDone)
  {
    return 1;
  }
  Empty(outputs);
  const std::string& problem = outcome.Problem;
  const std::vector<std::string> problems =
    ranks.Gather(problem.empty() || subject.empty() ? problem : subject + ": " + problem);
  if (IsFirst(problems, ranks.Own()))
  {
    vtkErrorWithObjectMacro(algorithm, << problems[ranks.Own()]);
  }
  const bool areStopped =
    std::all_of(problems.begin(), problems.end(), [](const std::string& other) { return other.empty(); });
  if (!areStopped)
  {
    KeepOneError(algorithm);
  }
  return areStopped;
}

//----------------------------------------------------------------------------------------------------------------------
RequestWork WatchInformation(vtkAlgorithm* algorithm, bool& isStopped, RequestWork work)
{
  return [&isStopped, algorithm, work = std::move(work)](std::string& subject, const Monitor& monitor)
  {
    isStopped = false;
    MarkAborted(algorithm, false); // CheckAbort would repeat the state of an earlier request.
    try
    {
      work(subject, monitor);
    }
    catch (const Aborted&)
    {
      isStopped = true;
      throw;
    }
  };
}

//----------------------------------------------------------------------------------------------------------------------
void StopLikeInformation(vtkAlgorithm* algorithm, bool& isStopped)
{
  if (std::exchange(isStopped, false))
  {
    MarkAborted(algorithm, true);
    throw Aborted();
  }
}

//----------------------------------------------------------------------------------------------------------------------
bool IsForTime(vtkInformation* request)
{
  return request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_TIME_DEPENDENT_INFORMATION()) != 0;
}

//----------------------------------------------------------------------------------------------------------------------
RequestWork AnnounceLater(vtkInformation* request, RequestWork work)
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
      return; // The request for data fails, too, and explains the error.
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
  outputInformation->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
}

//----------------------------------------------------------------------------------------------------------------------
void AnnounceImage(const std::array<int, 6>& extent, const ImageFrame& frame, vtkInformation* outputInformation)
{
  AnnounceExtent(extent, outputInformation);
  outputInformation->Set(vtkDataObject::ORIGIN(), frame.Origin.data(), 3);
  outputInformation->Set(vtkDataObject::SPACING(), frame.Spacing.data(), 3);
  outputInformation->Set(vtkDataObject::DIRECTION(), frame.Direction.data(), 9);
}

//----------------------------------------------------------------------------------------------------------------------
void AskForWhole(vtkInformationVector* port, int first)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (int n = first; n < port->GetNumberOfInformationObjects(); ++n)
  {
    vtkInformation* const input = port->GetInformationObject(n);
    input->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
    input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    if (input->Has(Pipeline::WHOLE_EXTENT()))
    {
      input->Set(Pipeline::UPDATE_EXTENT(), input->Get(Pipeline::WHOLE_EXTENT()), 6);
    }
  }
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
