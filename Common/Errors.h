// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What algorithms and parsers throw. VTK classes turn an InputError into an error of VTK
// (Common/VTK/PipelineRequest.h), programs print its text.

#ifndef SeismicHorizonsErrors_h
#define SeismicHorizonsErrors_h

#include <stdexcept>
#include <string>

namespace SeismicHorizons
{
/// Input that a stage cannot work on. The message says what was found, what was expected, and where.
class InputError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Runs `work` so that the InputErrors it throws begin with `name`, and gives what it returns.
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

/// The end of work that was asked to stop (Monitor.h). The caller returns an empty result, and reports no error.
class Aborted : public std::exception
{
public:
  /// For logs alone: nobody is told of work that was asked to stop.
  const char* what() const noexcept override { return "stopped on request"; }
};
}

#endif
