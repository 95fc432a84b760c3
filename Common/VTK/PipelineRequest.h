// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How algorithms answer a request of the pipeline: what goes wrong becomes one error and an empty output.

#ifndef SeismicHorizonsPipelineRequest_h
#define SeismicHorizonsPipelineRequest_h

#include "Common/Monitor.h"
#include "Ranks.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;
class vtkInformation;
class vtkInformationVector;

namespace SeismicHorizons
{
struct ImageFrame;

/// What an algorithm does on a request. It may set `subject` to the name that an error begins with, as
/// "Horizon 7".
using RequestWork = std::function<void(std::string& subject, const Monitor& monitor)>;

/// Runs the work and gives what the request has to return: 1, or 0 after an error. What the work throws becomes one
/// error of `algorithm`, a lack of memory one with the text `noMemory`. All of them leave the outputs empty, and so
/// does a request to stop, which is no error. Outputs may be null. `errorCode`, that of a reader or writer, becomes the
/// vtkErrorCode of what happened; the member of the algorithm, as setting it would mark the algorithm as changed.
///
/// What empties the outputs of one rank empties those of all, and where one has to return 0 all do, so that all go on
/// or none does. An error that several have is reported by the first of them. Collective.
int RunRequest(vtkAlgorithm* algorithm, const std::vector<vtkDataObject*>& outputs, const std::string& noMemory,
  const RequestWork& work, const Ranks& ranks = Ranks(), unsigned long* errorCode = nullptr);

/// Whether a request is for the information of a certain time: in a series, another file may have that time than the
/// one that the information was taken from.
bool IsForTime(vtkInformation* request);

/// Work on information, which keeps in `isStopped` whether it was stopped. VTK forgets that before it asks for data,
/// whose extent nobody has told it then.
RequestWork WatchInformation(vtkAlgorithm* algorithm, bool& isStopped, RequestWork work);

/// To be called in work on data: throws Aborted where the work on information before it was stopped.
void StopLikeInformation(vtkAlgorithm* algorithm, bool& isStopped);

/// Work on information that keeps an InputError to itself where the request is for that of a certain time, as the
/// request for data that follows tells it.
RequestWork TellLater(vtkInformation* request, RequestWork work);

/// Tells the extent of the points there will be, of which parts can be asked for. Where all of the one told before is
/// asked for, or what is not in this one, all of this one is: extents are asked for before files of other times are
/// looked at.
void AnnounceExtent(const std::array<int, 6>& extent, vtkInformation* outputInformation);

/// Tells the extent and place of the image there will be.
void AnnounceImage(const std::array<int, 6>& extent, const ImageFrame& frame, vtkInformation* outputInformation);

/// Asks for the input of a port whole, whatever piece or extent of the output is asked for. Does nothing without one.
void AskForWhole(vtkInformationVector* port);

/// Runs the part of the work that concerns `subject`. With `mayLeaveOut` an InputError that it throws becomes a warning
/// of `algorithm` and leaves the outputs of this part empty, and the work goes on.
void RunPart(vtkAlgorithm* algorithm, bool mayLeaveOut, const std::string& subject,
  const std::vector<vtkDataObject*>& outputs, const std::function<void()>& work);
}

#endif
