// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How algorithms answer a request of the pipeline: what goes wrong becomes one error and an empty output.

#ifndef SeismicHorizonsPipelineRequest_h
#define SeismicHorizonsPipelineRequest_h

#include "Common/Monitor.h"

#include <functional>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;

namespace SeismicHorizons
{
/// What an algorithm does on a request. It may set `subject` to the name that an error begins with, as
/// "Horizon 7".
using RequestWork = std::function<void(std::string& subject, const Monitor& monitor)>;

/// Runs the work and gives what the request has to return: 1, or 0 after an error. An InputError that the work throws
/// becomes one error of `algorithm`; so does a lack of memory, with the text `noMemory`. Both leave all outputs empty,
/// and so does a request to stop, which is no error. Outputs may be null.
int RunRequest(vtkAlgorithm* algorithm, const std::vector<vtkDataObject*>& outputs, const std::string& noMemory,
  const RequestWork& work);
}

#endif
