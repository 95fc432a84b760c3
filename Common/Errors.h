// SPDX-FileCopyrightText: Copyright (c) SeismicHorizons contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// How the algorithms refuse work: one exception type each for input that breaks a contract and for a stop that was
// asked for. Whoever calls an algorithm turns them into its own kind of message.

#ifndef SeismicHorizonsErrors_h
#define SeismicHorizonsErrors_h

#include <stdexcept>
#include <string>

namespace SeismicHorizons
{
/// The input breaks the contract of a stage. The message says what was found, what was expected and where.
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

/// The monitor asked to stop. Not a failure: the caller leaves an empty result behind.
class Aborted : public std::exception
{
public:
  const char* what() const noexcept override { return "stopped on request"; }
};
}

#endif
