// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// VTK classes report an InputError by Common/VTK/PipelineRequest.h; programs print its text.

#ifndef SeismicHorizonsErrors_h
#define SeismicHorizonsErrors_h

#include <stdexcept>
#include <string>

namespace SeismicHorizons
{
/// The message names the finding, the expectation and the place.
class InputError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Adds `name` to the front of InputErrors.
template <typename Work>
auto PrefixErrors(const std::string& name, Work&& work)
{
  try
  {
    return work();
  }
  catch (const InputError& error)
  {
    throw InputError(name + ": " + error.what());
  }
}

/// Work stopped on request (Monitor.h). The caller returns an empty result without an error.
class Aborted : public std::exception
{
public:
  /// Says that work was stopped.
  const char* what() const noexcept override { return "stopped on request"; }
};
}

#endif
