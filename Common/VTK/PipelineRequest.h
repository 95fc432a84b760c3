// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Runs the work of pipeline requests; failures give one error and an empty output.
//
// Exceptions become one error of the algorithm, and a vtkErrorCode. Errors and stops empty the outputs. If one rank
// fails, all outputs are emptied and all ranks return 0; the first rank reports a common error.

#ifndef SeismicHorizonsPipelineRequest_h
#define SeismicHorizonsPipelineRequest_h

#include "Common/Base/Monitor.h"
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

/// `subject` may be set to a name for errors, such as "Horizon 7".
using RequestWork = std::function<void(std::string& subject, const Monitor& monitor)>;

/// Returns 1, or 0 after an error. `noMemory` is the text for lack of memory. Outputs may be null. `errorCode` must be
/// the algorithm's member, since its setter would mark the algorithm as modified. Collective.
int RunRequest(vtkAlgorithm* algorithm, const std::vector<vtkDataObject*>& outputs, const std::string& noMemory,
  const RequestWork& work, const Ranks& ranks = Ranks(), unsigned long* errorCode = nullptr);

/// In a file series the requested time may belong to another file than the current information.
bool IsForTime(vtkInformation* request);

/// VTK forgets that work on information was stopped, and requests data without an extent.
RequestWork WatchInformation(vtkAlgorithm* algorithm, bool& isStopped, RequestWork work);

/// Throws Aborted if work on information was stopped.
void StopLikeInformation(vtkAlgorithm* algorithm, bool& isStopped);

/// The request for data reports an InputError on information for a certain time.
RequestWork AnnounceLater(vtkInformation* request, RequestWork work);

/// Subsets of the extent can be requested. Requests for the whole previous extent, or beyond this extent, become
/// requests for all of it, because they precede information on files of other times.
void AnnounceExtent(const std::array<int, 6>& extent, vtkInformation* outputInformation);

void AnnounceImage(const std::array<int, 6>& extent, const ImageFrame& frame, vtkInformation* outputInformation);

/// Requests the whole input, from a connection on, whatever piece or extent is requested of the output.
void AskForWhole(vtkInformationVector* port, int first = 0);

/// With `mayLeaveOut` an InputError becomes a warning, and only these outputs are emptied.
void RunPart(vtkAlgorithm* algorithm, bool mayLeaveOut, const std::string& subject,
  const std::vector<vtkDataObject*>& outputs, const std::function<void()>& work);
}

#endif
